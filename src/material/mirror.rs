//! The mirror.
//!
//! ```
//! use raybook::material::mirror::reflect;
//! use raybook::prelude::*;
//!
//! let down = Dir3::new(vec3(3.0, -4.0, 0.0)).expect("longer than 0");
//! let up = reflect(down, Dir3::Y);
//! assert!((up.x - down.x).abs() < 1e-6 && (up.y + down.y).abs() < 1e-6);
//! ```

use crate::image::rgb::Rgb;
use crate::material::{Delta, Material, glass::Medium};
use crate::math::dir3::Dir3;
use crate::shape::Surface;

/// A perfectly smooth surface: every ray leaves in one direction only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirror {
    /// The share of the light that is reflected, per channel, at most 1; for example 0.96, 0.95, 0.92 for silver.
    pub share: Rgb,
}

// ANCHOR: reflect
/// m = i − 2 (i·n) n: the mirror direction of i. i points to the surface; n may point to either side.
///
/// The part of i that is parallel to the surface stays, and the perpendicular part, (i·n) n, changes its sign.
pub fn reflect(incoming: Dir3, normal: Dir3) -> Dir3 {
    let reflected = *incoming - 2.0 * incoming.dot(*normal) * *normal;
    Dir3::new_or(reflected, -incoming)
}
// ANCHOR_END: reflect

impl Material for Mirror {
    // ANCHOR: mirror
    /// One mirrored ray, with the mirror's share.
    ///
    /// At a grazing angle, an interpolated normal may send the ray below the surface; then the geometric normal is used.
    fn delta_lobes(&self, at: &Surface, view: Dir3, visit: &mut dyn FnMut(Delta)) {
        let side = |d: Dir3| at.normal.dot(*d) < 0.0;
        let mut toward = reflect(-view, at.shading_normal);
        if side(toward) != side(view) {
            toward = reflect(-view, at.normal);
        }
        visit(Delta {
            toward,
            share: self.share,
            medium: Medium::AIR,
        });
    }
    // ANCHOR_END: mirror

    fn scatters(&self, _at: &Surface) -> bool {
        false
    }
}

//! The mirror.

use crate::image::rgb::Rgb;
use crate::light::LightSample;
use crate::material::{Material, See};
use crate::math::dir3::Dir3;
use crate::shape::Surface;

/// A surface so smooth that every ray leaves in one direction only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirror {
    /// The share of the light that is reflected, per channel: at most 1. Silver 0.96 0.95 0.92, say.
    pub share: Rgb,
}

// ANCHOR: reflect
/// r = i − 2 (i·n) n, the mirror direction of i, which points to the surface; n may point to either side.
///
/// What of i is parallel to the surface stays, and what is square to it, (i·n) n, turns round.
pub fn reflect(incoming: Dir3, normal: Dir3) -> Dir3 {
    let reflected = *incoming - 2.0 * incoming.dot(*normal) * *normal;
    Dir3::new_or(reflected, -incoming)
}
// ANCHOR_END: reflect

impl Material for Mirror {
    /// Nothing: a point light is seen in a mirror in one direction only, and no ray meets it by chance.
    fn lit(&self, _at: &Surface, _view: Dir3, _light: &LightSample) -> Rgb {
        Rgb::BLACK
    }

    // ANCHOR: mirror
    /// The share of what the mirrored ray sees.
    ///
    /// At a grazing angle an interpolated normal may send it below the surface; then the surface's own normal is asked.
    fn beyond(&self, at: &Surface, view: Dir3, see: &mut See) -> Rgb {
        let side = |d: Dir3| at.normal.dot(*d) < 0.0;
        let mut mirrored = reflect(-view, at.shading_normal);
        if side(mirrored) != side(view) {
            mirrored = reflect(-view, at.normal);
        }
        self.share * see(&at.leave(mirrored), 1.0).radiance
    }
    // ANCHOR_END: mirror
}

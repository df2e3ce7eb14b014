//! Glass, water and air: media that light passes through, and the surfaces between them.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let ink = Medium { absorption: Rgb::new(1.0, 1.0, 0.0), ..Medium::WATER };
//! let [one, two] = [1.0, 2.0].map(|x| ink.transmittance(x).r);
//! assert!((two - one * one).abs() < 1e-6); // each metre takes the same share
//! assert_eq!(Glass::of(ink).outside, Medium::AIR);
//! ```

use crate::image::rgb::Rgb;
use crate::material::fresnel::fresnel;
use crate::material::refract::refract;
use crate::material::{Delta, Material, mirror::reflect};
use crate::math::dir3::Dir3;
use crate::shape::Surface;

/// The medium on one side of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Medium {
    /// Index of refraction n: the speed of light in a vacuum over that in the material.
    pub index: f32,
    /// σ: the absorption coefficient per channel, in 1/m; over a distance dx the share σ·dx of the light is lost.
    pub absorption: Rgb,
}

impl Medium {
    /// Air: n = 1.0003, here 1.
    pub const AIR: Self = Self::clear(1.0);
    /// Water.
    pub const WATER: Self = Self::clear(1.333);
    /// Window glass.
    pub const GLASS: Self = Self::clear(1.5);

    /// A medium of this index that absorbs nothing.
    pub const fn clear(index: f32) -> Self {
        Self {
            index,
            absorption: Rgb::BLACK,
        }
    }

    // ANCHOR: transmittance
    /// e^(−σx): the share of the light that is left after x metres, because every metre takes the same share (the Beer–Lambert
    /// law: Lambert 1760, Beer 1852).
    pub fn transmittance(&self, x: f32) -> Rgb {
        // 0·∞ is NaN, and x is ∞ for a ray that meets nothing.
        self.absorption.map(|sigma| {
            if sigma == 0.0 {
                1.0
            } else {
                (-sigma * x).exp()
            }
        })
    }
    // ANCHOR_END: transmittance
}

/// A smooth surface between two media. The surface stores both: a glass ball in water has water outside, and a bubble in
/// glass has glass outside and air inside.
///
/// Where a beam enters a denser medium, its radiance grows by the factor (n₂/n₁)², because the same light goes on in a narrower
/// cone. Where the beam leaves, its radiance shrinks by the same factor. Camera and lights are assumed to be in the same medium:
/// then the factors cancel, and are left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glass {
    /// The medium on the side to which the normal points.
    pub outside: Medium,
    /// The medium on the other side.
    pub inside: Medium,
}

impl Glass {
    /// A body of some medium in air.
    pub const fn of(inside: Medium) -> Self {
        Self {
            outside: Medium::AIR,
            inside,
        }
    }
}

impl Material for Glass {
    // ANCHOR: glass
    /// A reflected ray with the share R, and a refracted ray with the share 1 − R, R by Fresnel's equations; each with the medium
    /// that it goes through.
    fn delta_lobes(&self, at: &Surface, view: Dir3, visit: &mut dyn FnMut(Delta)) {
        let normal = at.facing(view);
        let (here, there) = if at.normal.dot(*view) < 0.0 {
            (self.inside, self.outside)
        } else {
            (self.outside, self.inside)
        };
        let cosine = normal.dot(*view);
        let share = fresnel(cosine, here.index, there.index).unpolarised;
        let mut lobe = |toward: Dir3, share: f32, medium: Medium| {
            visit(Delta {
                toward,
                share: Rgb::gray(share),
                medium,
            });
        };
        if share > 0.0 {
            lobe(reflect(-view, normal), share, here);
        }
        if let Some(refracted) = refract(-view, normal, here.index, there.index) {
            lobe(refracted, 1.0 - share, there);
        }
    }
    // ANCHOR_END: glass

    fn scatters(&self, _at: &Surface) -> bool {
        false
    }
}

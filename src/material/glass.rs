//! Glass, water and air: media that light goes through, and the surfaces between them.

use crate::image::rgb::Rgb;
use crate::material::fresnel::fresnel;
use crate::material::refract::refract;
use crate::material::{Delta, Material, mirror::reflect};
use crate::math::dir3::Dir3;
use crate::shape::Surface;

/// What is on one side of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Medium {
    /// Index of refraction n: the speed of light in a vacuum over that in the material.
    pub index: f32,
    /// σ, in 1/m: of light of each colour, the share σ·dx gets lost on a way dx.
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
    /// e^(−σx), what is left of the light after x metres: the share that is lost is the same on every metre (Beer and Lambert).
    pub fn transmittance(&self, x: f32) -> Rgb {
        // 0·∞ is NaN: a ray that meets nothing goes on for ever.
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

/// A smooth surface between two media. Both belong to the surface: a glass ball in water is told so, and a bubble in
/// glass has glass outside and air inside.
///
/// Of a beam that enters a denser medium the radiance grows by (n₂/n₁)², for the same light goes on in a narrower cone,
/// and shrinks again when it leaves. Rays that end in the medium where they began need not count that, and here all do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glass {
    /// On the side to which the normal points.
    pub outside: Medium,
    /// On the other.
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
    /// R·(what is seen in the surface) + (1 − R)·(what is seen through it), each less what the medium on the way absorbs.
    fn deltas(&self, at: &Surface, view: Dir3, tell: &mut dyn FnMut(Delta)) {
        let normal = at.facing(view);
        let (here, there) = if at.normal.dot(*view) < 0.0 {
            (self.inside, self.outside)
        } else {
            (self.outside, self.inside)
        };
        let cosine = normal.dot(*view);
        let share = fresnel(cosine, here.index, there.index).unpolarised;
        let mut lobe = |toward: Dir3, share: f32, medium: Medium| {
            tell(Delta {
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

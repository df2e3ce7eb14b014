//! Floor 4: what surfaces make of light.

pub mod blinn_phong;
pub mod brdf;
pub mod checkered;
pub mod fresnel;
pub mod glass;
pub mod lambert;
pub mod mirror;
pub mod modified_phong;
pub mod phong;
pub mod polished;
pub mod refract;

use crate::image::rgb::Rgb;
use crate::light::LightSample;
use crate::math::{dir3::Dir3, ray::Ray};
use crate::shape::Surface;

// ANCHOR: material
/// What a surface sends to a viewer. `view` is the direction from the surface to the viewer.
pub trait Material: Send + Sync {
    /// The radiance that light from a lamp becomes.
    fn lit(&self, at: &Surface, view: Dir3, light: &LightSample) -> Rgb;

    /// k_a: the share of the scene's ambient light that is sent on.
    fn ambient(&self, _at: &Surface) -> Rgb {
        Rgb::BLACK
    }

    /// The radiance of what is seen in the surface or through it; `see` tells what a ray sees.
    fn beyond(&self, _at: &Surface, _view: Dir3, _see: &mut See) -> Rgb {
        Rgb::BLACK
    }
}
// ANCHOR_END: material

/// Tells what a ray sees, if at most this share of it counts: what counts for nearly nothing need not be looked at.
pub type See<'a> = dyn FnMut(&Ray, f32) -> Sight + 'a;

/// What a ray sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sight {
    /// The radiance that comes along the ray.
    pub radiance: Rgb,
    /// How far away what is seen is, in metres; ∞ if the ray meets nothing.
    pub distance: f32,
}

impl Surface {
    /// The shading normal, turned to the side from which the surface is seen.
    #[inline]
    pub fn facing(&self, view: Dir3) -> Dir3 {
        if self.normal.dot(*view) < 0.0 {
            -self.shading_normal
        } else {
            self.shading_normal
        }
    }
}

//! Floor 4: how surfaces reflect, refract and emit light.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let at = Surface::flat(Vec3::ZERO, 0.0, Dir3::Y);
//! let steep = Dir3::new(vec3(0.6, 0.8, 0.0)).expect("longer than 0");
//! let paper = Lambert { albedo: Rgb::gray(0.8) };
//! // A BRDF is reciprocal: light and viewer may be exchanged.
//! assert_eq!(paper.eval(&at, Dir3::Y, steep), paper.eval(&at, steep, Dir3::Y));
//! // A mirror has no BRDF, only a delta lobe.
//! assert!(!Mirror { share: Rgb::WHITE }.scatters(&at));
//! ```

pub mod blinn_phong;
pub mod checkered;
pub mod conductor;
pub mod dispersion;
pub mod fresnel;
pub mod ggx;
pub mod glass;
pub mod glowing;
pub mod image_texture;
pub mod lambert;
mod matte_and_glossy;
pub mod mirror;
pub mod modified_phong;
pub mod mtl;
pub mod normalised_blinn_phong;
pub mod phong;
pub mod plastic;
pub mod polished;
pub mod refract;
pub mod texture;

use crate::image::rgb::Rgb;
use crate::light::LightSample;
use crate::math::{dir3::Dir3, ray::Ray};
use crate::sample::hemisphere::{cosine_hemisphere, cosine_pdf};
use crate::shape::Surface;
use arrayvec::ArrayVec;
use glam::Vec2;
use glass::Medium;

// ANCHOR: material
/// A material: how a surface scatters light, and the light that it emits.
///
/// All integrators use this interface. `view` is the direction from the surface to the viewer, `toward` the direction to where
/// the light comes from. The viewer's side of the surface counts as its front ([`Surface::facing`]). Two kinds of lobe add up:
///
/// * Light that is scattered to a range of directions, by f = dL_o/dE, the bidirectional reflectance distribution function
///   (BRDF), in 1/sr (Nicodemus et al. 1977): `eval`, `sample` and `pdf`. f does not contain the cosine of the light's direction:
///   the integrator multiplies by it. A physical BRDF is reciprocal, f(ω_i, ω_o) = f(ω_o, ω_i), and conserves energy:
///   ∫ f cos θ dω ≤ 1.
/// * Light that goes to one direction only, in a mirror or through smooth glass (a delta lobe): `delta_lobes`. f is infinite in this
///   direction and 0 elsewhere, so these lobes are followed, never evaluated.
pub trait Material: Send + Sync {
    /// f, in 1/sr; 0 where light and viewer are on different sides of the surface.
    fn eval(&self, _at: &Surface, _view: Dir3, _toward: Dir3) -> Rgb {
        Rgb::BLACK
    }

    /// A direction towards light, chosen with a density about proportional to f cos θ (importance sampling).
    ///
    /// u is uniform in [0, 1)². `None` if the direction is behind the surface, from where no light comes. A material without a
    /// density of its own is sampled by the cosine alone, which is right for every f, and best for a matte one.
    fn sample(&self, at: &Surface, view: Dir3, u: Vec2) -> Option<Dir3> {
        self.scatters(at)
            .then(|| cosine_hemisphere(at.facing(view), u))
    }

    /// The density, in 1/sr, with which [`Material::sample`] chooses the direction `toward`.
    fn pdf(&self, at: &Surface, view: Dir3, toward: Dir3) -> f32 {
        if !self.scatters(at) {
            return 0.0;
        }
        cosine_pdf(at.facing(view).dot(*toward))
    }

    /// A direction by [`Material::sample`], with its `pdf` and its f: all that a path needs, in one call.
    fn scatter(&self, at: &Surface, view: Dir3, u: Vec2) -> Option<Scatter> {
        let toward = self.sample(at, view, u)?;
        Some(Scatter {
            toward,
            pdf: self.pdf(at, view, toward),
            f: self.eval(at, view, toward),
        })
    }

    /// L_e: the radiance that the surface emits, in W·m⁻²·sr⁻¹.
    fn emitted(&self, _at: &Surface, _view: Dir3) -> Rgb {
        Rgb::BLACK
    }

    /// k_a: the share of the scene's ambient light that is reflected. Integrators for local illumination use it in place of
    /// indirect light.
    fn ambient(&self, _at: &Surface) -> Rgb {
        Rgb::BLACK
    }

    /// Calls `visit` with every delta lobe.
    fn delta_lobes(&self, _at: &Surface, _view: Dir3, _visit: &mut dyn FnMut(Delta)) {}

    /// Whether f is above 0 anywhere; `false` for a mirror, which has only a delta lobe.
    fn scatters(&self, _at: &Surface) -> bool {
        true
    }

    /// f cos θ E: the reflected radiance, in W·m⁻²·sr⁻¹, for a sample of a light with the irradiance E.
    fn lit(&self, at: &Surface, view: Dir3, light: &LightSample) -> Rgb {
        let cosine = at.facing(view).dot(*light.toward).max(0.0);
        self.eval(at, view, light.toward) * light.arriving * cosine
    }
}
// ANCHOR_END: material

/// A sampled direction from which light may come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scatter {
    /// Where the light comes from.
    pub toward: Dir3,
    /// The density with which the direction was chosen, in 1/sr.
    pub pdf: f32,
    /// f, in 1/sr.
    pub f: Rgb,
}

/// A delta lobe: light that comes from one direction only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Delta {
    /// Where the light comes from.
    pub toward: Dir3,
    /// The share of the light's radiance that goes on to the viewer.
    pub share: Rgb,
    /// The medium that the light passes through on its way to the surface.
    pub medium: Medium,
}

/// Maximum number of delta lobes that [`beyond`] follows; polish over glass has three.
const LOBES: usize = 4;

// ANCHOR: beyond
/// The radiance that a surface shows by its delta lobes, mirrored and refracted; `see` returns what a ray sees.
///
/// Where one ray becomes several, `see` gets the share of each ray, so that it can leave out rays with a small share. A single
/// ray has the share 1: a chain of rays does not grow into a tree, however long it is.
pub fn beyond(material: &dyn Material, at: &Surface, view: Dir3, see: &mut See) -> Rgb {
    let mut lobes = ArrayVec::<Delta, LOBES>::new();
    material.delta_lobes(at, view, &mut |lobe| {
        if !lobes.is_full() {
            lobes.push(lobe);
        }
    });
    let mut radiance = Rgb::BLACK;
    for lobe in &lobes {
        let share = if lobes.len() > 1 {
            lobe.share.max_channel()
        } else {
            1.0
        };
        let sight = see(&at.leave(lobe.toward), share);
        radiance += sight.radiance * lobe.medium.transmittance(sight.distance) * lobe.share;
    }
    radiance
}
// ANCHOR_END: beyond

/// Returns what a ray sees. The number is the share of it that counts, at most: rays with a very small share may be left out.
pub type See<'a> = dyn FnMut(&Ray, f32) -> Sight + 'a;

/// What a ray sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sight {
    /// The radiance that comes along the ray.
    pub radiance: Rgb,
    /// The distance of the surface that is seen, in metres; ∞ if the ray meets nothing.
    pub distance: f32,
}

/// A black material, which reflects no light: for scenes in which only shadows matter.
impl Material for () {
    fn scatters(&self, _at: &Surface) -> bool {
        false
    }
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

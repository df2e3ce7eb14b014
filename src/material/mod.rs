//! Floor 4: what surfaces make of light.

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
pub mod mirror;
pub mod modified_phong;
pub mod mtl;
pub mod phong;
pub mod plastic;
pub mod polished;
pub mod refract;
pub mod texture;

use crate::image::rgb::Rgb;
use crate::light::LightSample;
use crate::math::{dir3::Dir3, ray::Ray};
use crate::shape::Surface;
use glam::Vec2;
use glass::Medium;

// ANCHOR: material
/// What a surface makes of light: its lobes, and what it sends out by itself.
///
/// Every integrator asks this one interface. `view` is the direction from the surface to the viewer, `toward` the one to where the
/// light comes from; a surface takes the side on which the viewer is for its front ([`Surface::facing`]). Two kinds of lobe add up:
///
/// * what goes to a range of directions, by f = dL_o/dE, the bidirectional reflectance distribution function, in 1/sr (Nicodemus et
///   al. 1977): `eval`, `sample` and `pdf`. The cosine of the light's direction is not in f: who integrates multiplies by it.
///   A BRDF of nature is reciprocal, f(ω_i, ω_o) = f(ω_o, ω_i), and sends out no more than it gets: ∫ f cos θ dω ≤ 1.
/// * what goes to one direction only, in a mirror or through smooth glass: `deltas`. Their f is infinite there and 0 elsewhere,
///   so that they are followed, never evaluated.
pub trait Material: Send + Sync {
    /// f, in 1/sr; 0 where light or viewer is behind the surface.
    fn eval(&self, _at: &Surface, _view: Dir3, _toward: Dir3) -> Rgb {
        Rgb::BLACK
    }

    /// A direction from which much of the light that the viewer gets may come: about as likely as f cos θ.
    ///
    /// u is uniform in [0, 1)². `None`: behind the surface, from where nothing comes.
    fn sample(&self, _at: &Surface, _view: Dir3, _u: Vec2) -> Option<Dir3> {
        None
    }

    /// The density with which [`Material::sample`] chooses a direction, in 1/sr.
    fn pdf(&self, _at: &Surface, _view: Dir3, _toward: Dir3) -> f32 {
        0.0
    }

    /// A direction by [`Material::sample`], with what the other two say of it: all that a path wants to know, in one question.
    fn scatter(&self, at: &Surface, view: Dir3, u: Vec2) -> Option<Scatter> {
        let toward = self.sample(at, view, u)?;
        Some(Scatter {
            toward,
            pdf: self.pdf(at, view, toward),
            f: self.eval(at, view, toward),
        })
    }

    /// L_e: the radiance that the surface sends out by itself, in W·m⁻²·sr⁻¹.
    fn emitted(&self, _at: &Surface, _view: Dir3) -> Rgb {
        Rgb::BLACK
    }

    /// k_a: the share of the scene's ambient light that is sent on, where no light is followed from surface to surface.
    fn ambient(&self, _at: &Surface) -> Rgb {
        Rgb::BLACK
    }

    /// Tells every lobe of one direction only.
    fn deltas(&self, _at: &Surface, _view: Dir3, _tell: &mut dyn FnMut(Delta)) {}

    /// Whether f is more than 0 anywhere: a mirror has no other lobe than its own.
    fn scatters(&self, _at: &Surface) -> bool {
        true
    }

    /// f cos θ E: the radiance that light from a lamp becomes.
    fn lit(&self, at: &Surface, view: Dir3, light: &LightSample) -> Rgb {
        let cosine = at.facing(view).dot(*light.toward).max(0.0);
        self.eval(at, view, light.toward) * light.arriving * cosine
    }
}
// ANCHOR_END: material

/// A direction from which light may come, out of a range of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scatter {
    /// Where the light comes from.
    pub toward: Dir3,
    /// The density with which it was chosen, in 1/sr.
    pub pdf: f32,
    /// f, in 1/sr.
    pub f: Rgb,
}

/// A lobe of one direction: the light of one ray, and nothing beside it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Delta {
    /// Where the light comes from.
    pub toward: Dir3,
    /// The share of its radiance that goes on to the viewer.
    pub share: Rgb,
    /// What the light comes through on its way to the surface.
    pub medium: Medium,
}

/// The lobes of one direction that a material has, at most: polish over glass has three.
const LOBES: usize = 4;

// ANCHOR: beyond
/// The radiance of what is seen in a surface and through it; `see` tells what a ray sees.
///
/// Where one ray becomes several, each is told its share: a tree of rays has twigs that hardly count, a chain has none.
pub fn beyond(material: &dyn Material, at: &Surface, view: Dir3, see: &mut See) -> Rgb {
    let (mut lobes, mut count) = ([None; LOBES], 0);
    material.deltas(at, view, &mut |lobe| {
        if let Some(place) = lobes.get_mut(count) {
            *place = Some(lobe);
        }
        count += 1;
    });
    let mut radiance = Rgb::BLACK;
    for lobe in lobes.into_iter().flatten() {
        let share = if count > 1 {
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

/// Made of nothing that sends on any light: black. For scenes in which only shadows are asked for.
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

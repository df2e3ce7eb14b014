//! Local illumination: the light that comes straight from the lights.
//!
//! ```
//! use raybook::math::pcg;
//! use raybook::prelude::*;
//! use raybook::render::local::{Local, NO_SHADOWS};
//!
//! let floor = Thing::new(Plane::through(Vec3::ZERO, Dir3::Y), Lambert { albedo: Rgb::WHITE });
//! let sun = DirectionalLight { toward: Dir3::Y, irradiance: Rgb::gray(std::f32::consts::PI) };
//! let scene = Scene::new(vec![floor], vec![Box::new(sun)]);
//! let seen = scene.closest(&Ray::new(Vec3::Y, -Dir3::Y)).expect("the floor");
//! let local = Local { samples: 1, arrives: NO_SHADOWS };
//! let light = local.follow(&scene, &seen, Dir3::Y, &mut pcg::stream(0, 0));
//! assert!((light.radiance.g - 1.0).abs() < 1e-6 && light.rays == 0); // ρ/π · E, without shadow rays
//! ```

use crate::image::rgb::Rgb;
use crate::light::LightSample;
use crate::math::{dir3::Dir3, ray::Ray};
use crate::render::{cone::Cone, followed::Followed, sampler::Integrator};
use crate::scene::world::{Scene, Seen};
use crate::shape::Surface;
use glam::{Vec2, vec2};
use rand::{Rng, RngExt};

/// Whether a sample of a light arrives at a surface.
pub type Visibility = fn(&Scene, &Surface, &LightSample) -> bool;

/// All light arrives: a world without shadows, in which no shadow rays are followed.
pub const NO_SHADOWS: Option<Visibility> = None;

/// Local illumination: how the light of the light sources is gathered. `A` is a function or a closure that tells whether light
/// arrives.
#[derive(Clone, Copy, Debug)]
pub struct Local<A = Visibility> {
    /// Number of samples per light; at least 1.
    pub samples: u32,
    /// Returns whether a sample arrives, by following a shadow ray; [`NO_SHADOWS`] for a world without shadows.
    pub arrives: Option<A>,
}

impl<A: Fn(&Scene, &Surface, &LightSample) -> bool> Local<A> {
    // ANCHOR: local
    /// I = k_a i_a + Σ of the lights' contributions. A light's contribution is the mean over its samples of the radiance that the
    /// material reflects, [`Material::lit`](crate::material::Material::lit), where the sample arrives.
    pub fn follow(&self, scene: &Scene, seen: &Seen, view: Dir3, rng: &mut dyn Rng) -> Followed {
        let mut rays = 0;
        let mut arrives = |sample: &LightSample| {
            self.arrives.as_ref().is_none_or(|arrives| {
                rays += 1;
                arrives(scene, &seen.surface, sample)
            })
        };
        let mut sum = seen.material.ambient(&seen.surface) * scene.ambient;
        for light in &scene.lights {
            let mut of_light = Rgb::BLACK;
            for _ in 0..self.samples {
                let u = if light.has_extent() {
                    vec2(rng.random(), rng.random())
                } else {
                    Vec2::ZERO
                };
                let Some(sample) = light.sample(seen.surface.position, u) else {
                    continue;
                };
                let lit = seen.material.lit(&seen.surface, view, &sample);
                // A mirror does not reflect a lamp's sample, nor does a surface that is turned away: then no shadow ray is
                // needed.
                if lit != Rgb::BLACK && arrives(&sample) {
                    of_light += lit;
                }
            }
            sum += of_light / self.samples as f32;
        }
        Followed {
            radiance: sum,
            rays,
        }
    }
    // ANCHOR_END: local
}

/// What a ray sees in the light that comes straight from the lights: mirrors and glass are black.
impl<A: Fn(&Scene, &Surface, &LightSample) -> bool + Sync> Integrator for Local<A> {
    fn follow(&self, scene: &Scene, ray: &Ray, cone: Cone, numbers: &mut dyn Rng) -> Followed {
        let Some(mut seen) = scene.closest(ray) else {
            return Followed {
                radiance: scene.behind_everything(ray),
                rays: 1,
            };
        };
        let view = -ray.direction;
        cone.after(seen.t).cover(&mut seen.surface, view);
        let local = self.follow(scene, &seen, view, numbers);
        Followed {
            rays: local.rays + 1,
            ..local
        }
    }
}

//! Local illumination: the light that comes straight from the lights.

use crate::image::rgb::Rgb;
use crate::light::LightSample;
use crate::math::dir3::Dir3;
use crate::render::followed::Followed;
use crate::scene::world::{Scene, Seen};
use crate::shape::Surface;
use glam::vec2;
use rand::{Rng, RngExt};

/// Whether light on its way to a surface arrives there.
pub type Arrives = fn(&Scene, &Surface, &LightSample) -> bool;

/// Nothing is in the way, ever: the world without shadows, in which no ray to a light need be followed.
pub const ALWAYS: Option<Arrives> = None;

/// How light from the lights is gathered. Whether it arrives is asked of a function, or of a closure `A`.
#[derive(Clone, Copy, Debug)]
pub struct Local<A = Arrives> {
    /// Samples of every light.
    pub samples: u32,
    /// Whether a sample arrives, by following a ray to the light; [`ALWAYS`] if there is no need to.
    pub arrives: Option<A>,
}

impl<A: Fn(&Scene, &Surface, &LightSample) -> bool> Local<A> {
    // ANCHOR: local
    /// I = k_a i_a + Σ over the lights: the mean, over a light's samples, of what the material makes of them.
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
                let u = vec2(rng.random(), rng.random());
                let Some(sample) = light.sample(seen.surface.position, u) else {
                    continue;
                };
                let lit = seen.material.lit(&seen.surface, view, &sample);
                // A mirror makes nothing of a lamp, nor does a surface that is turned away: then nobody need look.
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

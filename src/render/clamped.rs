//! Light that is cut off sample by sample: no fireflies, and smooth edges of lamps.

use crate::math::ray::Ray;
use crate::render::{cone::Cone, followed::Followed, sampler::Integrator};
use crate::scene::world::Scene;
use rand::Rng;

/// An integrator that cuts off what one sample brings.
///
/// Cut off before the mean is taken, a lamp of radiance 50 that fills a tenth of a pixel is a tenth of what a display shows, and its
/// edge is smooth; cut off afterwards, the pixel is white, and the edge has stairs. And a rare path that finds very much
/// light becomes no white dot. What is cut off is lost: a caustic gets darker, and a picture of radiance is no longer right.
#[derive(Clone, Copy, Debug)]
pub struct Clamped<I> {
    /// Finds the light.
    pub integrator: I,
    /// The brightest channel that a sample may have, in W·m⁻²·sr⁻¹; brighter ones keep their colour.
    pub brightest: f32,
}

impl<I: Integrator> Integrator for Clamped<I> {
    fn follow(&self, scene: &Scene, ray: &Ray, cone: Cone, numbers: &mut dyn Rng) -> Followed {
        let followed = self.integrator.follow(scene, ray, cone, numbers);
        let brightest = followed.radiance.max_channel();
        if brightest <= self.brightest {
            return followed;
        }
        Followed {
            radiance: followed.radiance * (self.brightest / brightest),
            ..followed
        }
    }
}

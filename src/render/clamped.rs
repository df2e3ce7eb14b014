//! Samples clamped to a maximum: no fireflies, and smooth edges of lamps.
//!
//! ```
//! use raybook::math::pcg;
//! use raybook::prelude::*;
//! use raybook::render::cone::Cone;
//!
//! let scene = Scene::new(vec![], vec![]).surrounded_by(Rgb::BLACK, |_| Rgb::gray(1000.0));
//! let path = Clamped { integrator: Path::WHOLE, brightest: 10.0 };
//! let ray = Ray::new(Vec3::ZERO, Dir3::Z);
//! assert_eq!(path.follow(&scene, &ray, Cone::THIN, &mut pcg::stream(0, 0)).radiance, Rgb::gray(10.0));
//! ```

use crate::image::rgb::Rgb;
use crate::math::ray::Ray;
use crate::render::{cone::Cone, followed::Followed, sampler::Integrator};
use crate::scene::world::Scene;
use rand::Rng;

/// An integrator that clamps the radiance of each sample.
///
/// Take a lamp of radiance 50 that fills a tenth of a pixel. Clamped to 1 before the mean is taken, the pixel is 0.1, and the
/// lamp's edge is smooth. Clamped afterwards, the pixel is white, and the edge has stairs. Also, a rare path that finds very much
/// light does not become a white dot (a firefly). But the picture is biased: the clamped light is lost, and caustics get darker.
#[derive(Clone, Copy, Debug)]
pub struct Clamped<I> {
    /// The integrator whose samples are clamped.
    pub integrator: I,
    /// Maximum of a sample's brightest channel, in W·m⁻²·sr⁻¹; a brighter sample is scaled down, which keeps its hue.
    pub brightest: f32,
}

impl<I: Integrator> Integrator for Clamped<I> {
    fn follow(&self, scene: &Scene, ray: &Ray, cone: Cone, numbers: &mut dyn Rng) -> Followed {
        let followed = self.integrator.follow(scene, ray, cone, numbers);
        Followed {
            radiance: clamped(followed.radiance, self.brightest),
            ..followed
        }
    }
}

/// Radiance whose brightest channel is at most `brightest`: brighter radiance is scaled down.
pub(crate) fn clamped(radiance: Rgb, brightest: f32) -> Rgb {
    let channel = radiance.max_channel();
    if channel <= brightest {
        return radiance;
    }
    radiance * (brightest / channel)
}

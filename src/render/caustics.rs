//! Path tracing with a photon map for the caustics.
//!
//! ```
//! use raybook::math::pcg;
//! use raybook::prelude::*;
//! use raybook::render::{caustics::Caustics, cone::Cone, photons::Photons};
//!
//! // A lamp that shines up on a mirror, which throws the light down to a floor.
//! let lamp = RectLight::new(vec3(-0.5, 1.0, -0.5), Vec3::Z, Vec3::X, Rgb::WHITE);
//! let floor = Thing::new(Plane::through(Vec3::ZERO, Dir3::Y), Lambert { albedo: Rgb::gray(0.5) });
//! let mirror = Thing::new(Plane::through(2.0 * Vec3::Y, Dir3::Y), Mirror { share: Rgb::WHITE });
//! let scene = Scene::new(vec![floor, mirror], vec![Box::new(lamp)]);
//! let photons = Photons::shot(&scene, 100_000, 0.2, 0);
//! let caustics = Caustics { path: Path { depth: 2, ..Path::WHOLE }, photons, brightest: f32::INFINITY };
//! // Of many paths, only a few find the lamp by the mirror. With photons, one path is enough.
//! let ray = Ray::new(0.5 * Vec3::Y, -Dir3::Y);
//! let seen = caustics.follow(&scene, &ray, Cone::THIN, &mut pcg::stream(0, 0)).radiance;
//! assert!((seen.g / 0.01705 - 1.0).abs() < 0.05); // of a square of 1 m², 3 m away
//! ```

use crate::math::ray::Ray;
use crate::render::clamped::clamped;
use crate::render::photons::Photons;
use crate::render::{cone::Cone, followed::Followed, path::Path, sampler::Integrator};
use crate::scene::world::Scene;
use rand::Rng;

/// A path tracer that leaves caustics to photons.
///
/// Each surface of a path that scatters light also reflects the light of the photons around it. In return, the path gets no light
/// from a lamp that it finds by mirrors or through glass after a surface that scatters: the photons have brought this light. So all light
/// is counted once. A path that has met mirrors and glass only sees the lamp, as before.
#[derive(Debug)]
pub struct Caustics {
    /// The path tracer for all other light.
    pub path: Path,
    /// The light of the caustics.
    pub photons: Photons,
    /// Maximum of the brightest channel of a sample, without the light of the photons, in W·m⁻²·sr⁻¹; ∞ for no limit. It is that of
    /// [`Clamped`](crate::render::clamped::Clamped), and leaves a caustic as bright as it is.
    pub brightest: f32,
}

impl Integrator for Caustics {
    fn follow(&self, scene: &Scene, ray: &Ray, cone: Cone, numbers: &mut dyn Rng) -> Followed {
        let photons = Some(&self.photons);
        let (rest, caustics) = self.path.follow_with(photons, scene, ray, cone, numbers);
        Followed {
            radiance: clamped(rest.radiance, self.brightest) + caustics,
            ..rest
        }
    }
}

//! The chequered plane with its balls, as a camera sees it: what chapters 22 and 23 photograph.

use glam::{Vec2, Vec3};
use raybook::camera::pinhole::{LookAtError, Pinhole};
use raybook::material::Material;
use raybook::math::pcg::Pcg;
use raybook::render::{followed::Followed, local::Local, shadow, whitted::Whitted};
use raybook::scene::{horizon, world::Scene};

/// The scene, its camera, and how light is followed.
pub struct HorizonView {
    scene: Scene<dyn Material>,
    camera: Pinhole,
    whitted: Whitted,
}

impl HorizonView {
    /// With shadows and without mirrors, for a film of this aspect.
    ///
    /// # Errors
    /// If there is no such camera.
    pub fn new(aspect: f32) -> Result<Self, LookAtError> {
        let [eye, at] = horizon::VIEW;
        let local = Local {
            samples: 1,
            arrives: Some(shadow::lit),
        };
        Ok(Self {
            scene: horizon::scene(),
            camera: Pinhole::look_at(eye, at, Vec3::Y, horizon::FOCAL_LENGTH, aspect)?,
            whitted: Whitted { local, depth: 1 },
        })
    }

    /// What is seen at a place on the film.
    pub fn radiance(&self, place: Vec2, rng: &mut Pcg) -> Followed {
        let ray = self.camera.ray_through(place);
        self.whitted.follow(&self.scene, &ray, rng)
    }
}

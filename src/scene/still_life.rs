//! Three balls on a plinth, to compare lights: one is matte, one glossy, one of gold.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::scene::still_life::still_life;
//!
//! let scene = still_life(Box::new(PointLight { position: vec3(0.0, 5.0, 0.0), intensity: Rgb::WHITE }));
//! let down = Ray::new(vec3(-0.15, 5.0, -0.35), -Dir3::Y);
//! assert!((scene.closest(&down).expect("the middle ball").t - 3.0).abs() < 1e-4); // its top is at 2 m
//! ```

use crate::image::rgb::Rgb;
use crate::light::Light;
use crate::material::conductor::Metal;
use crate::material::{Material, ggx::Ggx, lambert::Lambert, modified_phong::ModifiedPhong};
use crate::scene::world::{Scene, Thing};
use crate::shape::{Shape, cuboid::Cuboid, sphere::Sphere};
use glam::{Vec3, vec3};
use std::sync::Arc;

/// A camera's place from which all balls are seen, in metres.
pub const EYE: Vec3 = vec3(0.8, 1.6, 8.8);
/// The point that the camera looks at, in metres.
pub const AT: Vec3 = vec3(0.0, 0.66, 0.0);

/// The balls and the plinth under one light.
pub fn still_life(light: Box<dyn Light>) -> Scene {
    let matte = |r, g, b| {
        Arc::new(Lambert {
            albedo: Rgb::new(r, g, b),
        })
    };
    let ball = |x: f32, z: f32, r: f32| Arc::new(Sphere::new(vec3(x, r, z), r));
    let thing = |shape: Arc<dyn Shape>, material: Arc<dyn Material>| Thing { shape, material };
    let plinth = Cuboid::between(vec3(-2.4, -0.3, -1.6), vec3(2.4, 0.0, 1.6));
    let gold = Arc::new(Ggx {
        metal: Metal::GOLD,
        alpha: 0.03,
    });
    let glaze = Arc::new(ModifiedPhong {
        diffuse: Rgb::new(0.02, 0.22, 0.30),
        specular: Rgb::gray(0.28),
        exponent: 60.0,
    });
    Scene::new(
        vec![
            thing(Arc::new(plinth), matte(0.72, 0.70, 0.66)),
            thing(ball(-0.15, -0.35, 1.0), gold),
            thing(ball(-1.60, 0.55, 0.6), matte(0.80, 0.78, 0.74)),
            thing(ball(1.45, 0.45, 0.7), glaze),
        ],
        vec![light],
    )
}

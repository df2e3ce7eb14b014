//! A chequered plane to the horizon, with three balls: everything that aliases.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::scene::horizon;
//!
//! // From the camera's height of 1.5 m, a ray that falls by 1 in 100 meets the plane after 150 m.
//! let flat = Dir3::new(vec3(0.0, -1.0, -100.0)).expect("longer than 0");
//! let seen = horizon::scene().closest(&Ray::new(vec3(40.0, 1.5, 6.5), flat)).map(|seen| seen.t);
//! assert!((seen.expect("the plane") - 150.0).abs() < 0.1);
//! ```

use crate::image::rgb::Rgb;
use crate::light::{Light, directional::DirectionalLight};
use crate::material::{checkered::Checkered, phong::Phong};
use crate::math::{dir3::Dir3, ray::Ray};
use crate::scene::world::{Scene, Thing};
use crate::shape::{plane::Plane, sphere::Sphere};
use glam::{Vec3, vec3};
use std::f32::consts::FRAC_1_PI;

/// The camera's place, just above the plane, and the point that it looks at, in metres.
pub const VIEW: [Vec3; 2] = [vec3(0.0, 1.5, 6.5), vec3(0.0, 0.85, 0.0)];

/// That camera's focal length, in metres.
pub const FOCAL_LENGTH: f32 = 0.040;

/// The plane and the balls in the sun.
pub fn scene() -> Scene {
    let squares = Checkered(matte(0.74, 0.72, 0.68), matte(0.10, 0.14, 0.22));
    let floor = Plane::through(Vec3::ZERO, Dir3::Y);
    let ball = |x: f32, z: f32, r: f32, material: Phong| {
        Thing::new(Sphere::new(vec3(x, r, z), r), material)
    };
    let sun = DirectionalLight {
        toward: Dir3::new_or(vec3(-0.9, 1.3, 0.8), Dir3::Y),
        irradiance: Rgb::new(3.0, 2.8, 2.5),
    };
    let lights: Vec<Box<dyn Light>> = vec![Box::new(sun)];
    let things = vec![
        Thing::new(floor, squares),
        ball(-2.3, -0.4, 0.9, glossy(0.75, 0.20, 0.12)),
        ball(0.1, 0.2, 0.7, glossy(0.85, 0.62, 0.12)),
        ball(2.2, -0.6, 1.0, glossy(0.10, 0.42, 0.60)),
    ];
    Scene::new(things, lights).surrounded_by(Rgb::new(0.32, 0.36, 0.42), sky)
}

fn matte(r: f32, g: f32, b: f32) -> Phong {
    let colour = Rgb::new(r, g, b);
    Phong {
        ambient: colour,
        diffuse: colour * FRAC_1_PI,
        specular: Rgb::BLACK,
        exponent: 1.0,
    }
}

fn glossy(r: f32, g: f32, b: f32) -> Phong {
    Phong {
        specular: Rgb::gray(0.25),
        exponent: 60.0,
        ..matte(r, g, b)
    }
}

/// Pale at the horizon, blue above.
fn sky(ray: &Ray) -> Rgb {
    let up = ray.direction.y.clamp(0.0, 1.0).sqrt();
    Rgb::new(0.86, 0.88, 0.88).lerp(Rgb::new(0.28, 0.48, 0.80), up)
}

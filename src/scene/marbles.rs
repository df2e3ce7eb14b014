//! Marbles on a polished floor of a chessboard pattern, in the light of a lamp and the sun.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::scene::marbles;
//!
//! // The roof takes the sun away.
//! let up = Ray::new(vec3(0.0, 3.0, 0.0), Dir3::Y);
//! assert!(marbles::scene().closest(&up).is_none());
//! assert!(marbles::under_roof().closest(&up).is_some());
//! ```

use crate::image::rgb::Rgb;
use crate::light::{Light, directional::DirectionalLight, point::PointLight};
use crate::material::{checkered::Checkered, mirror::Mirror, phong::Phong, polished::Polished};
use crate::math::{dir3::Dir3, ray::Ray};
use crate::scene::world::{Scene, Thing};
use crate::shape::{plane::Plane, sphere::Sphere};
use glam::{Vec3, vec3};
use std::f32::consts::FRAC_1_PI;

/// A camera's place from which all marbles are seen, and the point that it looks at, in metres.
pub const VIEW: [Vec3; 2] = [vec3(0.3, 3.1, 7.4), vec3(0.05, 0.55, 0.0)];

/// Another view, from above and the left, in which the balls hide little of each other.
pub const FROM_ABOVE: [Vec3; 2] = [vec3(-2.6, 4.8, 6.0), vec3(-0.35, 0.45, 0.9)];

/// The lamp's place, in metres.
pub const LAMP: Vec3 = vec3(-3.0, 4.5, 2.5);

/// Ambient light.
const AMBIENT: Rgb = Rgb::new(0.15, 0.17, 0.20);

/// The middle of a ball's highlight, in 1/sr.
const SHINE: f32 = 0.25;

/// Two mirrors and seven coloured marbles: x and z on the floor and the radius, in metres, and the colour.
const MIRRORS: [(f32, f32, f32, Rgb); 2] = [
    (-1.05, -0.7, 1.15, Rgb::new(0.96, 0.95, 0.92)),
    (1.35, -0.2, 0.8, Rgb::new(0.95, 0.72, 0.32)),
];
const MARBLES: [(f32, f32, f32, Rgb); 7] = [
    (0.1, 1.35, 0.5, Rgb::new(0.75, 0.12, 0.04)),
    (-1.55, 1.3, 0.34, Rgb::new(0.03, 0.35, 0.55)),
    (2.5, 0.9, 0.4, Rgb::new(0.02, 0.42, 0.30)),
    (-2.85, 0.3, 0.45, Rgb::new(0.85, 0.50, 0.02)),
    (1.2, 1.75, 0.27, Rgb::new(0.80, 0.76, 0.68)),
    (0.35, -1.9, 0.55, Rgb::new(0.03, 0.35, 0.55)),
    (2.9, -1.2, 0.5, Rgb::new(0.75, 0.12, 0.04)),
];

/// The scene.
pub fn scene() -> Scene {
    let sun = DirectionalLight {
        toward: Dir3::new_or(vec3(0.75, 1.0, 0.35), Dir3::Y),
        irradiance: Rgb::new(1.0, 0.97, 0.92) * 1.3,
    };
    Scene::new(things(), vec![lamp(), Box::new(sun)]).surrounded_by(AMBIENT, sky)
}

/// The scene with the lamp only, under a roof.
pub fn under_roof() -> Scene {
    let roof = Plane::through(vec3(0.0, 7.0, 0.0), -Dir3::Y);
    let white = glossy(Rgb::new(0.80, 0.78, 0.72), 0.0, 1.0);
    let mut things = things();
    things.push(Thing::new(roof, white));
    Scene::new(things, vec![lamp()]).surrounded_by(AMBIENT, sky)
}

/// Floor, mirrors and marbles.
fn things() -> Vec<Thing> {
    let tile = |colour| Polished {
        mirror: Mirror {
            share: Rgb::gray(0.22),
        },
        below: glossy(colour, 0.0, 1.0),
    };
    let tiles = Checkered(
        tile(Rgb::new(0.78, 0.74, 0.66)),
        tile(Rgb::new(0.07, 0.17, 0.22)),
    );
    let floor = Plane::through(Vec3::ZERO, Dir3::Y);
    let mut things: Vec<Thing> = vec![Thing::new(floor, tiles)];
    things.extend(MIRRORS.map(|(x, z, radius, share)| -> Thing {
        Thing::new(standing(x, z, radius), Mirror { share })
    }));
    things.extend(MARBLES.map(|(x, z, radius, colour)| -> Thing {
        let marble = glossy(colour, SHINE, 120.0);
        Thing::new(standing(x, z, radius), marble)
    }));
    things
}

/// The lamp.
fn lamp() -> Box<dyn Light> {
    Box::new(PointLight {
        position: LAMP,
        intensity: Rgb::new(1.0, 0.86, 0.66) * 45.0,
    })
}

/// A ball that stands on the floor.
fn standing(x: f32, z: f32, radius: f32) -> Sphere {
    Sphere::new(vec3(x, radius, z), radius)
}

fn glossy(colour: Rgb, specular: f32, exponent: f32) -> Phong {
    Phong {
        ambient: colour,
        diffuse: colour * FRAC_1_PI,
        specular: Rgb::gray(specular),
        exponent,
    }
}

/// A clear sky, pale above the horizon.
fn sky(ray: &Ray) -> Rgb {
    let high = ray.direction.y.max(0.0).sqrt();
    Rgb::new(0.85, 0.86, 0.86).lerp(Rgb::new(0.16, 0.36, 0.68), high)
}

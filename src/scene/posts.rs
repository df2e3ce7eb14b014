//! Posts, a table and a ball on a pale floor: things of which some parts are near the floor and some are high above it.

use crate::image::rgb::Rgb;
use crate::light::Light;
use crate::material::Material;
use crate::material::phong::Phong;
use crate::math::{dir3::Dir3, ray::Ray};
use crate::scene::world::{Scene, Thing};
use crate::shape::{Shape, cuboid::Cuboid, plane::Plane, sphere::Sphere};
use glam::{Vec3, vec3};
use std::f32::consts::PI;

/// The middle of where the light is.
pub const LIGHT: Vec3 = vec3(-2.2, 4.6, -1.6);

/// The light's power seen from below, in W/m² of floor straight under it.
pub const STRENGTH: f32 = 3.4;

/// The things, under a light.
pub fn under(light: Box<dyn Light>) -> Scene<dyn Material> {
    let terracotta = Rgb::new(0.62, 0.22, 0.12);
    let teal = Rgb::new(0.06, 0.32, 0.36);
    let ochre = Rgb::new(0.72, 0.46, 0.12);
    let post = |x: f32, z: f32, height: f32| {
        let half = vec3(0.07, 0.0, 0.07);
        let foot = vec3(x, 0.0, z);
        Cuboid::between(foot - half, foot + half + height * Vec3::Y)
    };
    let mut things = vec![
        thing(
            Plane::through(Vec3::ZERO, Dir3::Y),
            Rgb::new(0.80, 0.77, 0.72),
        ),
        thing(Sphere::new(vec3(1.75, 0.45, 0.75), 0.45), ochre),
        thing(Sphere::new(vec3(-0.15, 0.28, 1.3), 0.28), teal),
    ];
    for (x, height) in [(-2.1, 0.5), (-1.6, 1.0), (-1.1, 1.5), (-0.6, 2.0)] {
        things.push(thing(post(x, 0.1, height), terracotta));
    }
    for (x, z) in [(0.75, -0.95), (2.05, -0.95), (0.75, 0.05), (2.05, 0.05)] {
        things.push(thing(post(x, z, 1.0), teal));
    }
    let board = Cuboid::between(vec3(0.55, 1.0, -1.15), vec3(2.25, 1.1, 0.25));
    things.push(thing(board, teal));
    let mut scene = Scene::new(things, vec![light]);
    scene.ambient = Rgb::new(0.16, 0.18, 0.22);
    scene.backdrop = |_: &Ray| Rgb::new(0.55, 0.60, 0.66);
    scene
}

/// A matte thing of so much reflectance.
fn thing(shape: impl Shape + 'static, reflectance: Rgb) -> Thing<dyn Material> {
    Thing {
        shape: Box::new(shape),
        material: Box::new(Phong {
            ambient: reflectance,
            diffuse: reflectance / PI,
            specular: Rgb::BLACK,
            exponent: 1.0,
        }),
    }
}

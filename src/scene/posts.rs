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
pub const LIGHT: Vec3 = vec3(-3.6, 5.6, -4.2);

/// The light's power seen from below, in W/m² of floor straight under it.
pub const STRENGTH: f32 = 4.6;

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
        thing(Sphere::new(vec3(0.35, 0.45, 1.0), 0.45), ochre),
        thing(Sphere::new(vec3(2.75, 0.28, 1.2), 0.28), teal),
    ];
    for (x, height) in [(-3.0, 0.5), (-2.3, 1.0), (-1.6, 1.5), (-0.9, 2.0)] {
        things.push(thing(post(x, -1.0, height), terracotta));
    }
    for (x, z) in [(1.0, -1.75), (2.3, -1.75), (1.0, -0.75), (2.3, -0.75)] {
        things.push(thing(post(x, z, 1.0), teal));
    }
    let board = Cuboid::between(vec3(0.8, 1.0, -1.95), vec3(2.5, 1.1, -0.55));
    things.push(thing(board, teal));
    let mut scene = Scene::new(things, vec![light]);
    scene.ambient = Rgb::new(0.24, 0.27, 0.32);
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

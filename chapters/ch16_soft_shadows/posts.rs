//! Posts, a table and a ball on a pale floor: things of which some parts are near the floor and some are high above it.

use glam::{Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::light::Light;
use raybook::light::extent::LightSampling;
use raybook::light::point::PointLight;
use raybook::light::rect_light::RectLight;
use raybook::light::sphere_light::SphereLight;
use raybook::material::phong::Phong;
use raybook::math::dir3::Dir3;
use raybook::scene::world::{Scene, Thing};
use raybook::shape::Shape;
use raybook::shape::cuboid::Cuboid;
use raybook::shape::plane::Plane;
use raybook::shape::sphere::Sphere;
use std::f32::consts::PI;

/// A view of the whole scene, and a view of some of the shadows: the camera's place, where it looks, and its focal length, in
/// metres.
pub const VIEWS: [(Vec3, Vec3, f32); 2] = [
    (vec3(0.5, 4.0, 7.6), vec3(0.1, 0.35, 0.1), 0.043),
    (vec3(0.5, 4.0, 7.6), vec3(-1.1, 0.35, -0.1), 0.066),
];

/// The middle of the light.
const LIGHT: Vec3 = vec3(-3.6, 5.6, -4.2);

/// Irradiance of the floor straight below the light, in W/m², if the light is small.
const STRENGTH: f32 = 3.6;

/// Intensity of each of the lights straight down, in W/sr: the irradiance times the squared distance.
const INTENSITY: Rgb = Rgb::gray(STRENGTH * LIGHT.y * LIGHT.y);

/// A point light.
pub fn point() -> Box<dyn Light> {
    Box::new(PointLight {
        position: LIGHT,
        intensity: INTENSITY,
    })
}

/// A square light that faces down; its intensity straight down is the same for every size.
pub fn square(side: f32) -> Box<dyn Light> {
    let corner = LIGHT - 0.5 * vec3(side, 0.0, side);
    let radiance = INTENSITY / (side * side);
    let (a, b) = (side * Vec3::X, side * Vec3::Z);
    Box::new(RectLight::new(corner, a, b, radiance))
}

/// A spherical light; its intensity is the same for every size.
pub fn sphere(radius: f32) -> Box<dyn Light> {
    Box::new(SphereLight {
        sphere: Sphere::new(LIGHT, radius),
        radiance: INTENSITY / (PI * radius * radius),
        choose: LightSampling::BySolidAngle,
    })
}

/// The things, under a light.
pub fn under(light: Box<dyn Light>) -> Scene {
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
    scene.backdrop = Box::new(|_| Rgb::new(0.55, 0.60, 0.66));
    scene
}

/// A matte thing of this reflectance.
fn thing(shape: impl Shape + 'static, reflectance: Rgb) -> Thing {
    let matte = Phong {
        ambient: reflectance,
        diffuse: reflectance / PI,
        specular: Rgb::BLACK,
        exponent: 1.0,
    };
    Thing::new(shape, matte)
}

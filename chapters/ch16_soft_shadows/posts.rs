//! The lights over the posts, and a second view of them.

use glam::{Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::light::Light;
use raybook::light::extent::LightSampling;
use raybook::light::point::PointLight;
use raybook::light::rect_light::RectLight;
use raybook::light::sphere_light::SphereLight;
use raybook::shape::sphere::Sphere;
use std::f32::consts::PI;

/// A view of some of the shadows: the camera's place, where it looks, and its focal length, in metres.
pub const CLOSE: (Vec3, Vec3, f32) = (vec3(0.5, 4.0, 7.6), vec3(-1.1, 0.35, -0.1), 0.066);

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

//! Lights for tests, and directions to ask about.

use glam::{Vec2, Vec3, vec2, vec3};
use raybook::image::rgb::Rgb;
use raybook::light::Light;
use raybook::light::extent::LightSampling;
use raybook::light::rect_light::RectLight;
use raybook::light::sphere_light::SphereLight;
use raybook::math::dir3::Dir3;
use raybook::shape::sphere::Sphere;
use std::f32::consts::TAU;

pub(super) const BOTH: [LightSampling; 2] = [LightSampling::ByArea, LightSampling::BySolidAngle];

/// The middle of each cell of an n × n lattice of the unit square.
pub(super) fn lattice(n: u32) -> impl Iterator<Item = Vec2> {
    (0..n * n).map(move |i| (vec2((i % n) as f32, (i / n) as f32) + 0.5) / n as f32)
}

/// A direction, uniform over the sphere.
pub(super) fn on_sphere(u: Vec2) -> Dir3 {
    let z = 1.0 - 2.0 * u.x;
    let (sine, phi) = ((1.0 - z * z).max(0.0).sqrt(), TAU * u.y);
    Dir3::new(vec3(sine * phi.cos(), sine * phi.sin(), z)).expect("it has length 1")
}

pub(super) fn rect(corner: Vec3, a: Vec3, b: Vec3, choose: LightSampling) -> RectLight {
    RectLight::new(corner, a, b, Rgb::WHITE).choosing(choose)
}

pub(super) fn sphere(center: Vec3, radius: f32, choose: LightSampling) -> SphereLight {
    SphereLight {
        sphere: Sphere::new(center, radius),
        radiance: Rgb::WHITE,
        choose,
    }
}

/// n² directions and the solid angle that each stands for.
pub(super) type Directions = Box<dyn Fn(u32) -> Vec<(Dir3, f64)>>;

/// All directions, evenly.
fn everywhere(n: u32) -> Vec<(Dir3, f64)> {
    let each = f64::from(2.0 * TAU) / f64::from(n * n);
    lattice(n).map(|u| (on_sphere(u), each)).collect()
}

/// Those in which a sphere is seen, ever closer towards its rim, where the density by area grows without a limit.
///
/// Not too close: in the last thousandth, the last digit of a direction decides on its density.
fn dense_at_the_rim(light: SphereLight) -> Directions {
    let cone = SphereLight {
        choose: LightSampling::BySolidAngle,
        ..light
    };
    Box::new(move |n| {
        let n = n / 4;
        let direction = |v: Vec2| {
            let u = vec2(1.0 - (1.0 - v.x).powi(2), v.y);
            let sample = cone.sample(Vec3::ZERO, u).expect("it is seen");
            let each = 2.0 * f64::from(1.0 - v.x) / f64::from(sample.pdf) / f64::from(n * n);
            (sample.toward, each)
        };
        lattice(n).map(direction).collect()
    })
}

/// Lights of both kinds around the origin, from which they are seen, each chosen both ways; and directions to ask about.
pub(super) fn lights() -> Vec<(String, Box<dyn Light>, Directions)> {
    let mut lights: Vec<(String, Box<dyn Light>, Directions)> = Vec::new();
    for choose in BOTH {
        let mut add = |name: &str, light: Box<dyn Light>| {
            lights.push((format!("{name}, {choose:?}"), light, Box::new(everywhere)));
        };
        let square = rect(vec3(-0.5, 1.0, -0.5), Vec3::X, Vec3::Z, choose);
        add("a unit square one metre above", Box::new(square));
        let aside = rect(vec3(2.0, 1.5, -3.0), 1.5 * Vec3::X, 0.7 * Vec3::Z, choose);
        add("a rectangle to the side", Box::new(aside));
        let a = vec3(1.0, 0.5, -0.3);
        let across = a.cross(vec3(0.2, -1.0, 0.4));
        let askew = rect(vec3(-0.4, 1.0, 0.8), 2.0 * across, a, choose);
        add("a rectangle askew", Box::new(askew));
        let around = sphere(vec3(0.3, 0.4, 0.0), 1.0, choose);
        add("a sphere around", Box::new(around));
        let centred = sphere(Vec3::ZERO, 2.0, choose);
        add("a sphere around its centre", Box::new(centred));
        for (name, center, radius) in [
            ("a sphere", vec3(1.0, 2.0, -1.0), 0.8),
            ("a sphere close by", vec3(0.0, 1.1, 0.0), 1.0),
        ] {
            let light = sphere(center, radius, choose);
            let directions = match choose {
                LightSampling::ByArea => dense_at_the_rim(light),
                LightSampling::BySolidAngle => Box::new(everywhere),
            };
            lights.push((format!("{name}, {choose:?}"), Box::new(light), directions));
        }
    }
    lights
}

//! Small scenes that try a material: a ball before a wall.

use glam::{Mat3, Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::light::{Light, directional::DirectionalLight};
use raybook::material::{Material, blinn_phong::BlinnPhong, phong::Phong};
use raybook::math::dir3::Dir3;
use raybook::scene::world::{Scene, Thing};
use raybook::shape::sphere::Sphere;
use std::f32::consts::{FRAC_1_PI, PI};

/// Red clay.
pub(super) const CLAY: Rgb = Rgb::new(0.80, 0.22, 0.05);

/// A scene and its name.
pub(super) type Trial = (String, Scene);

/// A material of this colour, with a highlight on top.
pub(super) fn glossy(colour: Rgb, exponent: f32) -> Phong {
    Phong {
        ambient: colour,
        diffuse: colour * FRAC_1_PI,
        specular: Rgb::gray(0.26),
        exponent,
    }
}

/// A material of this colour without a highlight.
pub(super) fn matte(colour: Rgb) -> Phong {
    Phong {
        specular: Rgb::BLACK,
        ..glossy(colour, 1.0)
    }
}

/// The terms of Phong's formula, one more in each scene, and then a second light.
pub(super) fn terms(exponent: f32, turn: Mat3) -> Vec<Trial> {
    let (matte, glossy) = (matte(CLAY), glossy(CLAY, exponent));
    let ambient = Phong {
        diffuse: Rgb::BLACK,
        ..matte
    };
    vec![
        ("ambient".into(), ball(ambient, 1, turn)),
        ("+ diffuse".into(), ball(matte, 1, turn)),
        ("+ specular".into(), ball(glossy, 1, turn)),
        ("+ another light".into(), ball(glossy, 2, turn)),
    ]
}

/// Phong's highlight with growing exponents, of which the second is given, then Blinn's with four times these exponents.
pub(super) fn exponents(exponent: f32, turn: Mat3) -> Vec<Trial> {
    let series = [0.25, 1.0, 4.0, 16.0].map(|times| times * exponent);
    let phong = series.map(|a| (format!("Phong, α = {a}"), ball(glossy(CLAY, a), 1, turn)));
    let blinn = series.map(|a| 4.0 * a).map(|a| {
        let material = BlinnPhong(glossy(CLAY, a));
        (format!("Blinn, α′ = {a}"), ball(material, 1, turn))
    });
    phong.into_iter().chain(blinn).collect()
}

/// A ball of radius 1 before a grey wall, under a white light from the left and, if there are two, a blue one from the right.
fn ball(material: impl Material + 'static, lights: usize, turn: Mat3) -> Scene {
    let light = |toward: Vec3, irradiance| -> Box<dyn Light> {
        Box::new(DirectionalLight {
            toward: Dir3::new_or(turn * toward, Dir3::Y),
            irradiance,
        })
    };
    let both = [
        light(vec3(-0.55, 0.65, 0.75), Rgb::gray(PI)),
        light(vec3(0.9, -0.25, 0.45), Rgb::new(0.2, 0.6, 1.0) * 2.0),
    ];
    let ball = Thing::new(Sphere::new(Vec3::ZERO, 1.0), material);
    Scene::new(vec![ball], both.into_iter().take(lights).collect())
        .surrounded_by(Rgb::gray(0.1), |ray| {
            Rgb::gray(0.42 + 0.9 * ray.direction.y)
        })
}

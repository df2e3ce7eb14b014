//! What is left of the light on its way through glass and water.

use crate::ch14_refraction::glass::{look, scene, thing};
use glam::{Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::material::glass::{Glass, Medium};
use raybook::material::phong::Phong;
use raybook::math::ray::Ray;
use raybook::shape::cuboid::Cuboid;

#[test]
fn a_plate_lets_through_what_beer_lambert_and_fresnel_leave() {
    for (thickness, sigma) in [(1.0_f32, 0.0_f32), (1.0, 0.7), (2.0, 0.7), (0.25, 3.0)] {
        let medium = Medium {
            absorption: Rgb::gray(sigma),
            ..Medium::GLASS
        };
        let plate = Cuboid::between(vec3(-9.0, -9.0, -thickness), vec3(9.0, 9.0, 0.0));
        let behind = |ray: &Ray| Rgb::gray(f32::from(u8::from(ray.direction.z < 0.0)));
        let scene = scene(vec![thing(plate, Glass::of(medium))], behind);
        let got = look(&scene, vec3(0.3, 0.2, 3.0), Vec3::NEG_Z, 20).g;
        // Through, or through after two, four, … reflections inside.
        let (r, left) = (0.04_f32, (-sigma * thickness).exp());
        let exact = (1.0 - r).powi(2) * left / (1.0 - (r * left).powi(2));
        assert!(
            (got - exact).abs() < 2e-3,
            "{thickness} m with σ = {sigma}/m leave {got}, not {exact}"
        );
    }
}

#[test]
fn absorption_takes_the_same_share_of_every_metre() {
    let medium = Medium {
        absorption: Rgb::new(0.0, 0.5, 2.0),
        ..Medium::WATER
    };
    let [one, two] = [1.0, 2.0].map(|x| medium.transmittance(x));
    assert_eq!(one.r, 1.0, "where σ is 0, nothing is lost");
    assert!(
        (two.g - one.g * one.g).abs() < 1e-6,
        "twice the way: squared"
    );
    assert!((one.b - (-2.0_f32).exp()).abs() < 1e-6, "e^(−σx)");
    let far = medium.transmittance(f32::INFINITY);
    assert_eq!((far.r, far.b), (1.0, 0.0), "also on a way without end");
}

#[test]
fn a_stone_under_water_is_seen_through_the_water_above_it() {
    let water = Medium {
        absorption: Rgb::gray(0.3),
        ..Medium::WATER
    };
    let (top, stone) = (1.5, 0.25);
    let pool = Cuboid::between(vec3(-9.0, -5.0, -9.0), vec3(9.0, top, 9.0));
    let bottom = Cuboid::between(vec3(-8.0, -1.0, -8.0), vec3(8.0, stone, 8.0));
    let white = Phong {
        ambient: Rgb::WHITE,
        diffuse: Rgb::BLACK,
        specular: Rgb::BLACK,
        exponent: 1.0,
    };
    let things = vec![thing(pool, Glass::of(water)), thing(bottom, white)];
    let mut scene = scene(things, |_| Rgb::BLACK);
    scene.ambient = Rgb::WHITE;
    let got = look(&scene, vec3(0.1, 6.0, 0.2), Vec3::NEG_Y, 9).g;
    let exact = (1.0 - fresnel_at_0(1.333)) * (-0.3 * (top - stone)).exp();
    assert!((got - exact).abs() < 1e-4, "{got}, and not {exact}");
}

fn fresnel_at_0(n: f32) -> f32 {
    ((n - 1.0) / (n + 1.0)).powi(2)
}

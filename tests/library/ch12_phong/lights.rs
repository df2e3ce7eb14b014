//! Point and directional lights: units, falloff, ends of the scale.

use crate::ch12_phong::rays::{random_direction, random_scale};
use glam::{Vec2, Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::light::{Light, directional::DirectionalLight, point::PointLight};
use raybook::math::{dir3::Dir3, pcg, ray::Ray};
use std::f32::consts::PI;

#[test]
fn a_point_light_falls_off_with_the_squared_distance() {
    let light = PointLight {
        position: vec3(1.0, 5.0, 1.0),
        intensity: Rgb::new(18.0, 9.0, 0.0),
    };
    for (down, red) in [(0.5, 72.0), (1.0, 18.0), (2.0, 4.5), (3.0, 2.0)] {
        let at = light.position - down * Vec3::Y;
        let sample = light
            .sample(at, Vec2::ZERO)
            .expect("it shines everywhere else");
        assert_eq!(
            sample.arriving,
            Rgb::new(red, red / 2.0, 0.0),
            "I/r² at {down} m"
        );
        assert_eq!(
            (sample.toward, sample.distance),
            (Dir3::Y, down),
            "straight above"
        );
        assert_eq!(sample.pdf, f32::INFINITY, "its direction is no choice");
    }
}

#[test]
fn the_power_through_every_sphere_around_a_point_light_is_the_same() {
    let intensity = Rgb::new(1.0, 2.0, 3.0);
    let mut rng = pcg::stream(12, 2);
    for _ in 0..200 {
        let scale = random_scale(&mut rng);
        let light = PointLight {
            position: Vec3::ZERO,
            intensity,
        };
        let at = scale * *random_direction(&mut rng);
        let sample = light
            .sample(at, Vec2::ZERO)
            .expect("it shines everywhere else");
        let power = sample.arriving * (4.0 * PI * scale * scale);
        let expected = intensity * (4.0 * PI);
        for (got, expected) in power.channels().into_iter().zip(expected.channels()) {
            assert!(
                (got / expected - 1.0).abs() < 1e-5,
                "4πI at {scale} m: {got}, not {expected}"
            );
        }
    }
}

#[test]
fn a_point_light_shines_everywhere_but_on_itself() {
    let light = PointLight {
        position: Vec3::ONE,
        intensity: Rgb::WHITE,
    };
    assert_eq!(
        light.sample(Vec3::ONE, Vec2::ZERO),
        None,
        "there is no direction"
    );
    for nowhere in [Vec3::NAN, Vec3::INFINITY] {
        assert_eq!(
            light.sample(nowhere, Vec2::ZERO),
            None,
            "{nowhere} is not a place"
        );
    }
    let tiny = light.sample(vec3(1.0, 1.0, 1.0 + f32::EPSILON), Vec2::ZERO);
    let tiny = tiny.expect("the next number is another place");
    assert_eq!(tiny.toward, -Dir3::Z, "however near");
    assert!(
        tiny.arriving.r.is_finite() && tiny.arriving.r > 1e13,
        "and very bright there"
    );
}

#[test]
fn a_directional_light_is_the_same_everywhere() {
    let toward = Dir3::new_or(vec3(1.0, 2.0, 3.0), Dir3::Y);
    let irradiance = Rgb::new(3.0, 2.0, 1.0);
    let light = DirectionalLight { toward, irradiance };
    for at in [Vec3::ZERO, Vec3::splat(1e6), Vec3::splat(-1e-6)] {
        let sample = light
            .sample(at, Vec2::splat(0.7))
            .expect("it shines everywhere");
        assert_eq!(
            (sample.toward, sample.arriving),
            (toward, irradiance),
            "at {at}"
        );
        assert_eq!(sample.distance, f32::INFINITY, "it is not of this world");
    }
}

#[test]
fn lights_without_extent_are_neither_seen_nor_met_by_chance() {
    let point = PointLight {
        position: -Vec3::Z,
        intensity: Rgb::WHITE,
    };
    let sun = DirectionalLight {
        toward: -Dir3::Z,
        irradiance: Rgb::WHITE,
    };
    for light in [&point as &dyn Light, &sun] {
        let ray = Ray::new(Vec3::ZERO, -Dir3::Z);
        assert_eq!(
            light.seen(&ray, f32::INFINITY),
            None,
            "even by a ray that goes straight to it"
        );
        assert_eq!(
            light.pdf(Vec3::ZERO, -Dir3::Z),
            0.0,
            "no other way to choose directions meets it"
        );
    }
}

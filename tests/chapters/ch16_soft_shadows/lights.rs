//! The lights: what arrives from them.

use crate::ch16_soft_shadows::support::{BOTH, lattice, rect, sphere};
use glam::{Vec3, vec3};
use raybook::light::Light;
use raybook::light::extent::LightSampling;
use raybook::math::dir3::Dir3;
use raybook::math::domain::LARGEST;
use std::f32::consts::{PI, TAU};

/// What arrives on a patch at the origin that faces up, as the mean over a lattice.
fn irradiance(light: &dyn Light, normal: Vec3) -> f64 {
    let n = 400;
    let sum: f64 = lattice(n)
        .filter_map(|u| light.sample(Vec3::ZERO, u))
        .map(|s| f64::from(s.arriving.g * s.toward.dot(normal).max(0.0)))
        .sum();
    sum / f64::from(n * n)
}

/// π times the view factor from a patch to a parallel rectangle whose corner is above it (Howell, *A catalog of
/// radiation heat transfer configuration factors*, B-3): x = a/h, y = b/h.
fn parallel(x: f64, y: f64) -> f64 {
    let part = |x: f64, y: f64| x / (1.0 + x * x).sqrt() * (y / (1.0 + x * x).sqrt()).atan();
    0.5 * (part(x, y) + part(y, x))
}

#[test]
fn a_rectangle_sheds_as_much_light_as_its_view_factor_says() {
    for choose in BOTH {
        let light = rect(vec3(0.0, 2.0, 0.0), 1.5 * Vec3::X, 3.0 * Vec3::Z, choose);
        // a × b points down: X × Z = −Y.
        let (got, exact) = (irradiance(&light, Vec3::Y), parallel(0.75, 1.5));
        assert!(
            (got / exact - 1.0).abs() < 1e-4,
            "{choose:?}: {got} W/m² arrive, and {exact} should"
        );
    }
}

#[test]
fn a_sphere_sheds_as_much_light_as_its_solid_angle_says() {
    for choose in BOTH {
        // π L sin²α from straight above, π L from everywhere.
        let above = irradiance(&sphere(3.0 * Vec3::Y, 1.0, choose), Vec3::Y);
        let around = irradiance(&sphere(vec3(0.2, 0.0, 0.3), 1.0, choose), Vec3::Y);
        let [above, around] = [above * 9.0, around].map(|e| e / f64::from(PI));
        assert!((above - 1.0).abs() < 1e-3, "{choose:?}: {above} of π sin²α");
        assert!(
            (around - 1.0).abs() < 2e-3,
            "{choose:?}, inside: {around} of π"
        );
    }
}

#[test]
fn nothing_comes_from_the_back_of_a_rectangle_or_from_none() {
    for choose in BOTH {
        let back = rect(vec3(-0.5, 1.0, -0.5), Vec3::Z, Vec3::X, choose);
        let level = rect(vec3(1.0, 0.0, 0.0), Vec3::X, Vec3::Z, choose);
        let needle = rect(Vec3::Y, Vec3::X, Vec3::X, choose);
        for light in [back, level, needle] {
            for u in lattice(8) {
                assert_eq!(light.sample(Vec3::ZERO, u), None, "{choose:?}: {light:?}");
            }
            assert_eq!(light.pdf(Vec3::ZERO, Dir3::Y), 0.0, "{choose:?}: {light:?}");
        }
    }
}

#[test]
fn tiny_huge_and_distant_lights_keep_their_solid_angle() {
    for scale in [1e-6_f32, 1e-3, 1.0, 1e3, 1e6] {
        for choose in BOTH {
            for (size, away) in [(1.0, 1.0), (1e-3, 1.0), (1.0, 1e4), (1e3, 1.0)] {
                if choose == LightSampling::ByArea && size > away {
                    continue; // few of a huge light's points are near
                }
                let (size, away) = (size * scale, away * scale);
                if away + size > LARGEST {
                    continue; // outside the domain of shapes
                }
                let corner = vec3(-0.5 * size, away, -0.5 * size);
                let square = rect(corner, size * Vec3::X, size * Vec3::Z, choose);
                let n = 200;
                let sum: f64 = lattice(n)
                    .filter_map(|u| square.sample(Vec3::ZERO, u))
                    .map(|s| f64::from(s.arriving.g))
                    .sum();
                let solid_angle = sum / f64::from(n * n);
                let half = 0.5 * f64::from(size / away);
                let exact = 4.0 * (half * half / (1.0 + half * half)).asin();
                assert!(
                    (solid_angle / exact - 1.0).abs() < 1e-3,
                    "{choose:?}: a square of {size} m, {away} m away, has {solid_angle} sr, not {exact}"
                );
                let ball = sphere((away + size) * Vec3::Y, size, choose);
                let sum: f64 = lattice(n)
                    .filter_map(|u| ball.sample(Vec3::ZERO, u))
                    .map(|s| f64::from(s.arriving.g))
                    .sum();
                let solid_angle = sum / f64::from(n * n);
                let sin2 = (f64::from(size) / f64::from(away + size)).powi(2);
                let exact = f64::from(TAU) * sin2 / (1.0 + (1.0 - sin2).sqrt());
                assert!(
                    (solid_angle / exact - 1.0).abs() < 5e-3,
                    "{choose:?}: a sphere of {size} m, {away} m away, has {solid_angle} sr, not {exact}"
                );
            }
        }
    }
}

//! The densities with which directions to lights are chosen.

use crate::ch16_soft_shadows::support::{lattice, lights};
use glam::{Vec3, vec2};
use rand::RngExt;
use raybook::image::rgb::Rgb;
use raybook::light::LightHit;
use raybook::math::{dir3::Dir3, pcg, ray::Ray};
use std::f32::consts::TAU;

#[test]
fn the_density_of_directions_integrates_to_1() {
    for (name, light, directions) in lights() {
        let integral: f64 = directions(1500)
            .iter()
            .map(|(d, solid_angle)| f64::from(light.pdf(Vec3::ZERO, *d)) * solid_angle)
            .sum();
        assert!(
            (integral - 1.0).abs() < 0.015,
            "{name}: the density integrates to {integral} over all directions"
        );
    }
}

#[test]
fn a_sample_knows_its_density_its_distance_and_what_arrives() {
    for (name, light, _) in lights() {
        let mut told = 0;
        for u in lattice(40) {
            let sample = light.sample(Vec3::ZERO, u).expect("all are seen from here");
            let (pdf, ray) = (
                light.pdf(Vec3::ZERO, sample.toward),
                Ray::new(Vec3::ZERO, sample.toward),
            );
            // At the rim of the sphere the last digit of the direction decides on which point is met.
            let Some(LightHit { t, radiance, .. }) = light.seen(&ray, f32::INFINITY) else {
                continue;
            };
            told += u32::from(
                (t - sample.distance).abs() < 2e-3 * t && (pdf - sample.pdf).abs() < 0.05 * pdf,
            );
            assert_eq!(radiance, Rgb::WHITE, "{name}: it shines equally everywhere");
            let product = sample.arriving.g * sample.pdf;
            assert!(
                (product - 1.0).abs() < 1e-5,
                "{name}: what arrives is the radiance over the density, not {product} times"
            );
        }
        assert!(
            told >= 1590,
            "{name}: of 1600 samples, {told} have the density and the distance of their direction"
        );
    }
}

/// Samples fall into the cells of a lattice on the sphere as often as the density says.
#[test]
fn samples_follow_their_density() {
    const CELLS: usize = 16;
    const SAMPLES: usize = 200_000;
    for (name, light, directions) in lights() {
        let cell = |d: Dir3| {
            let u = vec2(0.5 - 0.5 * d.z, d.y.atan2(d.x) / TAU + 0.5);
            let place = (u * CELLS as f32).as_uvec2().min(glam::UVec2::splat(15));
            place.y as usize * CELLS + place.x as usize
        };
        let mut expected = vec![0.0_f64; CELLS * CELLS];
        for (d, solid_angle) in directions(2000) {
            let share = f64::from(light.pdf(Vec3::ZERO, d)) * solid_angle;
            expected[cell(d)] += share * SAMPLES as f64;
        }
        let mut found = vec![0.0_f64; CELLS * CELLS];
        let mut rng = pcg::stream(16, 0);
        for _ in 0..SAMPLES {
            let sample = light.sample(Vec3::ZERO, vec2(rng.random(), rng.random()));
            found[cell(sample.expect("all are seen from here").toward)] += 1.0;
        }
        let (mut chi, mut cells) = (0.0, 0.0);
        for (expected, found) in expected.iter().zip(&found) {
            if *expected > 50.0 {
                chi += (found - expected).powi(2) / expected;
                cells += 1.0;
            }
        }
        // χ² has mean `cells` and variance 2·cells; the expected numbers are themselves off by up to 1 in a thousand.
        let z = (chi - cells) / f64::sqrt(2.0 * cells);
        assert!(z < 6.0, "{name}: χ² over {cells} cells is {chi:.0}");
    }
}

//! Directions are as likely as their densities say, around any normal.

use crate::ch17_rendering_equation::{direction, integral, square};
use glam::Vec2;
use raybook::math::pcg;
use raybook::math::{basis::Basis, dir3::Dir3};
use raybook::sample::hemisphere::{
    UNIFORM, cosine_hemisphere, cosine_pdf, lobe, lobe_pdf, uniform_hemisphere,
};
use raybook_common::statistics::Mean;
use std::f64::consts::{PI, TAU};

type Warp = fn(Dir3, Vec2) -> Dir3;
type Density = fn(f32) -> f32;

/// Name, warp, its density by the cosine, and the mean of the cosine.
const WARPS: [(&str, Warp, Density, f64); 4] = [
    ("uniform", uniform_hemisphere, |_| UNIFORM, 0.5),
    ("cosine", cosine_hemisphere, cosine_pdf, 2.0 / 3.0),
    (
        "lobe of exponent 0",
        |n, u| lobe(n, 0.0, u),
        |c| lobe_pdf(c, 0.0),
        0.5,
    ),
    (
        "lobe of exponent 20",
        |n, u| lobe(n, 20.0, u),
        |c| lobe_pdf(c, 20.0),
        21.0 / 22.0,
    ),
];

#[test]
fn directions_lie_above_the_surface_and_around_the_normal() {
    for (x, y, z) in [
        (0.0, 0.0, 1.0),
        (0.0, 0.0, -1.0),
        (0.3, -0.8, 0.5),
        (-1.0, 0.0, 0.0),
    ] {
        let normal = direction(x, y, z);
        let basis = Basis::around(normal);
        for (name, warp, _, mean) in WARPS {
            let along = |axis: Dir3| {
                Mean::sampled(1, 2000, |rng| {
                    let d = warp(normal, square(rng));
                    assert!(d.dot(*normal) >= 0.0, "{name}: {d:?} is below");
                    assert!((d.length() - 1.0).abs() < 1e-5, "{name}: {d:?} is a unit");
                    d.dot(*axis) + 1.0
                })
            };
            along(normal).assert_is(1.0 + mean, name);
            along(basis.x).assert_is(1.0, "as much to one side as to the other");
            along(basis.y).assert_is(1.0, "as much forward as back");
        }
    }
}

#[test]
fn densities_integrate_to_one() {
    for (name, _, pdf, _) in WARPS {
        let sum = integral(|d| pdf(d.z));
        assert!((sum - 1.0).abs() < 2e-4, "{name}: ∫ p dω = {sum}");
    }
}

/// χ² of rings × sectors of equal probability, under a density.
fn chi_squared(warp: Warp, share_above: fn(f64) -> f64) -> f64 {
    const CELLS: usize = 16;
    const N: usize = 40_000;
    let mut rng = pcg::stream(7, 7);
    let mut counts = [0_u32; CELLS * CELLS];
    for _ in 0..N {
        let d = warp(Dir3::Z, square(&mut rng));
        let ring = (share_above(f64::from(d.z)) * CELLS as f64) as usize;
        let turn = f64::from(d.y).atan2(f64::from(d.x)) / TAU + 0.5;
        let sector = (turn * CELLS as f64) as usize;
        counts[ring.min(CELLS - 1) * CELLS + sector.min(CELLS - 1)] += 1;
    }
    let expected = N as f64 / (CELLS * CELLS) as f64;
    let square_of = |&n: &u32| (f64::from(n) - expected).powi(2) / expected;
    counts.iter().map(square_of).sum()
}

#[test]
fn rings_and_sectors_of_equal_probability_hold_equally_many() {
    // 255 degrees of freedom: mean 255, standard deviation 22.6; chance exceeds 370 once in a million times.
    let cosine = chi_squared(cosine_hemisphere, |z| 1.0 - z * z);
    let uniform = chi_squared(uniform_hemisphere, |z| 1.0 - z);
    let lobe = chi_squared(|n, u| lobe(n, 20.0, u), |z| 1.0 - z.powi(21));
    let wrong = chi_squared(uniform_hemisphere, |z| 1.0 - z * z);
    for (name, x) in [("cosine", cosine), ("uniform", uniform), ("lobe", lobe)] {
        assert!((160.0..370.0).contains(&x), "{name}: χ² = {x}");
    }
    assert!(wrong > 1000.0, "uniform is not by the cosine: χ² = {wrong}");
}

#[test]
fn a_sky_of_radiance_one_lights_a_field_with_pi() {
    let uniform = Mean::sampled(2, 2000, |rng| {
        uniform_hemisphere(Dir3::Z, square(rng)).z / UNIFORM
    });
    uniform.assert_is(PI, "∫ cos θ dω by uniform directions");
    let cosine = Mean::sampled(2, 2000, |rng| {
        let z = cosine_hemisphere(Dir3::Z, square(rng)).z;
        z / cosine_pdf(z)
    });
    cosine.assert_is(PI, "∫ cos θ dω by the cosine");
    assert!(cosine.error < 1e-5, "whose every sample is π: {cosine:?}");
}

#[test]
fn a_sky_of_cosine_to_the_n_lights_a_field_with_two_pi_over_n_plus_two() {
    for n in [1, 2, 5, 40] {
        let exact = TAU / f64::from(n + 2);
        for (name, warp, pdf, _) in WARPS {
            let irradiance = Mean::sampled(3, 20_000, |rng| {
                let z = warp(Dir3::Z, square(rng)).z;
                z.powi(n) * z / pdf(z)
            });
            // A narrow lobe hardly ever looks sideways, where a wide sky is: right in the mean, and useless.
            if irradiance.error < 0.01 * exact {
                irradiance.assert_is(exact, &format!("cos^{n} by {name}"));
            } else {
                assert!(name.ends_with("20"), "cos^{n} by {name}: {irradiance:?}");
            }
        }
    }
}

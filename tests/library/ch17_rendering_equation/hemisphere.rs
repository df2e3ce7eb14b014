//! Directions are as likely as their densities say, around any normal.

use crate::ch17_rendering_equation::cells::Cells;
use crate::ch17_rendering_equation::{direction, integral, square};
use glam::Vec2;
use raybook::math::{basis::Basis, dir3::Dir3, pcg::Pcg};
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

#[test]
fn directions_are_as_likely_as_their_density_says() {
    let above = |pdf: Density| move |d: Dir3| if d.z > 0.0 { pdf(d.z) } else { 0.0 };
    let cells = Cells::around(Dir3::Z);
    for (name, warp, pdf, _) in WARPS {
        let sample = |rng: &mut Pcg| Some(warp(Dir3::Z, square(rng)));
        cells.fit(above(pdf), sample).assert_good(name);
        for (other, _, wrong, _) in WARPS {
            let same = (pdf(0.3) - wrong(0.3)).abs() < 1e-6;
            let fits = cells.fit(above(wrong), sample).is_good();
            assert_eq!(fits, same, "directions of {name} by the density of {other}");
        }
    }
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

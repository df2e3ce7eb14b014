//! How fast the errors of sampling patterns fall, as published.

use glam::Vec2;
use rand::RngExt;
use raybook::math::pcg::{self, Pcg};
use raybook::sample::pattern::find;
use raybook_common::statistics::slope;
use std::f64::consts::PI;

/// A pattern, and the powers of the number of points with which its RMS errors fall, half of those of the variance: of smooth functions,
/// and of functions with an edge, if that is published.
///
/// - random and jittered: Mitchell, "Consequences of stratified sampling in graphics" (1996), abstract: the variance of stratified
///   samples falls with the power −2 where a function is smooth, and with −3/2 in pixels with edges, that of random samples with −1.
/// - Poisson disks: Pilleboue et al., "Variance analysis for Monte Carlo integration" (2015): the variance falls no faster than that of
///   random points, because the power spectrum does not vanish at low frequencies.
/// - Sobol's points, scrambled: Owen, "Scrambled net variance for integrals of smooth functions" (1997), abstract: the variance falls
///   with the power −3, but for a logarithm.
const SLOPES: [(&str, f64, Option<f64>); 4] = [
    ("random", -0.5, Some(-0.5)),
    ("jittered", -1.0, Some(-0.75)),
    ("poisson-disk", -0.5, Some(-0.5)),
    ("sobol-owen", -1.5, None),
];

/// Numbers of points.
const COUNTS: [usize; 4] = [64, 256, 1024, 4096];

/// Realisations of each, so that an RMS error is known to 1/√(2 · 100) = 7 %, and a slope to 0.02.
const SEEDS: u64 = 100;

/// The largest difference to the powers, which hold for very many points: Poisson disks of these numbers are up to 0.1 better.
const NEARLY: f64 = 0.1;

/// The error of the mean of e^(ax + by) over the points.
fn smooth(points: &[Vec2], rng: &mut Pcg) -> f64 {
    let [a, b] = [(); 2].map(|()| rng.random_range(0.5..2.0));
    let exact = f64::exp_m1(a) / a * f64::exp_m1(b) / b;
    let value = |p: &Vec2| (a * f64::from(p.x) + b * f64::from(p.y)).exp();
    points.iter().map(value).sum::<f64>() / points.len() as f64 - exact
}

/// The error of the share of the points that lie in a disc.
fn edge(points: &[Vec2], rng: &mut Pcg) -> f64 {
    let centre = Vec2::from([(); 2].map(|()| rng.random_range(0.4..0.6)));
    let radius = rng.random_range(0.2..0.4_f32);
    let inside = points.iter().filter(|p| p.distance(centre) < radius);
    inside.count() as f64 / points.len() as f64 - PI * f64::from(radius).powi(2)
}

#[test]
fn errors_fall_with_the_published_powers() {
    for (name, of_smooth, of_edge) in SLOPES {
        let pattern = find(name).expect("there is this pattern");
        let logarithms = COUNTS.map(|n| {
            let [mut smooths, mut edges] = [0.0; 2];
            for seed in 0..SEEDS {
                let mut rng = pcg::stream(seed, n as u64);
                let points = (pattern.points)(n, &mut rng);
                smooths += smooth(&points, &mut rng).powi(2);
                edges += edge(&points, &mut rng).powi(2);
            }
            [smooths, edges].map(|squares| ((n as f64).ln(), 0.5 * squares.ln()))
        });
        for (what, i, published) in [
            ("a smooth function", 0, Some(of_smooth)),
            ("a disc", 1, of_edge),
        ] {
            let Some(published) = published else { continue };
            let (got, _) = slope(&logarithms.map(|both| both[i]));
            println!("{name}, {what}: {got:.3}, published {published}");
            assert!(
                (got - published).abs() < NEARLY,
                "{name}, {what}: {got}, not {published}"
            );
        }
    }
}

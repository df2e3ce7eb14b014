//! Discrepancies: against their definitions, and in the mean.

use super::points;
use glam::{Vec2, vec2};
use raybook_chapters::lab::discrepancy::{l2_star_squared, star};

/// The share of points in a box from the origin, less its area, for all boxes of a raster.
fn local(points: &[Vec2], raster: u32) -> impl Iterator<Item = f64> + '_ {
    (0..raster * raster).map(move |i| {
        let corner = (vec2((i % raster) as f32, (i / raster) as f32) + 0.5) / raster as f32;
        let inside = points.iter().filter(|p| p.cmplt(corner).all()).count();
        inside as f64 / points.len() as f64 - f64::from(corner.x) * f64::from(corner.y)
    })
}

#[test]
fn the_formulas_agree_with_the_definitions() {
    for name in ["random", "jittered", "halton"] {
        let points = points(name, 30, 2);
        let by_raster = local(&points, 300).map(|d| d * d).sum::<f64>() / 90_000.0;
        let exact = l2_star_squared(&points);
        assert!(
            (by_raster / exact - 1.0).abs() < 0.03,
            "{name}: {by_raster}, {exact}"
        );
        let largest = local(&points, 300).map(f64::abs).fold(0.0, f64::max);
        let exact = star(&points);
        assert!(
            largest <= exact + 1e-9,
            "{name}: no box is worse than the worst"
        );
        assert!(largest > 0.93 * exact, "{name}: {largest}, exactly {exact}");
    }
    let one = [vec2(0.5, 0.5)];
    assert!(
        (star(&one) - 0.75).abs() < 1e-6,
        "the closed box up to the point: 1 − ¼"
    );
}

#[test]
fn the_mean_l2_star_discrepancy_is_what_theory_says() {
    const RUNS: u64 = 4000;
    let mean = |name: &str, n: usize| {
        let sum: f64 = (0..RUNS)
            .map(|seed| l2_star_squared(&points(name, n, seed)))
            .sum();
        sum / RUNS as f64
    };
    for side in [2.0, 4.0, 6.0_f64] {
        let n = side * side;
        let exact = 5.0 / (36.0 * n);
        let got = mean("random", n as usize);
        assert!(
            (got / exact - 1.0).abs() < 0.06,
            "random, {n}: {got}, {exact}"
        );
        let exact = ((side - 1.0) / 6.0 + 5.0 / 36.0) / side.powi(4);
        let got = mean("jittered", n as usize);
        assert!(
            (got / exact - 1.0).abs() < 0.06,
            "jittered, {n}: {got}, {exact}"
        );
    }
}

//! Edges: the covered area, and how far a pattern is off.

use super::{points, subject};
use glam::DVec2;
use raybook_chapters::lab::edge;
use raybook_chapters::lab::edge::Edge;
use raybook_chapters::lab::subject::Subject;
use std::f64::consts::{FRAC_PI_2, PI};

/// The error of n points at edges of an angle.
fn rms(subject: &Subject, n: usize, angle: f64, realisations: u64) -> f64 {
    let drawn: Vec<_> = (0..realisations).map(|k| subject.points(n, k)).collect();
    edge::rms(&drawn, angle)
}

#[test]
fn the_covered_area_is_that_of_a_fine_grid() {
    let grid = points("regular-grid", 250_000, 0);
    for degrees in [0.0, 10.0, 26.565, 45.0, 80.0, 90.0, 135.0, 200.0_f64] {
        let normal = DVec2::from_angle(degrees.to_radians());
        for offset in [-0.8, -0.5, -0.31, 0.0, 0.12, 0.45, 0.66] {
            let edge = Edge { normal, offset };
            let covered = grid.iter().filter(|p| edge.covers(**p)).count() as f64 / 250_000.0;
            let off = (covered - edge.coverage()).abs();
            assert!(
                off < 2e-3,
                "{degrees}°, {offset}: {covered} or {}",
                edge.coverage()
            );
        }
    }
}

#[test]
fn a_vertical_edge_swept_over_a_grid_is_off_by_its_column_over_root_twelve() {
    for n in [1_usize, 2, 4, 8] {
        let exact = 1.0 / (n as f64 * 12.0_f64.sqrt());
        let got = rms(&subject("regular-grid"), n * n, 0.0, 1);
        assert!(
            (got / exact - 1.0).abs() < 1e-3,
            "{n}: {got}, exactly {exact}"
        );
        let got = rms(&subject("regular-grid"), n * n, FRAC_PI_2, 1);
        assert!((got / exact - 1.0).abs() < 1e-3, "{n}, horizontal: {got}");
    }
}

#[test]
fn the_rotated_grid_moves_the_worst_angle_and_is_not_better_in_the_mean() {
    let of = |name| -> Vec<f64> {
        (0..1800)
            .map(|i| rms(&subject(name), 4, PI * f64::from(i) / 1800.0, 1))
            .collect()
    };
    let (regular, rotated) = (of("regular-grid"), of("rotated-grid"));
    let mean = |errors: &[f64]| errors.iter().sum::<f64>() / errors.len() as f64;
    let worst = |errors: &[f64]| errors.iter().copied().fold(0.0, f64::max);
    for (name, got, exact) in [
        ("mean of the regular grid", mean(&regular), 0.0862),
        ("mean of the rotated grid", mean(&rotated), 0.0894),
        ("worst of the regular grid", worst(&regular), 0.1444),
        ("worst of the rotated grid", worst(&rotated), 0.1328),
    ] {
        assert!((got - exact).abs() < 2e-4, "{name}: {got:.5}, not {exact}");
    }
    assert!(
        rotated[0] < 0.6 * regular[0],
        "along the axes it is much better"
    );
}

#[test]
fn at_four_samples_every_random_pattern_loses_to_the_grid_in_the_mean() {
    let of = |name| {
        let angles = (0..18).map(|i| rms(&subject(name), 4, PI * f64::from(i) / 18.0, 60));
        angles.sum::<f64>() / 18.0
    };
    let grid = of("regular-grid");
    for name in [
        "random",
        "jittered",
        "poisson-disk",
        "sobol-owen",
        "n-rooks",
    ] {
        let error = of(name);
        assert!(error > grid, "{name}: {error:.4}, the grid {grid:.4}");
    }
}

//! Projections on the axes.

use super::{points, subject};
use glam::vec2;
use raybook_chapters::lab::projection::{Onto, filled, histogram};
use raybook_chapters::lab::spectrum::Spectrum;

#[test]
fn each_interval_counts_its_points() {
    let three = [vec2(0.1, 0.9), vec2(0.2, 0.4), vec2(0.99, 0.5)];
    assert_eq!(histogram(&three, Onto::X), [2, 0, 1], "thirds of x");
    assert_eq!(histogram(&three, Onto::Y), [0, 2, 1], "thirds of y");
    assert!(
        (filled(&three, Onto::X) - 2.0 / 3.0).abs() < 1e-12,
        "two of three"
    );
}

#[test]
fn rooks_fill_every_column_a_grid_a_few_and_chance_two_thirds() {
    let share = |name: &str, onto| {
        let runs = (0..100).map(|seed| filled(&points(name, 64, seed), onto));
        runs.sum::<f64>() / 100.0
    };
    for onto in [Onto::X, Onto::Y] {
        let rooks = share("n-rooks", onto);
        assert!((rooks - 1.0).abs() < 1e-9, "{onto:?}: {rooks}");
        let grid = share("regular-grid", onto);
        assert!((grid - 0.125).abs() < 1e-9, "8 of 64, {onto:?}: {grid}");
        let random = share("random", onto);
        let exact = 1.0 - (63.0_f64 / 64.0).powi(64);
        assert!(
            (random - exact).abs() < 0.015,
            "{onto:?}: {random}, {exact}"
        );
    }
}

#[test]
fn the_projection_of_rooks_has_the_power_of_jittered_points_on_a_line() {
    let n = 16;
    let spectrum = Spectrum::of(&subject("n-rooks"), n, 8, 2000);
    for f in 1..=8 {
        let t = std::f64::consts::PI * f64::from(f) / n as f64;
        let exact = 1.0 - (t.sin() / t).powi(2);
        for power in [spectrum.at(f, 0), spectrum.at(0, f)] {
            assert!(
                (power - exact).abs() < 0.14 * exact + 1e-3,
                "{f}: {power}, {exact}"
            );
        }
    }
}

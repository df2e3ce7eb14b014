//! Errors of means: their exact variances, and how fast they fall.

use super::{points, subject};
use glam::Vec2;
use raybook::math::pcg;
use raybook_chapters::lab::errors::{EACH, Error, errors, slope};
use raybook_chapters::lab::integrands::{CLASSES, Integrand};

/// Functions of a class.
#[track_caller]
fn members(name: &str, count: usize) -> Vec<Integrand> {
    let class = CLASSES.iter().find(|class| class.name == name);
    let class = class.expect("it is there");
    class.members(count, &mut pcg::stream(3, 4))
}

/// The variance of the mean of f over n points, measured.
fn variance(name: &str, n: usize, f: fn(Vec2) -> f64, exact: f64) -> f64 {
    const RUNS: u64 = 20_000;
    let squares = (0..RUNS).map(|seed| {
        let sum: f64 = points(name, n, seed).into_iter().map(f).sum();
        (sum / n as f64 - exact).powi(2)
    });
    squares.sum::<f64>() / RUNS as f64
}

/// Of 20 000 runs a variance is known to 1 % (one standard deviation): √(2/20000).
const KNOWN: f64 = 0.05;

#[test]
fn the_variance_of_x_times_y_is_what_theory_says() {
    let f = |p: Vec2| f64::from(p.x) * f64::from(p.y);
    for side in [1.0, 2.0, 4.0_f64] {
        let n = side * side;
        let random = variance("random", n as usize, f, 0.25);
        let exact = 7.0 / (144.0 * n);
        assert!(
            (random / exact - 1.0).abs() < KNOWN,
            "random, {n}: {random}, {exact}"
        );
        let jittered = variance("jittered", n as usize, f, 0.25);
        let exact = 1.0 / (18.0 * n * n) - 1.0 / (144.0 * n * n * n);
        assert!(
            (jittered / exact - 1.0).abs() < KNOWN,
            "jittered, {n}: {jittered}, {exact}"
        );
    }
}

#[test]
fn the_variance_of_a_step_under_jittering_is_that_of_its_column() {
    let exact_mean = std::f64::consts::FRAC_1_PI;
    for side in [2.0, 3.0, 5.0_f64] {
        let p = (side * exact_mean).fract();
        let exact = p * (1.0 - p) / side.powi(3);
        let f = |p: Vec2| f64::from(u8::from(f64::from(p.x) < std::f64::consts::FRAC_1_PI));
        let got = variance("jittered", (side * side) as usize, f, exact_mean);
        assert!(
            (got / exact - 1.0).abs() < KNOWN,
            "{side}: {got}, exactly {exact}"
        );
    }
}

/// Slopes that nobody has published; those that are published are in `tests/library/published/slopes.rs`.
#[test]
fn errors_fall_as_fast_as_they_should() {
    // A full Poisson disk keeps the same share of the power of random points at the lowest frequencies however many points it
    // has (`spectra.rs`), and so comes near −½ in the end; its two slopes are those of this library. Others of the same fullness have −0.50 to
    // −0.60: Bridson's, darts, best candidate, of exactly n points or about n, over the edges or not. Steeper ones, −0.7, take a
    // pattern that becomes fuller the more points it has: darts of which n may miss in a row have −0.63. That is n² darts.
    // The other slopes were measured elsewhere, for one function of each class and by 400 seeds.
    for (name, of, expected) in [
        ("poisson-disk", "disc edge", -0.57),
        ("sobol-owen", "disc edge", -0.78),
        ("multi-jittered", "smooth", -1.04),
        ("poisson-disk", "smooth", -0.56),
    ] {
        let class = [members(of, 60 * EACH)];
        let by_count = [64, 256, 1024, 4096].map(|n| errors(&subject(name), n, &class, 60)[0]);
        let got = slope(&by_count).expect("four counts");
        println!("{name} {of}: {got:?}, expected {expected}");
        assert!(
            (got.slope - expected).abs() < 0.1,
            "{name}, {of}: {got:?}, not {expected}"
        );
        assert!(got.within < 0.25, "a straight line: {got:?}");
    }
}

#[test]
fn the_means_are_right() {
    let grid = points("regular-grid", 250_000, 0);
    for class in CLASSES {
        for f in members(class.name, 6) {
            let off = f.error(&grid).abs();
            assert!(off < 1.5e-3, "{f:?}: off by {off}");
        }
    }
}

#[test]
fn a_class_has_members_of_every_kind_and_the_same_ones_for_a_seed() {
    for class in CLASSES {
        let some = members(class.name, 50);
        let means: Vec<_> = some.iter().map(|f| f.mean).collect();
        let low = means.iter().copied().fold(1.0, f64::min);
        let high = means.iter().copied().fold(0.0, f64::max);
        assert!(low < 0.5 && high > 0.5, "{}: {low} … {high}", class.name);
        let again: Vec<_> = members(class.name, 50).iter().map(|f| f.mean).collect();
        assert_eq!(means, again, "{}", class.name);
        let halves = means.iter().filter(|mean| (**mean - 0.5).abs() < 1e-6);
        assert_eq!(halves.count(), 0, "{}: no lucky half", class.name);
    }
}

#[test]
fn half_of_the_draws_are_below_the_median_and_a_tenth_outside_each_end_of_the_band() {
    let class = [members("straight edge", 400 * EACH)];
    let Error {
        median,
        low,
        high,
        rms,
        ..
    } = errors(&subject("random"), 64, &class, 400)[0];
    assert!(
        low < median && median < rms && rms < high,
        "{low} {median} {rms} {high}"
    );
    // Errors of random points are normal: |e| has its median at 0.6745 σ and its 90 % quantile at 1.645 σ. Edges differ in σ, which makes both a little
    // wider apart.
    let ratio = high / median;
    assert!(
        (2.4..4.0).contains(&ratio),
        "1.645/0.6745 = 2.44 and more: {ratio}"
    );
}

#[test]
fn a_fitted_slope_knows_how_well_it_is_known() {
    let exact = [16, 64, 128, 256, 512].map(|n| Error::exactly(n, (n as f64).powf(-0.75)));
    let fit = slope(&exact).expect("four of 64 and more");
    assert!(
        (fit.slope + 0.75).abs() < 1e-9 && fit.within < 1e-9,
        "{fit:?}"
    );
    // Points 1.1 above and below in turns: by hand, with x = 0, 1, 2, 3 ln 2: the slope is off by −0.2·ln 1.1/ln 2·2 = −0.055.
    let zigzag = [64, 128, 256, 512].map(|n| {
        let off = if n == 64 || n == 256 { 1.1 } else { 1.0 / 1.1 };
        Error::exactly(n, off * (n as f64).powf(-0.75))
    });
    let fit = slope(&zigzag).expect("four");
    assert!((fit.slope + 0.75 + 0.055).abs() < 1e-3, "{fit:?}");
    assert!((0.2..0.5).contains(&fit.within), "hardly known: {fit:?}");
    assert_eq!(slope(&exact[..3]), None, "two points are no evidence");
}

//! Power spectra, against their exact expectations.

use super::subject;
use raybook_chapters::lab::spectrum::Spectrum;
use std::f64::consts::PI;

/// Realisations: the power of one has a standard deviation of about itself, so their mean is known to 1/√m = 2.2 %.
const RUNS: u64 = 2000;

#[test]
fn random_points_have_the_power_1_everywhere_but_at_0() {
    let spectrum = Spectrum::of(&subject("random"), 16, 8, RUNS);
    assert!((spectrum.at(0, 0) - 16.0).abs() < 1e-9, "n at 0");
    for (x, y) in frequencies(8) {
        let power = spectrum.at(x, y);
        assert!((power - 1.0).abs() < 0.13, "({x}, {y}): {power}");
    }
}

#[test]
fn jittered_points_lack_what_a_cell_takes() {
    let n = 4;
    let spectrum = Spectrum::of(&subject("jittered"), n * n, 8, RUNS);
    let sinc = |x: f64| {
        if x == 0.0 {
            1.0
        } else {
            (PI * x).sin() / (PI * x)
        }
    };
    for (x, y) in frequencies(8) {
        let cells = |f: i32| sinc(f64::from(f) / n as f64).powi(2);
        let exact = 1.0 - cells(x) * cells(y);
        let power = spectrum.at(x, y);
        // 6 standard deviations of an exponential distribution.
        assert!(
            (power - exact).abs() < 0.14 * exact + 1e-9,
            "({x}, {y}): {power}, {exact}"
        );
    }
}

#[test]
fn a_grid_answers_to_its_own_frequency_only() {
    let spectrum = Spectrum::of(&subject("regular-grid"), 16, 8, 1);
    for (x, y) in frequencies(8) {
        let expected = if x % 4 == 0 && y % 4 == 0 { 16.0 } else { 0.0 };
        let power = spectrum.at(x, y);
        assert!((power - expected).abs() < 1e-6, "({x}, {y}): {power}");
    }
}

#[test]
fn a_poisson_disk_is_quiet_near_0_and_the_same_in_all_directions() {
    let disk = Spectrum::of(&subject("poisson-disk"), 64, 16, 400);
    let radial = disk.radial();
    assert!(radial[1].1 < 0.25, "hardly any power at 2: {}", radial[1].1);
    assert!(
        radial[8].1 > 1.1,
        "a ring where the points' distance is one wave"
    );
    let rooks = Spectrum::of(&subject("n-rooks"), 64, 16, 400);
    let mean = |spectrum: &Spectrum| {
        let all = spectrum.anisotropy();
        all.iter().map(|p| p.1).sum::<f64>() / all.len() as f64
    };
    let (disk, rooks) = (mean(&disk), mean(&rooks));
    assert!(disk < 0.01, "1/400 for chance alone; {disk}");
    assert!(rooks > 5.0 * disk, "n-rooks prefer the axes: {rooks}");
}

#[test]
fn of_more_points_a_poisson_disk_is_no_quieter_near_0() {
    let lowest = |name, n| {
        let radial = Spectrum::of(&subject(name), n, 3, 400).radial();
        radial.iter().map(|ring| ring.1).sum::<f64>() / 3.0
    };
    let [few, many] = [64, 1024].map(|n| lowest("poisson-disk", n));
    assert!(
        (0.03..0.12).contains(&many),
        "of random points' power: {many}"
    );
    // 28 frequencies of 400 realisations: known to 1 %, and then there is the bend towards the first ring.
    assert!(
        (few / many - 1.0).abs() < 0.3,
        "64 points: {few}, 1024: {many}"
    );
    let [few, many] = [64, 1024].map(|n| lowest("jittered", n));
    assert!(
        few > 8.0 * many,
        "jittered ones are, 16 times: {few}, {many}"
    );
}

fn frequencies(limit: i32) -> impl Iterator<Item = (i32, i32)> {
    let all = (-limit..=limit).flat_map(move |y| (-limit..=limit).map(move |x| (x, y)));
    all.filter(|f| *f != (0, 0))
}

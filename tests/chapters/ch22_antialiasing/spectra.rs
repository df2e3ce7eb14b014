//! Power spectra, against their exact expectations.

use super::subject;
use raybook_chapters::lab::nyquist::{effective_nyquist, oscillation};
use raybook_chapters::lab::pair_correlation::pair_correlation;
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
    assert!(
        radial[1].value < 0.25,
        "hardly any power at 2: {}",
        radial[1].value
    );
    assert!(
        radial[8].value > 1.1,
        "a ring where the points' distance is one wave"
    );
    let rooks = Spectrum::of(&subject("n-rooks"), 64, 16, 400);
    let mean = |spectrum: &Spectrum| {
        let all = spectrum.anisotropy();
        all.iter().map(|p| p.value).sum::<f64>() / all.len() as f64
    };
    let (disk, rooks) = (mean(&disk), mean(&rooks));
    assert!(disk < 0.01, "1/400 for chance alone; {disk}");
    assert!(rooks > 5.0 * disk, "n-rooks prefer the axes: {rooks}");
}

#[test]
fn of_more_points_a_poisson_disk_is_no_quieter_near_0() {
    let lowest = |name, n| {
        let radial = Spectrum::of(&subject(name), n, 3, 400).radial();
        radial.iter().map(|ring| ring.value).sum::<f64>() / 3.0
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

#[test]
fn bands_hold_the_power_of_random_points() {
    let spectrum = Spectrum::of(&subject("random"), 64, 12, 200);
    let held = spectrum.radial();
    let inside = held.iter().filter(|k| (k.value - 1.0).abs() < k.within);
    // 95 % of 12, and one more for chance.
    assert!(inside.count() >= 10, "bands that hold 1: {held:?}");
    assert!(
        held.iter().all(|k| k.within > 0.0 && k.within < 0.3),
        "200 realisations know it to some per cent: {held:?}"
    );
    let one = Spectrum::of(&subject("random"), 64, 4, 1).radial();
    assert!(one.iter().all(|k| k.within == 0.0), "one has no band");
}

/// Frequency and power of a pattern's rings.
fn radial(name: &str, n: usize, realisations: u64) -> Vec<(f64, f64)> {
    let spectrum = Spectrum::of(&subject(name), n, 32, realisations);
    let known = spectrum.radial();
    known.iter().map(|k| (k.frequency, k.value)).collect()
}

#[test]
fn a_grid_has_its_nyquist_frequency_and_random_points_have_none() {
    let grid = effective_nyquist(&radial("regular-grid", 256, 1), 256);
    // Rings are one wave wide: half a wave of 16 is 3 %.
    assert!((grid - 1.0).abs() < 0.04, "√n/2: {grid}");
    let random = radial("random", 256, 100);
    let none = effective_nyquist(&random, 256);
    assert!(none < 0.01, "none: {none}");
    let noise = oscillation(&random);
    assert!(noise < 0.5, "white noise does not oscillate: {noise}");
    let disk = radial("poisson-disk", 256, 100);
    let orderly = effective_nyquist(&disk, 256);
    assert!((0.4..0.9).contains(&orderly), "in between: {orderly}");
    assert!(oscillation(&disk) > 1.5 * noise, "it has a ring");
}

#[test]
fn a_step_in_the_spectrum_is_found_where_it_is() {
    // P = 0 up to 12, then 1: E(ν) = 1 − (12.5/ν)² = 0.1 at ν = 13.18; n = 144 has the grid frequency 12.
    let step: Vec<_> = (1..=32)
        .map(|r| (f64::from(r), f64::from(u8::from(r > 12))))
        .collect();
    let found = effective_nyquist(&step, 144) * 12.0;
    assert!((found - 13.18).abs() < 0.7, "to a ring: {found}");
    assert!(oscillation(&step) < 1e-9, "flat beyond the step");
}

#[test]
fn pairs_of_random_points_are_at_every_distance_and_jittered_ones_keep_apart() {
    for (r, g) in pair_correlation(&subject("random"), 64, 400) {
        // The first bin has 400 · 64 · 63/2 · π/16²/64 = 155 pairs: known to 8 %.
        assert!((g - 1.0).abs() < 0.35, "{r}: {g}");
    }
    for (t, g) in pair_correlation(&subject("jittered"), 64, 400)
        .iter()
        .filter(|p| p.0 < 1.0)
    {
        // Two points are in different cells with the probability 1 − Π max(0, 1 − |d|/s), averaged over the angle.
        let exact = 64.0 / 63.0 * (4.0 * t / PI - t * t / PI);
        assert!((g - exact).abs() < 0.06 + 0.1 * exact, "{t}: {g}, {exact}");
    }
    let disk = pair_correlation(&subject("poisson-disk"), 64, 100);
    let empty = disk.iter().filter(|(r, _)| *r < 0.6);
    assert!(empty.clone().count() > 5, "there are short distances");
    for (r, g) in empty {
        assert!(*g < 1e-9, "no two points are so near: {r}, {g}");
    }
}

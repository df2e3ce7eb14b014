//! Nets: Sobol's points, scrambled or not, and the van der Corput sequence.

use super::{counts, points};
use glam::vec2;
use raybook::sample::pattern::{halton::radical_inverse, sobol::sobol};

#[test]
fn sobols_points_are_a_net_in_base_2_wherever_a_power_of_2_begins() {
    for k in 0..=10 {
        for first in [0_u32, 1 << k, 5 << k] {
            let of = |i| {
                let [x, y] = sobol(i).map(|bits| (bits >> 8) as f32 / (1 << 24) as f32);
                vec2(x, y)
            };
            let points: Vec<_> = (first..first + (1 << k)).map(of).collect();
            for across in 0..=k {
                let counts = counts(&points, 1 << across, 1 << (k - across));
                assert!(
                    counts.iter().all(|&count| count == 1),
                    "2^{k} points from {first}: one in each of 2^{across} × 2^{} boxes",
                    k - across
                );
            }
        }
    }
}

#[test]
fn scrambled_points_are_still_a_net_and_no_longer_the_same() {
    for seed in 0..8 {
        for k in [0, 1, 4, 7, 10] {
            let points = points("sobol-owen", 1 << k, seed);
            for across in 0..=k {
                let counts = counts(&points, 1 << across, 1 << (k - across));
                assert!(
                    counts.iter().all(|&count| count == 1),
                    "2^{k} points under seed {seed}, in 2^{across} columns"
                );
            }
        }
    }
    assert_ne!(
        points("sobol-owen", 16, 1),
        points("sobol-owen", 16, 2),
        "other coins"
    );
}

#[test]
fn random_points_are_no_net() {
    let counts = counts(&points("random", 256, 1), 16, 16);
    assert!(counts.contains(&0), "the test can fail");
}

#[test]
fn the_radical_inverse_mirrors_digits() {
    for (base, i, expected) in [
        (2, 6, 0.375),
        (2, 1, 0.5),
        (3, 5, 7.0 / 9.0),
        (10, 123, 0.321),
    ] {
        let got = radical_inverse(base, i);
        assert!((got - expected).abs() < 1e-12, "φ{base}({i}) is {got}");
    }
    assert_eq!(radical_inverse(2, 0), 0.0, "nothing to mirror");
}

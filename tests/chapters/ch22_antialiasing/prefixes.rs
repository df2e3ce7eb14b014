//! The first k of n points.

use super::subject;
use raybook_chapters::lab::prefixes::{cuts, discrepancy};

#[test]
fn a_pattern_is_cut_at_powers_of_two_and_between() {
    assert_eq!(cuts(20), [2, 3, 4, 6, 8, 12, 16, 20], "and at all of it");
}

#[test]
fn the_first_random_points_are_as_theory_says_and_the_first_rows_of_a_grid_are_bad() {
    let by_chance = |k: usize| (5.0 / (36.0 * k as f64)).sqrt();
    for (k, got) in discrepancy(&subject("random"), 64, 1000) {
        let off = got / by_chance(k) - 1.0;
        assert!(off.abs() < 0.08, "random, {k}: {got}, {}", by_chance(k));
    }
    let at = |name: &str, k: usize| {
        let all = discrepancy(&subject(name), 64, 50);
        all.iter().find(|one| one.0 == k).expect("a cut").1
    };
    assert!(at("jittered", 16) > by_chance(16), "a quarter in rows");
    assert!(
        at("jittered", 64) < 0.5 * by_chance(64),
        "but not all of it"
    );
    assert!(at("sobol-owen", 16) < 0.6 * by_chance(16), "progressive");
}

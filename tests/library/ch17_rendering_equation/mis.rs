//! The weights of two strategies.

use raybook::render::mis::{Strategy, power};

#[test]
fn the_weights_of_a_direction_add_up_to_one() {
    for p in [1e-6, 0.01, 1.0, 30.0, 1e6] {
        for q in [0.0, 1e-6, 0.5, 7.0, 1e6] {
            let both = [Strategy::Surface, Strategy::Light, Strategy::Both];
            for strategy in both.into_iter().filter(|_| q > 0.0) {
                let sum = strategy.of_light(p, q) + strategy.of_surface(q, p);
                assert!((sum - 1.0).abs() < 1e-6, "{strategy:?}, {p}, {q}: {sum}");
            }
            assert!((0.0..=1.0).contains(&power(p, q)), "{p}, {q}");
        }
    }
}

#[test]
fn what_only_one_can_find_counts_in_full() {
    for strategy in [Strategy::Surface, Strategy::Light, Strategy::Both] {
        assert_eq!(
            strategy.of_light(f32::INFINITY, 0.3),
            1.0,
            "{strategy:?}: no surface finds a point light"
        );
        assert_eq!(
            strategy.of_surface(0.3, 0.0),
            1.0,
            "{strategy:?}: a light that cannot be chosen"
        );
        assert_eq!(
            strategy.of_surface(f32::INFINITY, 0.3),
            1.0,
            "{strategy:?}: what the eye sees straight"
        );
    }
}

#[test]
fn the_better_strategy_gets_nearly_all() {
    assert!(power(100.0, 1.0) > 0.999, "the square helps the better one");
    assert!((power(2.0, 1.0) - 0.8).abs() < 1e-6, "4/(4 + 1)");
}

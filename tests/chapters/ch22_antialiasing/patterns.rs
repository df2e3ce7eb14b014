//! Every pattern: any number of points, in the square, the same ones for the same seed; and the structure of each.

use super::{counts, pattern, points};
use glam::{Vec2, vec2};
use raybook::math::pcg;
use raybook::sample::pattern::{PATTERNS, jittered, multi_jittered, rotated_grid, rows};

/// What ignores the random numbers.
const FIXED: [&str; 2] = ["regular-grid", "rotated-grid"];

#[test]
fn every_pattern_makes_any_number_of_points_in_the_square() {
    for pattern in PATTERNS {
        for n in (0..=40).chain([63, 64, 100, 169, 1000, 1009, 20_000]) {
            let points = (pattern.points)(n, &mut pcg::stream(5, n as u64));
            assert_eq!(points.len(), n, "{}: as many as asked", pattern.name);
            let inside = |p: &Vec2| p.cmpge(Vec2::ZERO).all() && p.cmplt(Vec2::ONE).all();
            assert!(
                points.iter().all(inside),
                "{} of {n}: 0 ≤ x < 1, and y too",
                pattern.name
            );
        }
    }
}

#[test]
fn a_million_points_are_made_too() {
    // The slow ones are tried in the release build of `raybook samplers`; 100 000 of them here.
    for pattern in PATTERNS {
        let slow = ["dart-throwing", "poisson-disk", "best-candidate"].contains(&pattern.name);
        let n = if slow { 100_000 } else { 1_000_000 };
        let points = (pattern.points)(n, &mut pcg::stream(5, 6));
        assert_eq!(points.len(), n, "{}: as many as asked", pattern.name);
        let inside = |p: &Vec2| p.min_element() >= 0.0 && p.max_element() < 1.0;
        assert!(points.iter().all(inside), "{}: in the square", pattern.name);
        // A mistake in counting up would leave part of the square empty.
        let least = counts(&points, 10, 10).into_iter().min();
        assert!(
            least >= Some(n / 110),
            "{}: {least:?} points in a hundredth of the square",
            pattern.name
        );
    }
}

#[test]
fn the_seed_and_the_pixel_decide_and_nothing_else() {
    for pattern in PATTERNS {
        let of = |seed, pixel| (pattern.points)(50, &mut pcg::stream(seed, pixel));
        assert_eq!(of(1, 2), of(1, 2), "{}: the same numbers", pattern.name);
        let fixed = FIXED.contains(&pattern.name);
        assert_eq!(
            of(1, 2) == of(1, 3),
            fixed,
            "{}: another pixel",
            pattern.name
        );
        assert_eq!(
            of(1, 2) == of(2, 2),
            fixed,
            "{}: another seed",
            pattern.name
        );
    }
}

#[test]
fn five_points_of_a_grid_are_rows_of_two_and_three_cells_of_one_area() {
    let [a, b, c, d, e] = points("regular-grid", 5, 1)[..] else {
        panic!("five points")
    };
    assert_eq!([a, b], [vec2(0.25, 0.2), vec2(0.75, 0.2)], "two above");
    assert_eq!(c.y, d.y, "three below, side by side");
    assert_eq!(
        [d, e],
        [vec2(0.5, 0.7), vec2(5.0 / 6.0, 0.7)],
        "in the middles"
    );
    let jittered = points("jittered", 5, 3);
    let above = jittered.iter().filter(|p| p.y < 0.4).count();
    assert_eq!(above, 2, "two of the jittered ones in the upper two fifths");
    for n in 1..200 {
        assert_eq!(rows::rows(n).sum::<usize>(), n, "rows of {n}");
        let (least, most) = (rows::rows(n).min(), rows::rows(n).max());
        assert!(
            most <= least.map(|m| m + 1),
            "{n}: rows are alike up to one cell"
        );
    }
}

#[test]
fn every_stratum_has_its_point() {
    for seed in 0..20 {
        for n in [1, 2, 3, 5, 8, 16, 31] {
            let once = |name: &str, columns, rows| {
                let counts = counts(&points(name, columns * rows, seed), columns, rows);
                assert!(
                    counts.iter().all(|&count| count == 1),
                    "{name}, {columns} × {rows} cells, seed {seed}: {counts:?}"
                );
            };
            once("regular-grid", n, n);
            once("jittered", n, n);
            once("multi-jittered", n, n);
            once("multi-jittered", n * n, 1);
            once("multi-jittered", 1, n * n);
            once("n-rooks", n, 1);
            once("n-rooks", 1, n);
        }
        let rng = &mut pcg::stream(seed, 9);
        let oblong = jittered::jittered(7, 3, rng);
        assert_eq!(counts(&oblong, 7, 3), [1; 21], "jittered, 7 × 3");
        let oblong = multi_jittered::multi_jittered(6, 4, rng);
        for (columns, rows) in [(6, 4), (24, 1), (1, 24)] {
            let once = counts(&oblong, columns, rows).iter().all(|&c| c == 1);
            assert!(once, "multi-jittered 6 × 4, in {columns} × {rows}");
        }
    }
}

#[test]
fn a_random_pattern_leaves_strata_empty() {
    let empty = counts(&points("random", 400, 1), 20, 20);
    let empty = empty.iter().filter(|&&count| count == 0).count();
    assert!((100..200).contains(&empty), "400/e are 147, not {empty}");
}

#[test]
fn four_points_of_the_rotated_grid_are_at_eighths() {
    let mut four = points("rotated-grid", 4, 1);
    four.sort_by(|p, q| p.x.total_cmp(&q.x));
    let eighths = [(1.0, 5.0), (3.0, 1.0), (5.0, 7.0), (7.0, 3.0)];
    for (p, (x, y)) in four.iter().zip(eighths) {
        let expected = vec2(x, y) / 8.0;
        assert!(p.distance(expected) < 1e-6, "{p} should be {expected}");
    }
}

#[test]
fn the_rotated_grid_is_a_lattice_turned_by_arctan_half() {
    for (spacing, offset) in [(0.1, vec2(0.3, 0.7)), (0.031, Vec2::ZERO)] {
        let points = rotated_grid::rotated_grid(spacing, offset);
        let expected = 1.0 / (spacing * spacing);
        let off = (points.len() as f32 - expected).abs();
        assert!(off < 4.0 / spacing, "{} points", points.len());
        for p in points
            .iter()
            .filter(|p| (**p - 0.5).abs().max_element() < 0.3)
        {
            let near = |q: &&Vec2| q.distance(*p) < 1.01 * spacing && *q != p;
            let ways: Vec<_> = points.iter().filter(near).map(|q| *q - *p).collect();
            assert_eq!(ways.len(), 4, "four neighbours");
            for way in ways {
                assert!((way.length() - spacing).abs() < 1e-5, "the spacing");
                let degrees = way.to_angle().to_degrees().rem_euclid(90.0);
                assert!((degrees - 26.565).abs() < 0.01, "turned by {degrees}°");
            }
        }
    }
    assert!(
        rotated_grid::rotated_grid(0.6, vec2(0.5, 0.5)).len() <= 4,
        "a coarse lattice has few points"
    );
}

#[test]
fn each_digit_of_the_points_is_uniform() {
    // χ² of 64 cells over many realisations: 63 degrees of freedom, whose 1e-6 quantiles are 19 and 132. The patterns that
    // are more even than random have less.
    for p in PATTERNS {
        if FIXED.contains(&p.name) {
            continue;
        }
        let mut total = [0; 64];
        for seed in 0..200 {
            let counted = counts(&points(p.name, 25, seed), 8, 8);
            total.iter_mut().zip(counted).for_each(|(t, c)| *t += c);
        }
        let expected = 200.0 * 25.0 / 64.0;
        let chi: f64 = total
            .iter()
            .map(|&t| (t as f64 - expected).powi(2) / expected)
            .sum();
        assert!(chi < 132.0, "{}: χ² is {chi:.0}", p.name);
        if p.name == "random" {
            assert!(chi > 19.0, "χ² is {chi:.0}: too even to be random");
        }
    }
    assert_eq!(pattern("r2").name, "r2", "found by name");
}

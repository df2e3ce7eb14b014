//! Poisson disks: no two points too near, exactly; and no room left.

use super::points;
use glam::{Vec2, vec2};
use raybook::inside::{Neighbours, Space};
use raybook::math::pcg;
use raybook::sample::pattern::dart_throwing::largest_distance;
use raybook::sample::pattern::poisson_disk::{distance_for, poisson_disk};

#[test]
fn no_two_points_are_nearer_than_the_distance_not_by_a_digit() {
    for (space, seed) in [(Space::Square, 1), (Space::Torus, 2), (Space::Torus, 3)] {
        for distance in [0.9_f32, 0.4, 0.1, 0.03, 0.011] {
            let points = poisson_disk(distance, space, &mut pcg::stream(seed, 1));
            let least = f64::from(distance) * f64::from(distance);
            for (i, p) in points.iter().enumerate() {
                for q in &points[..i] {
                    assert!(
                        space.distance_squared(*p, *q) >= least,
                        "{p} and {q} are nearer than {distance} in the {space:?}"
                    );
                }
            }
            assert!(points.len() > 1 || distance > 0.5, "more than one has room");
        }
    }
}

#[test]
fn hardly_any_room_is_left() {
    for (space, distance) in [
        (Space::Square, 0.07),
        (Space::Torus, 0.07),
        (Space::Torus, 0.02),
    ] {
        let points = poisson_disk(distance, space, &mut pcg::stream(4, 4));
        let probes = (0..10_000).map(|i| (vec2((i % 100) as f32, (i / 100) as f32) + 0.5) / 100.0);
        let least = f64::from(distance).powi(2);
        let free = probes.filter(|probe| {
            points
                .iter()
                .all(|p| space.distance_squared(*p, *probe) >= least)
        });
        let free = free.count();
        assert!(
            free < 500,
            "{space:?}, {distance}: {free} of 10 000 places are free"
        );
    }
}

#[test]
fn on_the_torus_copies_side_by_side_fit() {
    let points = poisson_disk(0.1, Space::Torus, &mut pcg::stream(8, 1));
    let copies = (-1..=1).flat_map(|j| (-1..=1).map(move |i| vec2(i as f32, j as f32)));
    for copy in copies.filter(|copy| *copy != Vec2::ZERO) {
        for p in &points {
            let apart = points.iter().map(|q| p.distance(*q + copy));
            let nearest = apart.fold(f32::INFINITY, f32::min);
            assert!(
                nearest > 0.099_999,
                "{p}: the copy {copy} is {nearest} away"
            );
        }
    }
    let plain = poisson_disk(0.1, Space::Square, &mut pcg::stream(8, 1));
    let crossing = plain.iter().any(|p| {
        plain
            .iter()
            .any(|q| p != q && Space::Torus.distance_squared(*p, *q) < 0.009)
    });
    assert!(crossing, "in the plane they do not: the test can fail");
}

#[test]
fn so_many_points_keep_a_good_part_of_the_largest_distance() {
    for (name, share) in [
        ("dart-throwing", 0.6),
        ("poisson-disk", 0.6),
        ("best-candidate", 0.4),
    ] {
        for n in [16, 100, 1000] {
            let points = points(name, n, 3);
            let pairs = (0..n).flat_map(|i| (0..i).map(move |j| (i, j)));
            let apart = pairs.map(|(i, j)| Space::Torus.distance_squared(points[i], points[j]));
            let least = apart.fold(f64::INFINITY, f64::min).sqrt();
            let largest = largest_distance(n);
            assert!(least <= largest, "{name}, {n}: nothing beats the honeycomb");
            assert!(
                least > share * largest,
                "{name}, {n}: {least:.4} of {largest:.4} possible"
            );
        }
    }
    let four = largest_distance(4);
    assert!((four - 0.537_285).abs() < 1e-6, "√(2/(√3·4)), not {four}");
}

#[test]
fn nearly_so_many_points_have_room_in_the_plane_and_on_the_torus() {
    for (space, n) in [
        (Space::Square, 40),
        (Space::Square, 1000),
        (Space::Torus, 40),
        (Space::Torus, 1000),
    ] {
        let distance = distance_for(n, space) as f32;
        let count = |seed| poisson_disk(distance, space, &mut pcg::stream(seed, 1)).len();
        let mean = (0..40).map(count).sum::<usize>() as f64 / 40.0;
        let share = mean / n as f64;
        assert!(
            (0.94..1.0).contains(&share),
            "{share} of {n} in the {space:?}"
        );
    }
}

#[test]
fn a_distance_of_nothing_or_of_no_number_ends_too() {
    for distance in [2.0, f32::INFINITY] {
        let points = poisson_disk(distance, Space::Torus, &mut pcg::stream(1, 1));
        assert_eq!(points.len(), 1, "{distance}: one point");
    }
}

#[test]
fn the_nearest_neighbour_is_found_wherever_it_is() {
    let all = points("random", 300, 5);
    for space in [Space::Square, Space::Torus] {
        let mut near = Neighbours::new(0.02, space);
        assert!(
            near.nearest_squared(Vec2::ZERO).is_infinite(),
            "there is none"
        );
        for (i, p) in all.iter().enumerate() {
            let found = near.nearest_squared(*p);
            let by_hand = all[..i].iter().map(|q| space.distance_squared(*p, *q));
            assert_eq!(
                found,
                by_hand.fold(f64::INFINITY, f64::min),
                "{space:?}, {i}"
            );
            near.push(*p);
        }
    }
}

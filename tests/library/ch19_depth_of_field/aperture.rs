//! Points of the aperture: inside, and equally likely everywhere.

use glam::{Vec2, vec2};
use rand::RngExt;
use raybook::camera::aperture::Aperture;
use raybook::sample::{disk::concentric_disk, polygon::regular_polygon};
use raybook_common::statistics::Mean;
use std::f32::consts::{FRAC_PI_4, PI, TAU};

#[test]
fn squares_become_circles_of_the_same_share_and_the_middle_stays() {
    assert_eq!(concentric_disk(Vec2::splat(0.5)), Vec2::ZERO, "the middle");
    for i in 0..=200 {
        for r in [0.01, 0.3, 1.0] {
            // Around the square of half side r/2 from its right side's middle, i/200 of the way.
            let t = 8.0 * i as f32 / 200.0;
            let place = match t {
                t if t < 1.0 => vec2(1.0, t),
                t if t < 3.0 => vec2(2.0 - t, 1.0),
                t if t < 5.0 => vec2(-1.0, 4.0 - t),
                t if t < 7.0 => vec2(t - 6.0, -1.0),
                t => vec2(1.0, t - 8.0),
            };
            let p = concentric_disk(0.5 + 0.5 * r * place);
            let expected = r * Vec2::from_angle(FRAC_PI_4 * t);
            assert!(
                p.distance(expected) < 1e-5,
                "{place} at {r}: {p}, and should be {expected}"
            );
        }
    }
}

#[test]
fn the_disc_s_corners_of_u_are_finite_and_in_it() {
    for x in [0.0, 0.5, 0.999_999_94, 1.0] {
        for y in [0.0, 0.5, 0.999_999_94, 1.0] {
            for p in [
                concentric_disk(vec2(x, y)),
                regular_polygon(6, 0.3, vec2(x, y)),
            ] {
                assert!(p.length() <= 1.0 + 1e-6, "({x}, {y}) becomes {p}");
            }
        }
    }
}

#[test]
fn points_of_disc_and_polygons_have_the_moments_of_even_areas() {
    let round = |_: u32| Aperture::Round;
    let blades = |count: u32| Aperture::Blades { count, turn: 0.4 };
    for (name, aperture, count) in [
        ("disc", round(0), u32::MAX),
        ("3 blades", blades(3), 3),
        ("5 blades", blades(5), 5),
        ("6 blades", blades(6), 6),
        ("9 blades", blades(9), 9),
    ] {
        // ⟨r²⟩ of a regular polygon with corners at 1 is (2 + cos 2π/n)/6, which for the disc is 1/2.
        let square = (2.0 + (TAU / count as f32).cos()) / 6.0;
        let mean = |f: &dyn Fn(Vec2) -> f32| {
            Mean::sampled(19, 4000, |rng| {
                f(aperture.point(vec2(rng.random(), rng.random())))
            })
        };
        mean(&|p| 1.0 + p.x).assert_is(1.0, &format!("{name}: the mean is in the middle"));
        mean(&|p| 1.0 + p.y).assert_is(1.0, &format!("{name}: the mean is in the middle"));
        mean(&|p| p.length_squared()).assert_is(square.into(), &format!("{name}: the squares"));
        mean(&|p| 1.0 + p.x * p.y).assert_is(1.0, &format!("{name}: no axis is preferred"));
    }
}

#[test]
fn equal_cells_of_the_square_become_equal_areas() {
    let aperture = |name, aperture: Aperture, area: f32| (name, aperture, area);
    let hexagon = Aperture::Blades {
        count: 6,
        turn: 0.0,
    };
    for (name, aperture, area) in [
        aperture("disc", Aperture::Round, PI),
        aperture("hexagon", hexagon, 1.5 * 3_f32.sqrt()),
    ] {
        // 60 cells a side, so that neither the diagonals nor the six wedges cut a cell.
        let n = 60;
        for i in 0..n {
            for j in 0..n {
                // The cell's border as a polygon of many corners (the shoelace formula).
                let border = (0..80).map(|k| {
                    let (side, t) = (k / 20, (k % 20) as f32 / 20.0);
                    let corner = match side {
                        0 => vec2(t, 0.0),
                        1 => vec2(1.0, t),
                        2 => vec2(1.0 - t, 1.0),
                        _ => vec2(0.0, 1.0 - t),
                    };
                    aperture
                        .point((vec2(i as f32, j as f32) + corner) / n as f32)
                        .as_dvec2()
                });
                let border: Vec<_> = border.collect();
                let pairs = border.iter().zip(border.iter().cycle().skip(1));
                let twice: f64 = pairs.map(|(a, b)| a.perp_dot(*b)).sum();
                let share = 0.5 * twice.abs() * f64::from(n * n) / f64::from(area);
                assert!(
                    (share - 1.0).abs() < 0.03,
                    "{name}, cell ({i}, {j}): {share} of what it should have"
                );
            }
        }
    }
}

#[test]
fn blades_bound_the_hole_by_straight_edges() {
    for count in [3, 5, 8] {
        let turn = 0.2;
        let apothem = (PI / count as f32).cos();
        let (mut near_edge, mut near_corner) = (0, 0);
        for i in 0..40 {
            for j in 0..240 {
                let u = vec2(i as f32 / 39.0, j as f32 / 240.0);
                let p = regular_polygon(count, turn, u);
                for k in 0..count {
                    let edge = Vec2::from_angle(turn + TAU * (k as f32 + 0.5) / count as f32);
                    let out = p.dot(edge);
                    assert!(
                        out <= apothem + 1e-5,
                        "{count} blades: {p} is behind edge {k}"
                    );
                    near_edge += u32::from(out > 0.99 * apothem);
                }
                near_corner += u32::from(p.length() > 0.99);
            }
        }
        assert!(near_edge > 100, "the points reach the edges");
        assert!(near_corner > 0, "the points reach the corners");
    }
    let (two, three) = (
        regular_polygon(2, 0.0, vec2(1.0, 0.4)),
        regular_polygon(3, 0.0, vec2(1.0, 0.4)),
    );
    assert_eq!(two, three, "fewer than three corners count as three");
}

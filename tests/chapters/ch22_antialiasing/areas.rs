//! Areas within the unit square.

use glam::{DVec2, dvec2};
use raybook_chapters::lab::area::{of_checker, of_disc};
use raybook_chapters::lab::integrands::Checker;
use std::f64::consts::PI;

#[test]
fn a_disc_inside_is_whole_and_one_in_a_corner_is_a_quarter() {
    let close = |got: f64, exact: f64, what: &str| {
        assert!(
            (got - exact).abs() < 1e-12,
            "{what}: {got}, exactly {exact}"
        );
    };
    close(of_disc(dvec2(0.5, 0.5), 0.3), 0.09 * PI, "inside");
    close(of_disc(DVec2::ZERO, 0.5), 0.0625 * PI, "a corner");
    close(of_disc(dvec2(0.5, 1.0), 0.4), 0.08 * PI, "a side");
    close(of_disc(dvec2(0.0, 0.5), 0.4), 0.08 * PI, "another side");
    close(of_disc(dvec2(0.5, 0.5), 2.0), 1.0, "all of the square");
    close(of_disc(dvec2(2.0, 0.5), 0.5), 0.0, "outside");
    // A disc as wide as the diagonal less a little: the square without four corners. The segment over a side at the distance 0.5 from the centre.
    let r: f64 = 0.6;
    let segment = r * r * (0.5 / r).acos() - 0.5 * (r * r - 0.25).sqrt();
    close(
        of_disc(dvec2(0.5, 0.5), r),
        PI * r * r - 4.0 * segment,
        "four segments",
    );
}

#[test]
fn a_turned_checkerboard_is_half_odd_where_it_is_symmetric() {
    let turned = |degrees: f64| Checker {
        along: DVec2::from_angle(degrees.to_radians()),
        corner: dvec2(0.5, 0.5),
        side: 0.23,
    };
    // A corner in the middle: a quarter turn exchanges the colours.
    for degrees in [0.0, 17.0, 45.0, 123.0] {
        let odd = of_checker(&turned(degrees));
        assert!((odd - 0.5).abs() < 1e-12, "{degrees}°: {odd}");
    }
    // Squares of 0.4 from the corner: along an axis even ones have 3/5 of the side, so odd sums have 2 · 3/5 · 2/5.
    let straight = Checker {
        along: DVec2::X,
        corner: DVec2::ZERO,
        side: 0.4,
    };
    let odd = of_checker(&straight);
    assert!((odd - 0.48).abs() < 1e-12, "{odd}");
}

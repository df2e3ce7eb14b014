//! Chapter 03: the interval and the quadratic equation.

use rand::RngExt;
use raybook::math::{interval::Interval, pcg, quadratic};

/// Half of the distance from 1 to the next f32: the largest relative error of one rounding.
const ROUNDED: f64 = f32::EPSILON as f64 / 2.0;

fn schoolbook(b: f32, c: f32) -> f32 {
    0.5 * (-b + (b * b - 4.0 * c).sqrt())
}

#[test]
fn an_interval_is_open_at_both_ends() {
    let within = Interval::new(1.0, 2.0);
    assert!(within.contains(1.5), "the middle counts");
    for t in [1.0, 2.0, 0.0, 3.0, f32::NAN, f32::INFINITY] {
        assert!(!within.contains(t), "{t} does not count in 1 < t < 2");
    }
    let nearer = within.before(1.25);
    assert!(
        nearer.contains(1.2) && !nearer.contains(1.25),
        "what was hit at 1.25 ends the interval"
    );
    assert!(
        !Interval::AHEAD.contains(-0.0) && !Interval::AHEAD.contains(f32::INFINITY),
        "ahead is 0 < t < ∞"
    );
}

#[test]
fn textbook_quadratics_have_their_roots() {
    for (a, b, c, roots) in [
        (1.0, -5.0, 6.0, Some((2.0, 3.0))),
        (1.0, 5.0, 6.0, Some((-3.0, -2.0))),
        (-1.0, 5.0, -6.0, Some((2.0, 3.0))), // a < 0: still in order
        (1.0, -2.0, 1.0, Some((1.0, 1.0))),  // double
        (1.0, 0.0, -4.0, Some((-2.0, 2.0))), // b = 0
        (1.0, -0.0, -4.0, Some((-2.0, 2.0))),
        (2.0, -6.0, 0.0, Some((0.0, 3.0))), // c = 0
        (3.0, 0.0, 0.0, Some((0.0, 0.0))),
        (1.0, 0.0, 4.0, None),
        (0.0, 2.0, 1.0, None),                   // not a quadratic
        (1e30, 0.0, -1e30, Some((-1.0, 1.0))),   // b² − 4ac is beyond f32's largest number
        (1e-30, 0.0, -1e-30, Some((-1.0, 1.0))), // and here below its smallest
        (f32::NAN, 1.0, 0.0, None),
        (1.0, f32::NAN, 0.0, None),
        (1.0, 1.0, f32::NAN, None),
    ] {
        assert_eq!(
            quadratic::solve(a, b, c),
            roots,
            "the roots of {a} t² + {b} t + {c}"
        );
    }
}

/// Roots of 8 bits, up to 2¹² apart, give coefficients that f32 holds exactly; so the roots must come back exactly.
#[test]
fn no_digit_of_a_root_is_lost() {
    let mut rng = pcg::stream(3, 1);
    let mut worst_of_schoolbook = 0.0_f32;
    for _ in 0..20_000 {
        let mut root = || {
            let bits = rng.random_range(128..256) as f32;
            let sign = if rng.random() { 1.0 } else { -1.0 };
            sign * bits * f32::from(rng.random_range(-8_i8..=4)).exp2()
        };
        let (x, y) = (root(), root());
        let (b, c) = (-(x + y), x * y);
        assert_eq!(
            f64::from(b),
            -(f64::from(x) + f64::from(y)),
            "b is exact, or the test proves nothing"
        );
        let (t0, t1) = quadratic::solve(1.0, b, c).expect("it has two real roots");
        assert_eq!(
            (t0, t1),
            (x.min(y), x.max(y)),
            "the roots of t² + {b} t + {c}"
        );
        for a in [-0.25, 64.0] {
            let scaled = quadratic::solve(a, a * b, a * c);
            assert_eq!(scaled, Some((t0, t1)), "times {a}, the roots are the same");
        }
        worst_of_schoolbook = worst_of_schoolbook.max((schoolbook(b, c) / t1 - 1.0).abs());
    }
    assert!(
        worst_of_schoolbook > 1e-5,
        "the schoolbook formula must fail here, it was off by {worst_of_schoolbook}"
    );
    assert_eq!(
        schoolbook(1e4, 1.0),
        0.0,
        "t² + 10⁴ t + 1 has no root 0, but its digits are lost"
    );
    let (_, small) = quadratic::solve(1.0, 1e4, 1.0).expect("it has two real roots");
    assert!(
        (f64::from(small) + 1.000_000_01e-4).abs() < ROUNDED * 1e-4,
        "the small root is −1.00000001e-4, not {small}"
    );
}

#[test]
fn any_coefficients_give_ordered_roots_or_none() {
    let (tiny, inf) = (1e-45, f32::INFINITY);
    let numbers = [0.0, -0.0, -3.0, tiny, -1e19, 1e38, inf, -inf, f32::NAN];
    let mut solved = 0;
    for a in numbers {
        for b in numbers {
            for c in numbers {
                if let Some((t0, t1)) = quadratic::solve(a, b, c) {
                    solved += 1;
                    let broken = [a, b, c].iter().any(|v| v.is_infinite());
                    assert!(
                        t0 <= t1 || broken,
                        "{a}, {b}, {c}: {t0} and {t1} are in order"
                    );
                }
            }
        }
    }
    assert!(solved > 200, "only {solved} were solved");
}

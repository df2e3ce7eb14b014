//! Areas within the unit square, exactly.

use crate::lab::integrands::Checker;
use glam::DVec2;

/// The area of the part of a disc that is in the unit square.
///
/// The disc is integrated along x. The places where its rim crosses a side of the square cut the way into pieces. In each piece,
/// the upper and the lower border are each either the rim, whose integral is ½(u·√(r² − u²) + r² asin(u/r)), or a side of the
/// square.
pub fn of_disc(centre: DVec2, radius: f64) -> f64 {
    let (low, high) = (-centre, DVec2::ONE - centre); // the square, seen from the centre
    let rim = |u: f64| (radius * radius - u * u).max(0.0).sqrt();
    let below = |u: f64| {
        let u = u.clamp(-radius, radius);
        0.5 * (u * rim(u) + radius * radius * (u / radius).asin())
    };
    let [left, right] = [low.x, high.x].map(|x| x.clamp(-radius, radius));
    let crossings = [low.y, high.y].map(rim);
    let mut places = vec![left, right];
    places.extend(crossings.iter().flat_map(|u| [-u, *u]));
    places.retain(|u| (left..=right).contains(u));
    places.sort_by(f64::total_cmp);
    let piece = |ends: &[f64]| {
        let (from, to) = (ends[0], ends[1]);
        let h = rim(0.5 * (from + to));
        let arc = below(to) - below(from);
        let up_to = |side: f64, reached: bool| if reached { arc } else { side * (to - from) };
        if h <= low.y || -h >= high.y {
            return 0.0;
        }
        // Both borders as integrals from the x axis through the centre, upwards.
        let upper = up_to(high.y, h < high.y);
        let lower = if -h > low.y {
            -arc
        } else {
            low.y * (to - from)
        };
        (upper - lower).max(0.0)
    };
    places.windows(2).map(piece).sum()
}

/// The area of the odd squares of a checkerboard within the unit square.
pub fn of_checker(checker: &Checker) -> f64 {
    const CORNERS: [DVec2; 4] = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
    let reached = CORNERS.map(|corner| checker.square(corner));
    let low = reached.iter().fold(DVec2::INFINITY, |low, at| low.min(*at));
    let high = reached
        .iter()
        .fold(DVec2::NEG_INFINITY, |high, at| high.max(*at));
    let mut area = 0.0;
    for row in low.y as i64..=high.y as i64 {
        for column in low.x as i64..=high.x as i64 {
            if (row + column).rem_euclid(2) == 1 {
                area += of_square(checker, column as f64, row as f64, &CORNERS);
            }
        }
    }
    area
}

/// The area of one square of a checkerboard within a polygon.
fn of_square(checker: &Checker, column: f64, row: f64, polygon: &[DVec2]) -> f64 {
    let (x, y) = (checker.along, checker.along.perp());
    let from = checker.corner + checker.side * (column * x + row * y);
    let to = from + checker.side * (x + y);
    let sides = [(x, from), (y, from), (-x, to), (-y, to)];
    let inside = sides
        .iter()
        .fold(polygon.to_vec(), |polygon, (inwards, through)| {
            clip(&polygon, *inwards, *through)
        });
    let next = inside.iter().cycle().skip(1);
    0.5 * inside
        .iter()
        .zip(next)
        .map(|(p, q)| p.perp_dot(*q))
        .sum::<f64>()
}

/// The part of a polygon on the side of a line to which `inwards` points (Sutherland and Hodgman 1974).
fn clip(polygon: &[DVec2], inwards: DVec2, through: DVec2) -> Vec<DVec2> {
    let next = polygon.iter().cycle().skip(1);
    let mut inside = Vec::with_capacity(polygon.len() + 1);
    for (p, q) in polygon.iter().zip(next) {
        let [a, b] = [p, q].map(|corner| inwards.dot(*corner - through));
        if a >= 0.0 {
            inside.push(*p);
        }
        if (a >= 0.0) != (b >= 0.0) {
            inside.push(p.lerp(*q, a / (a - b)));
        }
    }
    inside
}

//! The judges' common words: differences in units that mean something.
//!
//! The tolerances are those of `f32` done in another order, in double precision, or by another formula: a right method
//! is at most a few hundred roundings (6e-8 each) from the golden answer in the questions that are asked, which leaves
//! out those whose answers hang on the last digits.

use crate::Verdict;
use glam::{Vec2, Vec3};
use raybook_workbook::exercises::ch07_mesh::MeshHitAnswer;

/// A number may differ by this fraction of its size, or of 1 if it is smaller.
pub const RELATIVE: f32 = 1e-3;

/// A direction may differ by this angle, in degrees.
pub const DEGREES: f32 = 0.1;

/// A unit vector's length may differ from 1 by this.
pub const LENGTH: f32 = 1e-3;

/// A number, with its name and its unit.
///
/// # Errors
/// If it is further away than [`RELATIVE`].
pub fn number(name: &str, unit: &str, golden: f32, got: f32) -> Verdict {
    number_within(name, unit, golden, got, RELATIVE * golden.abs().max(1.0))
}

/// A number within a distance of its own.
///
/// # Errors
/// If it is further away.
pub fn number_within(name: &str, unit: &str, golden: f32, got: f32, tolerance: f32) -> Verdict {
    let unit = if unit.is_empty() {
        String::new()
    } else {
        format!(" {unit}")
    };
    // An infinite answer has no neighbours: the tolerance would be infinite too.
    let close = golden.is_finite() && (golden - got).abs() <= tolerance;
    if golden == got || close {
        Ok(())
    } else if got.is_nan() {
        Err(format!(
            "{name} is NaN, not a number: look for 0/0, ∞ − ∞ or the root of a negative number"
        ))
    } else if got.is_infinite() || golden.is_infinite() {
        Err(format!("{name} is {got}, and should be {golden}{unit}"))
    } else {
        let (much, side) = (
            (got - golden).abs(),
            if got > golden { "large" } else { "small" },
        );
        Err(format!("{name} is {}{unit} too {side}", size(much)))
    }
}

/// A size in few digits, however small.
pub fn size(size: impl Into<f64>) -> String {
    let size = size.into();
    if size.abs() >= 0.001 || size == 0.0 {
        format!("{size:.4}")
    } else {
        format!("{size:.1e}")
    }
}

/// A point: the distance to the right one, relative to the distance from the origin.
///
/// # Errors
/// If it is too far away.
pub fn point(name: &str, golden: Vec3, got: Vec3) -> Verdict {
    finite(name, got)?;
    let off = golden.distance(got);
    if off <= RELATIVE * golden.length().max(1.0) {
        Ok(())
    } else {
        Err(format!(
            "{name} is {} m away from where it should be",
            size(off)
        ))
    }
}

/// Two numbers that belong together.
///
/// # Errors
/// If either is too far away.
pub fn pair(names: [&str; 2], golden: Vec2, got: Vec2) -> Verdict {
    number(names[0], "", golden.x, got.x)?;
    number(names[1], "", golden.y, got.y)
}

/// A direction: unit length, and the angle to the right one.
///
/// # Errors
/// If it is not of length 1, or turned.
pub fn direction(name: &str, golden: Vec3, got: Vec3) -> Verdict {
    finite(name, got)?;
    let length = got.length();
    if (length - 1.0).abs() > LENGTH {
        return Err(format!(
            "{name} has length {}; a direction has length 1",
            size(length)
        ));
    }
    // By the chord: near 0 the cosine has lost the angle's digits.
    let angle = 2.0
        * (0.5 * (got / length).distance(golden.normalize_or_zero()))
            .min(1.0)
            .asin()
            .to_degrees();
    if angle <= DEGREES {
        Ok(())
    } else {
        Err(format!(
            "{name} points {angle:.1}° away from where it should"
        ))
    }
}

/// An answer that may be missing: both or neither, then as `compare` says.
///
/// # Errors
/// If one is missing, or `compare` finds a difference.
pub fn option<T>(
    what: &str,
    golden: Option<&T>,
    got: Option<&T>,
    compare: impl FnOnce(&T, &T) -> Verdict,
) -> Verdict {
    match (golden, got) {
        (None, None) => Ok(()),
        (Some(_), None) => Err(format!("there is {what} here, but you returned none")),
        (None, Some(_)) => {
            Err(format!("there is no {what} here, but you returned one").replace("no a ", "no "))
        }
        (Some(golden), Some(got)) => compare(golden, got),
    }
}

/// The nearest triangle that is hit: the same one, at the same distance.
///
/// # Errors
/// If it is another, further away or nearer, missing or one too many.
pub fn nearest(golden: Option<&MeshHitAnswer>, got: Option<&MeshHitAnswer>) -> Verdict {
    option("a hit", golden, got, |golden, got| {
        number("t", "m", golden.t, got.t)?;
        if golden.id == got.id {
            Ok(())
        } else {
            Err(format!(
                "you returned triangle {}, and triangle {} is hit",
                got.id, golden.id
            ))
        }
    })
}

/// Points that are spread, however few, by chance or by a map of such points: no more than a tenth of them used again, and not
/// all on a line along an axis.
///
/// That of nine points two are within 1e-5 of each other along both axes has a probability of 36 · (2e-5)² = 1.4e-8, and of more
/// points more would have to be; that four are on such a line one of (2e-4)³ = 8e-12.
///
/// # Errors
/// If they are.
pub fn scattered(what: &str, points: &[Vec2]) -> Verdict {
    let mut sorted = points.to_vec();
    sorted.sort_by(|p, other| p.x.total_cmp(&other.x));
    let used = |i: &usize| {
        let p = sorted[*i];
        let before = sorted[..*i].iter().rev();
        let mut near = before.take_while(|other| p.x - other.x < 1e-5);
        near.any(|other| (p.y - other.y).abs() < 1e-5)
    };
    let again = (0..sorted.len()).filter(used).count();
    if 10 * again > points.len() {
        return Err(format!(
            "of the {} {what}, {again} are the same as others: each is to be chosen by itself",
            points.len()
        ));
    }
    let [first, _, _, _, ..] = points else {
        return Ok(());
    };
    let off = points.iter().map(|p| (*p - *first).abs());
    if off.fold(Vec2::ZERO, Vec2::max).min_element() < 1e-4 {
        return Err(format!("the {what} are all on one line along an axis"));
    }
    Ok(())
}

fn finite(name: &str, v: Vec3) -> Verdict {
    if v.is_finite() {
        Ok(())
    } else {
        Err(format!(
            "{name} is ({}, {}, {}), which is not a vector of numbers",
            v.x, v.y, v.z
        ))
    }
}

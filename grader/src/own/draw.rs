//! Hidden questions: random values of a kind, with numbers in a range.

use rand::RngExt;
use raybook::math::pcg::Pcg;
use raybook_workbook::kind::Kind;
use std::f32::consts::TAU;

/// The numbers of a field: from the least to the greatest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Range {
    /// The least number.
    pub from: f64,
    /// The greatest number.
    pub to: f64,
}

/// The greatest length of a list.
const LONGEST: u32 = 8;

/// The share of optional values that are missing.
const MISSING: f32 = 0.25;

/// Appends the numbers of a random value.
pub(super) fn draw(kind: &Kind, range: Range, rng: &mut Pcg, numbers: &mut Vec<f64>) {
    match kind {
        Kind::Number => {
            let u: f32 = rng.random();
            // As a question's words say it: in single precision.
            let number = range.from + (range.to - range.from) * f64::from(u);
            numbers.push(f64::from(number as f32));
        }
        Kind::Whole => {
            let (from, to) = (range.from.max(0.0) as u32, range.to.max(0.0) as u32);
            numbers.push(rng.random_range(from..=to.max(from)).into());
        }
        Kind::Numbers(parts) => {
            for _ in parts.parts {
                draw(&Kind::Number, range, rng, numbers);
            }
        }
        Kind::Direction => {
            // A height and an angle are uniform on the sphere (Archimedes).
            let (z, turn) = (1.0 - 2.0 * rng.random::<f32>(), TAU * rng.random::<f32>());
            let r = (1.0 - z * z).max(0.0).sqrt();
            numbers.extend([r * turn.cos(), r * turn.sin(), z].map(f64::from));
        }
        Kind::Optional(kind) => {
            let is_there = rng.random::<f32>() >= MISSING;
            numbers.push(u8::from(is_there).into());
            if is_there {
                draw(kind, range, rng, numbers);
            }
        }
        Kind::List(kind) => {
            let count = rng.random_range(0..=LONGEST);
            numbers.push(count.into());
            for _ in 0..count {
                draw(kind, range, rng, numbers);
            }
        }
        // No declaration has such a field.
        Kind::Record(_) | Kind::Choice(_) => {}
    }
}

//! The ways: what can be misread of a number, an interval, a vector, of all vectors, of two fields, and of a list.

mod axes;
mod intervals;
mod lists;
mod numbers;
mod pairs;
mod vectors;

pub(super) use axes::of_axes;
pub(super) use lists::of_list;
pub(super) use pairs::of_pair;

use super::{Change, How, Misreading};
use crate::layout::Part;
use intervals::interval;
use numbers::{numbers, wholes};
use raybook_workbook::kind::{Kind, VECTOR};
use vectors::vector;

/// What can be misread of one field.
pub(super) fn of_part(i: usize, part: &Part, all: &mut Vec<Misreading>) {
    let name = &part.name;
    let mut each = |what: String, rank, hint: &str, f| {
        all.push(Misreading::new(
            what,
            hint.replace("{}", name),
            rank,
            How::Each(i, f),
        ));
    };
    match part.kind {
        Kind::Number => numbers(name, &mut each),
        Kind::Whole => wholes(name, &mut each),
        Kind::Numbers(numbers) if numbers.name == "Interval" => interval(i, name, all),
        Kind::Numbers(numbers) => vector(i, name, numbers.parts, false, all),
        Kind::Direction => vector(i, name, VECTOR.parts, true, all),
        _ => {}
    }
}

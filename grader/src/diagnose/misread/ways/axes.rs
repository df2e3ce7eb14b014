//! What can be misread of all vectors at once: a line that is written for one axis and copied for the next.

use super::{How, Misreading};
use crate::layout::Part;
use raybook_workbook::kind::{Kind, VECTOR};

/// The ways to take one axis for another wherever there is a vector that may be misread.
pub fn of_axes(parts: &[Part], free: &dyn Fn(&Part) -> bool, all: &mut Vec<Misreading>) {
    let is_vector = |part: &Part| match part.kind {
        Kind::Direction => true,
        Kind::Numbers(numbers) => numbers.name == VECTOR.name,
        _ => false,
    };
    let vectors = parts.iter().enumerate();
    let vectors = vectors.filter(|(_, part)| is_vector(part) && free(part));
    let vectors: Vec<_> = vectors.map(|(i, _)| i).collect();
    // Of a single vector it is a mistake in its components.
    if vectors.len() < 2 {
        return;
    }
    for (of, from) in VECTOR.parts.iter().zip(0..) {
        for (axis, to) in VECTOR.parts.iter().zip(0..).filter(|(_, to)| *to != from) {
            let what =
                format!("takes {of} for {axis} in every vector, as in a line that was copied");
            let hint = format!(
                "Compare your line for {axis} with that for {of}, letter by letter: what must change?"
            );
            let copy = move |v: &mut [f64]| v[to] = v[from];
            let how = How::All(vectors.clone(), Box::new(copy));
            all.push(Misreading::new(what, hint, 15, how));
        }
    }
}

//! Where two answers part: which field, and by how much.

use crate::layout::{Layout, layout, lists, parts};
use raybook_workbook::kind::{Kind, VECTOR};

/// A field in which a student's answer is not the right one.
#[derive(Clone, Debug, PartialEq)]
pub struct Parting {
    /// The field's name; the element's number too, if it is in a list.
    pub field: String,
    /// The student's number; a list's length.
    pub yours: f64,
    /// The right number.
    pub right: f64,
}

/// Less than this, relatively, is rounding in single precision.
const ROUNDING: f64 = 1e-5;

/// The fields in which two answers of a kind differ by more than rounding, in order. Where one has values that the other has not,
/// only that is told: `None`, or lists of another length.
pub fn partings(kind: &'static Kind, name: &str, right: &[f64], yours: &[f64]) -> Vec<Parting> {
    let [of_right, of_yours] = [right, yours].map(|row| layout(kind, row));
    let lengths = lengths(kind, name, [&of_right, &of_yours]);
    if !lengths.is_empty() {
        return lengths;
    }
    let parts = parts(kind, name);
    let mut seen = vec![0; parts.len()];
    let mut found = Vec::new();
    for (leaf, other) in of_right.leaves.iter().zip(&of_yours.leaves) {
        let part = &parts[leaf.part];
        let letters = match part.kind {
            Kind::Numbers(parts) => parts.parts,
            Kind::Direction => VECTOR.parts,
            _ => &[],
        };
        let element = part.list.map(|_| format!("[{}]", seen[leaf.part]));
        seen[leaf.part] += 1;
        let pairs = right[leaf.range()].iter().zip(&yours[other.range()]);
        for (i, (&right, &yours)) in pairs.enumerate() {
            let scale = right.abs().max(ROUNDING);
            let same = right == yours || (right - yours).abs() <= ROUNDING * scale;
            if !same {
                let letter = letters.get(i).map(|letter| format!(".{letter}"));
                let field = [Some(part.name.clone()), element.clone(), letter];
                let field = field.into_iter().flatten().collect();
                found.push(Parting {
                    field,
                    yours,
                    right,
                });
            }
        }
    }
    found
}

/// The lists whose lengths differ.
fn lengths(kind: &Kind, name: &str, [right, yours]: [&Layout; 2]) -> Vec<Parting> {
    let names = lists(kind, name);
    let pairs = right.lists.iter().zip(&yours.lists);
    let differ = pairs.filter(|(right, yours)| right.elements.len() != yours.elements.len());
    let parting = |(right, yours): (&crate::layout::Span, &crate::layout::Span)| Parting {
        field: format!(
            "the number of {}",
            names.get(right.list).map_or(name, String::as_str)
        ),
        yours: yours.elements.len() as f64,
        right: right.elements.len() as f64,
    };
    differ.map(parting).collect()
}

impl Parting {
    /// By how much the student's number is too large, or below 0 too small; none where a number is not finite.
    pub fn off(&self) -> Option<f64> {
        Some(self.yours - self.right).filter(|off| off.is_finite())
    }
}

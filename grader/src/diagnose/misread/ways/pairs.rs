//! What can be misread of two fields of the same kind.

use super::{How, Misreading};
use crate::layout::Part;
use raybook_workbook::kind::Kind;

/// The ways to take one field for the other.
pub fn of_pair((i, one): (usize, &Part), (j, other): (usize, &Part), all: &mut Vec<Misreading>) {
    let (a, b) = (&one.name, &other.name);
    let mut pair = |what: String, rank, hint: String, f| {
        let how = How::Pair(i, j, f);
        all.push(Misreading::new(what, hint, rank, how));
    };
    pair(
        format!("exchanges {a} and {b}"),
        11,
        format!(
            "Which of your arguments is `{a}`, and which is `{b}`? Let one of them be 1 and the other 2, and calculate by hand."
        ),
        <[f64]>::swap_with_slice,
    );
    let twice = format!(
        "Change `{a}` alone, then `{b}` alone: does your answer change both times as it should?"
    );
    pair(
        format!("takes {a} for {b} too"),
        14,
        twice.clone(),
        |a, b| b.copy_from_slice(a),
    );
    pair(format!("takes {b} for {a} too"), 14, twice, |a, b| {
        a.copy_from_slice(b);
    });
    if matches!(one.kind, Kind::Direction | Kind::Whole) {
        return;
    }
    let relative = format!("Is `{a}` measured from `{b}` or from somewhere else? Draw both.");
    pair(
        format!("takes {a} − {b} for {a}"),
        17,
        relative.clone(),
        |a, b| {
            a.iter_mut().zip(b).for_each(|(a, b)| *a -= *b);
        },
    );
    pair(
        format!("takes {b} − {a} for {b}"),
        17,
        relative.clone(),
        |a, b| {
            b.iter_mut().zip(a).for_each(|(b, a)| *b -= *a);
        },
    );
    pair(
        format!("takes {a} + {b} for {a}"),
        18,
        relative.clone(),
        |a, b| {
            a.iter_mut().zip(b).for_each(|(a, b)| *a += *b);
        },
    );
    pair(format!("takes {a} + {b} for {b}"), 18, relative, |a, b| {
        b.iter_mut().zip(a).for_each(|(b, a)| *b += *a);
    });
}

//! How far an answer may be from the golden one, measured: the judge is asked about answers that are more and more wrong.

use crate::examine::Examiner;
use crate::finite::finite;
use crate::layout::layout;
use raybook_workbook::kind::Kind;

/// How far a number may be off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Leeway {
    /// By nothing that matters: less than one part in a thousand million.
    Exact,
    /// By this number.
    Within(f64),
    /// By anything.
    Free,
}

/// The elements of a list longer than this are moved all alike: an answer of many samples is compared as a whole.
pub const LONG: usize = 32;

/// How many values of a part are tried in one answer.
const TRIED: usize = 3;

/// How often the error is doubled, from 10⁻⁹ of the number.
const DOUBLINGS: i32 = 60;

/// How far each tried value of part number `part` of the right answer to a question may be above it, and how far below it.
pub fn leeways(
    examiner: &dyn Examiner,
    question: &[f64],
    golden: &[f64],
    part: usize,
) -> Vec<[Leeway; 2]> {
    let answer = &examiner.asked().answer;
    let layout = layout(answer.kind, golden);
    let leaves: Vec<_> = layout.of_part(part).collect();
    let Some(width) = leaves.first().map(|leaf| leaf.len) else {
        return Vec::new();
    };
    let is_right = |places: &[usize], error: f64| {
        let mut got = golden.to_vec();
        for &place in places {
            got[place] += error;
        }
        let verdict = examiner.compare(question, golden, &got);
        verdict.and_then(|()| finite(answer, golden, &got)).is_ok()
    };
    let together = leaves.len() > LONG;
    let step = leaves.len().div_ceil(TRIED);
    let mut found = Vec::new();
    for component in 0..width {
        let place = |leaf: &&crate::layout::Leaf| leaf.start + component;
        let groups: Vec<Vec<usize>> = if together {
            vec![leaves.iter().map(place).collect()]
        } else {
            let some = leaves.iter().step_by(step);
            some.map(|leaf| vec![place(leaf)]).collect()
        };
        for places in groups {
            let size = places.iter().map(|&place| golden[place].abs());
            let size = size.fold(0.0, f64::max);
            if size.is_finite() {
                let whole = is_whole(answer.kind, part);
                let off = |sign| leeway(size, whole, |error| is_right(&places, sign * error));
                found.push([off(1.0), off(-1.0)]);
            }
        }
    }
    found
}

/// The largest error that is still right; errors grow by factors of 2.
fn leeway(size: f64, whole: bool, is_right: impl Fn(f64) -> bool) -> Leeway {
    let first = if whole { 1.0 } else { 1e-9 * size.max(1e-3) };
    let mut largest = None;
    for doubling in 0..DOUBLINGS {
        let error = first * 2_f64.powi(doubling);
        if !is_right(error) {
            return largest.map_or(Leeway::Exact, Leeway::Within);
        }
        largest = Some(error);
    }
    Leeway::Free
}

/// Whether the values of a part are whole numbers.
fn is_whole(kind: &'static Kind, part: usize) -> bool {
    let parts = crate::layout::parts(kind, "");
    parts
        .get(part)
        .is_some_and(|part| *part.kind == Kind::Whole)
}

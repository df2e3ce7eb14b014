//! Walks through a grid whose cells students look for in the plane between two cells.

use super::{is_there, passed, start};
use crate::judge;
use raybook_workbook::exercises::ch08_grid::{GridWalk, Visit};

/// What the judge says of a walk whose cells were looked for at the wrong end of the ray's way through them.
pub(super) const AT_ENTRY: &str = "where the ray enters the right cell";
pub(super) const AT_EXIT: &str = "where the ray goes on from the right cell";

/// What is wrong with a walk of right distances, all of whose wrong cells meet the ray where it enters the right ones, or where it leaves
/// them.
pub(super) fn at_an_end(q: &GridWalk, golden: &[Visit], got: &[Visit]) -> Option<String> {
    let (right, yours) = (passed(q, golden), passed(q, got));
    let is_left = |(right, yours): (&Visit, &Visit)| {
        judge::number("leave", "m", right.leave, yours.leave).is_ok()
    };
    if right.len() != yours.len() || !right.iter().zip(&yours).all(is_left) {
        return None;
    }
    let enters = std::iter::once(start(q)).chain(right.iter().map(|visit| visit.leave));
    let all = enters.zip(right.iter().zip(&yours));
    let wrong: Vec<_> = all.filter(|(_, (r, y))| r.cell() != y.cell()).collect();
    let (_, (first, instead)) = wrong.first()?;
    let at = |leave: f32, visit: &Visit| {
        let visit = Visit {
            leave,
            ..visit.clone()
        };
        is_there(q, &visit).is_ok()
    };
    let place = if wrong.iter().all(|(enter, (_, yours))| at(*enter, yours)) {
        AT_ENTRY
    } else if wrong.iter().all(|(_, (_, yours))| at(yours.leave, yours)) {
        AT_EXIT
    } else {
        return None;
    };
    let (first, instead) = (first.cell(), instead.cell());
    Some(format!(
        "your walk has the right distances, but cell {instead} for {first}: it is {place}"
    ))
}

//! Walks through a grid in steps of one length along the ray, at the end of which students look for the cell.

use super::{start, touch};
use crate::judge::size;
use glam::UVec3;
use raybook::math::slab;
use raybook_workbook::exercises::ch08_grid::{GridWalk, Visit};

/// What such a walk does.
pub(super) const MARCHES: &str = "goes along the ray in steps of one length, so that distances are wrong by up to a step, and misses cells in which the ray stays shorter";

/// What leads from steps to planes.
pub(super) const MARCHES_HINT: &str = "Between two of your steps the ray crosses a plane of the lattice: at which distance, and might it cross a second one? Can you calculate these distances, instead of trying?";

/// What the judge says of a walk that may be such a one.
pub(super) const SHORT: &str = "less than half a cell";

/// The walk in steps of this length, from where the ray enters the lattice or the interval begins. A visit ends at the first step in another
/// cell, and the last one where the ray leaves the lattice or the interval ends.
pub(super) fn marched(q: &GridWalk, step: f64) -> Vec<Visit> {
    let stays = stays(q, step, 0.0).into_iter();
    let visit = |(UVec3 { x, y, z }, leave): (UVec3, f64)| {
        let leave = leave as f32;
        Visit { x, y, z, leave }
    };
    stays.map(visit).collect()
}

/// The cells that such steps find, each with the distance at which the ray leaves the cell.
pub(super) fn looked_up(q: &GridWalk, step: f64) -> Vec<Visit> {
    /// Students begin a little behind the plane through which the ray enters.
    const INSIDE: f64 = 1e-6;
    let lattice = q.lattice();
    let visit = |(cell, next): (UVec3, f64)| {
        let stay = slab::clip(&lattice.bounds_of(cell, cell), &q.ray, q.within);
        let leave = stay.map_or(next as f32, |stay| stay.max);
        let UVec3 { x, y, z } = cell;
        Visit { x, y, z, leave }
    };
    stays(q, step, INSIDE).into_iter().map(visit).collect()
}

/// The cells in which such steps end, the first one this far inside, and each with the first step in another cell.
fn stays(q: &GridWalk, step: f64, inside: f64) -> Vec<(UVec3, f64)> {
    /// More steps are not taken: a misread question may have cells of no extent.
    const MOST: usize = 100_000;
    let lattice = q.lattice();
    let Some(part) = slab::clip(&lattice.bounds(), &q.ray, q.within) else {
        return Vec::new();
    };
    let [from, to] = [part.min, part.max].map(f64::from);
    let (o, d) = (q.ray.origin.as_dvec3(), q.ray.direction.as_dvec3());
    let cell_at = |t: f64| {
        let place = (o + t * d - lattice.min.as_dvec3()) / lattice.cell.as_dvec3();
        let last = lattice.resolution - 1;
        place.as_uvec3().min(last)
    };
    let mut stays = Vec::new();
    let add = |t: &f64| Some(t + step);
    let mut steps = std::iter::successors(Some(from + inside), add)
        .take_while(|t| *t < to)
        .take(MOST);
    let Some(mut cell) = steps.next().map(cell_at) else {
        return stays;
    };
    for t in steps {
        let next = cell_at(t);
        if next != cell {
            stays.push((cell, t));
            cell = next;
        }
    }
    stays.push((cell, to));
    stays
}

/// What is wrong with a walk that may be such a one, by steps shorter than half a cell: its cells are some of the right ones, in the same order;
/// it leaves all of them too late by less than such a step, or all too early; and it misses none in which the ray stays longer.
pub(super) fn less_than_a_step(q: &GridWalk, golden: &[Visit], got: &[Visit]) -> Option<String> {
    let longest = 0.5 * q.cell.min_element();
    let mut right = golden.iter();
    let mut enter = start(q);
    let mut stay = |visit: &Visit| {
        let stay = visit.leave - enter;
        enter = visit.leave;
        (visit.cell(), stay)
    };
    let (mut missed, mut off) = (Vec::new(), Vec::new());
    for visit in got {
        let (cell, leave) = loop {
            let next = right.next()?;
            let (cell, stay) = stay(next);
            if cell == visit.cell() {
                break (cell, next.leave);
            }
            missed.push((cell, stay));
        };
        off.push((cell, visit.leave - leave));
    }
    missed.extend(right.map(stay));
    let (late, early) = (most(&off, 1.0)?, most(&off, -1.0)?);
    let missed = most(&missed, 1.0).unwrap_or((UVec3::ZERO, 0.0));
    let is_exact = |(_, by): (UVec3, f32)| by <= touch(q);
    let is_less = |(_, by): (UVec3, f32)| by < longest;
    if !(is_exact(late) || is_exact(early)) || ![late, early, missed].into_iter().all(is_less) {
        return None;
    }
    let what = match [late, early].map(is_exact) {
        [false, _] => format!("it leaves cell {} {} m too late", late.0, size(late.1)),
        [_, false] => format!("it leaves cell {} {} m too early", early.0, size(early.1)),
        _ => format!(
            "it misses cell {}, in which the ray stays for {} m",
            missed.0,
            size(missed.1)
        ),
    };
    Some(format!("your walk is wrong by {SHORT}: {what}"))
}

/// The cell with the greatest of numbers, each times the sign.
fn most(of: &[(UVec3, f32)], sign: f32) -> Option<(UVec3, f32)> {
    let all = of.iter().map(|(cell, by)| (*cell, sign * by));
    all.max_by(|(_, a), (_, b)| a.total_cmp(b))
}

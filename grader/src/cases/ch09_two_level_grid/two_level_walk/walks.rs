//! Walks through two levels as students write them: with other places of the fine cells, another end in empty cells, or steps of one length.

use super::cells;
use crate::Graded;
use crate::upon::changed;
use glam::UVec3;
use raybook::inside::grid::walk;
use raybook::math::{aabb::Aabb, slab};
use raybook_workbook::exercises::ch09_two_level_grid::TwoLevelWalk;
use std::ops::ControlFlow;

/// The walk with another number for the fine cell x, y, z of nx × ny × nz.
pub(super) fn numbered(
    q: &TwoLevelWalk,
    number: fn(&TwoLevelWalk, [u32; 3], [u32; 3]) -> u32,
) -> Vec<u32> {
    let levels = q.levels();
    let renumbered = |place: u32| {
        let mut cuts = levels.cuts.iter();
        let Some(cut) = cuts.rfind(|cut| cut.first <= place && cut.resolution.x > 0) else {
            return place;
        };
        let n = cut.resolution.as_uvec3().to_array();
        let at = place - cut.first;
        cut.first + number(q, [at % n[0], at / n[0] % n[1], at / n[0] / n[1]], n)
    };
    TwoLevelWalk::right(q).into_iter().map(renumbered).collect()
}

/// The walk with another number of fine cells before those of a coarse cell, from the resolutions of the coarse cells up to this
/// one.
pub(super) fn before_is(q: &TwoLevelWalk, before: impl Fn(&[UVec3]) -> u32) -> Vec<u32> {
    let levels = q.levels();
    let cuts: Vec<_> = levels.cuts.iter().collect();
    let along: Vec<_> = cuts.iter().map(|cut| cut.resolution.as_uvec3()).collect();
    let moved = |place: u32| {
        let of = cuts
            .iter()
            .rposition(|cut| cut.first <= place && cut.resolution.x > 0);
        of.map_or(place, |of| place - cuts[of].first + before(&along[..=of]))
    };
    TwoLevelWalk::right(q).into_iter().map(moved).collect()
}

/// The place of a cell x, y, z of nx × ny × nz.
pub(super) type Place = fn([u32; 3], [u32; 3]) -> u32;

/// What a walk does in an empty coarse cell.
#[derive(Clone, Copy)]
pub(super) enum AtEmpty {
    /// Goes on to the next.
    GoesOn,
    /// Ends.
    Ends,
    /// Visits the place at which its fine cells would begin.
    Visits,
}

/// How cells are looked up; one field wrong is a mistake.
#[derive(Clone, Copy)]
pub(super) struct Look {
    /// The place of a coarse cell in the row of all.
    pub(super) coarse: Place,
    /// The place of a fine cell among those of its coarse cell.
    pub(super) fine: Place,
    /// What is done in an empty coarse cell.
    pub(super) at_empty: AtEmpty,
}

/// As it should be.
const WELL: Look = Look {
    coarse: along_x,
    fine: along_x,
    at_empty: AtEmpty::GoesOn,
};

/// The walk, looked up rightly but for what is changed.
pub(super) fn looked_up(q: &TwoLevelWalk, change: fn(&mut Look)) -> Vec<u32> {
    let how = changed(WELL, change);
    let levels = q.levels();
    let n = levels.top.resolution;
    let mut places = Vec::new();
    walk(&levels.top, &q.ray, q.within, |coarse, inside| {
        let place = (how.coarse)(coarse.into(), n.into()) as usize;
        let Some(cut) = levels.cuts.get(place) else {
            return ControlFlow::Continue(());
        };
        if cut.resolution.x == 0 {
            match how.at_empty {
                AtEmpty::GoesOn => {}
                AtEmpty::Ends => return ControlFlow::Break(()),
                AtEmpty::Visits => places.push(cut.first),
            }
            return ControlFlow::Continue(());
        }
        let fine = cut.resolution.as_uvec3();
        let (begin, last) = (coarse * fine, fine - UVec3::ONE);
        let before = places.len();
        walk(&levels.cut(fine), &q.ray, inside, |cell, _| {
            let cell = cell.clamp(begin, begin + last) - begin;
            let place = cut.first + (how.fine)(cell.into(), fine.into());
            if places[before..].last() != Some(&place) {
                places.push(place);
            }
            ControlFlow::Continue(())
        });
        ControlFlow::Continue(())
    });
    places
}

/// The box of a fine cell, from that of its coarse cell and from its own.
type Boxes = fn(coarse: &Aabb, fine: Aabb) -> Aabb;

/// The walk through all fine cells whose boxes the ray crosses, in the order of the distances, if the boxes are made of a coarse cell and of
/// one of its fine cells by `change`.
pub(super) fn by_boxes(q: &TwoLevelWalk, change: Boxes) -> Vec<u32> {
    let boxes = changed((|_, fine| fine) as Boxes, |boxes| *boxes = change);
    let levels = q.levels();
    let fine_of = |coarse| levels.fine(coarse).map(|(_, fine)| (coarse, fine));
    let mut crossed = Vec::new();
    let mut place = 0;
    for (coarse, fine) in levels.top.all().filter_map(fine_of) {
        let around = levels.top.bounds_of(coarse, coarse);
        for cell in fine.all() {
            let bounds = boxes(&around, fine.bounds_of(cell, cell));
            let stay = slab::clip(&bounds, &q.ray, q.within);
            let middle = stay.filter(|stay| stay.min < stay.max);
            crossed.extend(middle.map(|stay| (stay.min + stay.max, place)));
            place += 1;
        }
    }
    crossed.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    crossed.into_iter().map(|(_, place)| place).collect()
}

/// The place of a cell if those along x come first, then those along y.
fn along_x([x, y, z]: [u32; 3], [nx, ny, _]: [u32; 3]) -> u32 {
    x + nx * (y + ny * z)
}

/// The walk in steps of one length along the ray, from where it enters the grid or the interval begins: a step's length is made of the smallest
/// side of a fine cell, and `begin` is the share of a step after which the first place is asked for its cell. A cell is visited once.
/// Rounding does not take the first place out of the grid.
pub(super) fn marched(q: &TwoLevelWalk, length: fn(f64) -> f64, begin: f64) -> Vec<u32> {
    /// More steps are not taken: a misread question may have cells of no extent.
    const MOST: usize = 10_000;
    let bounds = q.levels().top.bounds();
    let (cells, inside) = (cells(q), slab::clip(&bounds, &q.ray, q.within));
    let Some(inside) = inside.filter(|_| !cells.is_empty()) else {
        return Vec::new();
    };
    let sides = cells.iter().map(|cell| cell.size().min_element());
    let step = length(f64::from(sides.fold(f32::INFINITY, f32::min)));
    let [from, to] = [inside.min, inside.max].map(f64::from);
    let (o, d) = (q.ray.origin.as_dvec3(), q.ray.direction.as_dvec3());
    let mut places = Vec::new();
    let mut t = from + begin * step;
    for _ in 0..MOST {
        if t >= to {
            break;
        }
        let p = (o + t * d).clamp(bounds.min.as_dvec3(), bounds.max.as_dvec3());
        for (place, cell) in (0..).zip(&cells) {
            let is_inside =
                cell.min.as_dvec3().cmple(p).all() && p.cmple(cell.max.as_dvec3()).all();
            if is_inside && !places.contains(&place) {
                places.push(place);
            }
        }
        t += step;
    }
    places
}

//! Clips as students write them: of slabs whose planes are in the wrong order, of overlaps that are none, of faces that are crossed.

use glam::DVec3;
use raybook::math::interval::Interval;
use raybook_workbook::exercises::ch05_box::BoxClip;
use std::ops::Range;

/// Where the whole line enters and leaves the slab of an axis; by the right rule.
pub(super) fn slab(q: &BoxClip, axis: usize) -> (f32, f32) {
    let (o, d) = (q.ray.origin[axis], q.ray.direction[axis]);
    let (a, b) = ((q.min[axis] - o) / d, (q.max[axis] - o) / d);
    if d.is_sign_negative() { (b, a) } else { (a, b) }
}

/// Clips by three slabs, with a rule for the entries and the interval's min, and one for the exits and its max.
pub(super) fn folded(
    q: &BoxClip,
    enter: fn(f32, f32) -> f32,
    leave: fn(f32, f32) -> f32,
) -> Option<Interval> {
    let slabs = (0..3).map(|axis| slab(q, axis));
    let (min, max) = slabs.fold((q.within.min, q.within.max), |(min, max), (near, far)| {
        (enter(min, near), leave(max, far))
    });
    finish(min, max)
}

/// Clips by the slabs of the axes along which the ray moves. Of each slab, whose planes are at `near` and `far`, `enter` makes the next entry,
/// and `leave` the next exit; `start` and `end` are the ends of the interval.
pub(super) fn folded_from(
    q: &BoxClip,
    enter: fn(entry: f32, near: f32, start: f32) -> f32,
    leave: fn(exit: f32, far: f32, end: f32) -> f32,
) -> Option<Interval> {
    let Interval {
        min: start,
        max: end,
    } = q.within;
    let slabs = crossed(q)?.into_iter();
    let (min, max) = slabs.fold((start, end), |(min, max), (_, (near, far))| {
        (enter(min, near, start), leave(max, far, end))
    });
    finish(min, max)
}

/// Clips by three slabs, by a rule for the order of the planes and one for when there is anything left.
pub(super) fn slabs(
    q: &BoxClip,
    order: fn(f32, f32, f32) -> (f32, f32),
    keep: fn(f32, f32) -> bool,
) -> Option<Interval> {
    let Interval { mut min, mut max } = q.within;
    for axis in 0..3 {
        let (o, d) = (q.ray.origin[axis], q.ray.direction[axis]);
        let (near, far) = order((q.min[axis] - o) / d, (q.max[axis] - o) / d, d);
        (min, max) = (min.max(near), max.min(far));
    }
    keep(min, max).then_some(Interval { min, max })
}

pub(super) fn finish(min: f32, max: f32) -> Option<Interval> {
    (max - min >= 0.0).then_some(Interval { min, max })
}

/// The axes along which the ray moves, each with where the whole line enters and leaves its slab; nothing for a ray outside of a
/// slab that it runs along.
pub(super) fn crossed(q: &BoxClip) -> Option<Vec<(usize, (f32, f32))>> {
    let is_beside = |axis: usize| {
        let slab = q.min[axis]..=q.max[axis];
        q.ray.direction[axis] == 0.0 && !slab.contains(&q.ray.origin[axis])
    };
    let moves = |axis: &usize| q.ray.direction[*axis] != 0.0;
    let slabs = (0..3).filter(moves).map(|axis| (axis, slab(q, axis)));
    (!(0..3).any(is_beside)).then(|| slabs.collect())
}

/// What is in the interval and in all of these parts of the line.
pub(super) fn overlap(q: &BoxClip, parts: impl Iterator<Item = (f32, f32)>) -> Option<Interval> {
    let (min, max) = parts.fold((q.within.min, q.within.max), |(min, max), (near, far)| {
        (min.max(near), max.min(far))
    });
    finish(min, max)
}

/// Clips by the slabs, of which those of some axes have the planes in the order of the axis, whichever way the ray goes.
pub(super) fn unswapped(q: &BoxClip, axes: Range<usize>) -> Option<Interval> {
    let parts = crossed(q)?.into_iter().map(|(axis, (near, far))| {
        if axes.contains(&axis) && q.ray.direction[axis] < 0.0 {
            (far, near)
        } else {
            (near, far)
        }
    });
    overlap(q, parts)
}

/// The part in the last slab, where the part in each slab overlaps the one before.
pub(super) fn of_last_axis(q: &BoxClip) -> Option<Interval> {
    let mut last = (q.within.min, q.within.max);
    for (_, (near, far)) in crossed(q)? {
        if far < last.0 || near > last.1 {
            return None;
        }
        last = (near, far);
    }
    finish(last.0.max(q.within.min), last.1.min(q.within.max))
}

/// Clips by three slabs, whose planes are ordered by the signs of these components of the direction.
pub(super) fn ordered_by(q: &BoxClip, signs: [usize; 3]) -> Option<Interval> {
    let goes_down = |axis: usize| q.ray.direction[axis] < 0.0;
    let ordered = |(axis, (near, far))| {
        if goes_down(axis) == goes_down(signs[axis]) {
            (near, far)
        } else {
            (far, near)
        }
    };
    overlap(q, crossed(q)?.into_iter().map(ordered))
}

/// The faces that the ray crosses in the interval, each by its axis and its distance.
pub(super) fn faces_crossed(q: &BoxClip) -> Vec<(usize, f64)> {
    let [from, to] = [q.within.min, q.within.max].map(f64::from);
    let (o, d) = (q.ray.origin.as_dvec3(), q.ray.direction.as_dvec3());
    let mut hits = Vec::new();
    for axis in (0..3).filter(|&axis| d[axis] != 0.0) {
        for plane in [q.min[axis], q.max[axis]] {
            let t = (f64::from(plane) - o[axis]) / d[axis];
            let is_beside = |other: usize| other != axis && !is_between(q, o + t * d, other);
            if (from..=to).contains(&t) && !(0..3).any(is_beside) {
                hits.push((axis, t));
            }
        }
    }
    hits
}

/// Whether a point is between the two planes across an axis, or in one of them.
fn is_between(q: &BoxClip, p: DVec3, axis: usize) -> bool {
    /// Further away from a plane than by rounding, in metres.
    const ROUNDING: f64 = 1e-6;
    let [low, high] = [q.min[axis], q.max[axis]].map(f64::from);
    (low - ROUNDING..=high + ROUNDING).contains(&p[axis])
}

/// The same hits without those at the distance of another across another axis: an edge counts once.
pub(super) fn of_different_axes(hits: &[(usize, f64)]) -> Vec<(usize, f64)> {
    let mut kept: Vec<(usize, f64)> = Vec::new();
    for &(axis, t) in hits {
        let is_edge = |(other, u): &(usize, f64)| *other != axis && (t - u).abs() < 1e-6;
        if !kept.iter().any(is_edge) {
            kept.push((axis, t));
        }
    }
    kept
}

/// The part from the nearest hit to the farthest, and by `alone` where there is only one; without any, the whole interval if it begins inside.
pub(super) fn between(
    q: &BoxClip,
    hits: &[(usize, f64)],
    alone: fn(&BoxClip, f64) -> (f64, f64),
) -> Option<Interval> {
    let (min, max) = match hits {
        [] => {
            let begin = q.ray.at(q.within.min).as_dvec3();
            let is_inside = (0..3).all(|axis| is_between(q, begin, axis));
            return is_inside.then_some(q.within);
        }
        [(_, t)] => alone(q, *t),
        [(_, first), more @ ..] => {
            let ends = |(min, max): (f64, f64), (_, t): &(usize, f64)| (min.min(*t), max.max(*t));
            more.iter().fold((*first, *first), ends)
        }
    };
    finish(min as f32, max as f32)
}

//! Clips as students write them: of slabs whose planes are in the wrong order, of overlaps that are none, of faces that are crossed.

use crate::upon::changed;
use crate::{Graded, sample};
use raybook::math::interval::Interval;
use raybook_workbook::exercises::ch05_box::BoxClip;
use std::cmp::Ordering;

/// How a ray is clipped by the slabs of a box, one after the other; one field wrong is a mistake.
#[derive(Clone, Copy)]
pub(super) struct How {
    /// The two planes across an axis.
    pub(super) planes: fn(q: &BoxClip, axis: usize) -> [f32; 2],
    /// What is made of a ray that does not move along an axis.
    pub(super) parallel: Parallel,
    /// How far away a plane is that is behind some way along an axis, along which the ray has the direction `d`.
    pub(super) distance: fn(way: f32, d: f32) -> f32,
    /// The component of the direction by whose sign the planes across each axis are swapped; none, where they never are.
    pub(super) swapped_by: [Option<usize>; 3],
    /// Both planes' distances in their order, where the ray goes `down` the axis or not.
    pub(super) order: fn(a: f32, b: f32, down: bool) -> (f32, f32),
    /// Of what the first slab leaves a part.
    pub(super) start: fn(within: Interval) -> Interval,
    /// Whether anything is left of a part, as far as this is asked before the slab of an axis is cut from it.
    pub(super) check: fn(axis: usize, part: Interval, slab: Interval) -> bool,
    /// The next entry, made of the one before, the slab's, and the interval's beginning.
    pub(super) enter: fn(entry: f32, near: f32, start: f32) -> f32,
    /// The next exit, made of the one before, the slab's, and the interval's end.
    pub(super) leave: fn(exit: f32, far: f32, end: f32) -> f32,
    /// Whether a slab that moves the entry does not move the exit.
    pub(super) is_either: bool,
    /// Whether the interval is cut out of the part at the end, too.
    pub(super) is_cut_at_end: bool,
    /// Whether anything is left at the end. Of an endless interval, both ends may be ∞: then, nothing.
    pub(super) is_left: fn(part: Interval) -> bool,
}

/// What is made of a ray that runs along a slab.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Parallel {
    /// It misses the box if it is outside of the slab, which else cuts off nothing.
    Asked,
    /// The slab cuts off nothing.
    Skipped,
    /// It is divided by 0.
    Divided,
}

/// As it should be.
const WELL: How = How {
    planes: |q, axis| [q.min[axis], q.max[axis]],
    parallel: Parallel::Asked,
    distance: |way, d| way / d,
    swapped_by: [Some(0), Some(1), Some(2)],
    order: |a, b, down| if down { (b, a) } else { (a, b) },
    start: |within| within,
    check: |_, _, _| true,
    enter: |entry, near, _| entry.max(near),
    leave: |exit, far, _| exit.min(far),
    is_either: false,
    is_cut_at_end: false,
    is_left: |part| part.max - part.min >= 0.0,
};

/// `max(near, entry)` as in Python and C++, where a comparison with NaN is false: it takes the first of two numbers if one is NaN.
pub(super) const NEAR_FIRST: End = |entry, near, _| if entry > near { entry } else { near };

/// `min(far, exit)` as in Python and C++.
pub(super) const FAR_FIRST: End = |exit, far, _| if exit < far { exit } else { far };

/// `min` and `max` of both distances as in Python and C++.
pub(super) const MIN_AND_MAX: fn(a: f32, b: f32, down: bool) -> (f32, f32) =
    |a, b, _| (if b < a { b } else { a }, if b > a { b } else { a });

/// Not empty, as who asks whether the beginning is behind the end: of NaN that is not known.
pub(super) const IS_NOT_EMPTY: fn(part: Interval) -> bool =
    |part| part.min.partial_cmp(&part.max) != Some(Ordering::Greater);

/// An end, made of the one before, a slab's, and the interval's.
type End = fn(before: f32, slab: f32, interval: f32) -> f32;

/// The part of the ray inside the box, rightly but for what is changed.
pub(super) fn clipped(q: &BoxClip, change: fn(&mut How)) -> Option<Interval> {
    let how = changed(WELL, change);
    let mut part = (how.start)(q.within);
    for axis in 0..3 {
        let (o, d) = (q.ray.origin[axis], q.ray.direction[axis]);
        let planes = (how.planes)(q, axis);
        if d == 0.0 && how.parallel != Parallel::Divided {
            if how.parallel == Parallel::Asked && !(planes[0]..=planes[1]).contains(&o) {
                return None;
            }
            continue;
        }
        let [a, b] = planes.map(|plane| (how.distance)(plane - o, d));
        // Divided by −0, the planes are in the other order; of another component, −0 is not below 0.
        let is_down = |by: usize| q.ray.direction[by] < 0.0 || (by == axis && d.is_sign_negative());
        let (near, far) = (how.order)(a, b, how.swapped_by[axis].is_some_and(is_down));
        let slab = Interval::new(near, far);
        if !(how.check)(axis, part, slab) {
            return None;
        }
        if !(how.is_either && near > part.min) {
            part.max = (how.leave)(part.max, far, q.within.max);
        }
        part.min = (how.enter)(part.min, near, q.within.min);
    }
    if how.is_cut_at_end {
        part = overlap(part, q.within)?;
    }
    (how.is_left)(part).then_some(part)
}

/// What is in both of two parts.
pub(super) fn overlap(a: Interval, b: Interval) -> Option<Interval> {
    let (min, max) = (a.min.max(b.min), a.max.min(b.max));
    (min <= max).then_some(Interval { min, max })
}

/// The part of the whole line inside the box.
pub(super) fn whole(q: &BoxClip) -> Option<Interval> {
    BoxClip::misread(q, |q| q.within = sample::LINE)
}

/// Where the ray crosses faces of the box in the interval: twice at most.
pub(super) fn crossings(q: &BoxClip) -> Vec<f32> {
    let is_within = |t: &f32| (q.within.min..=q.within.max).contains(t);
    let ends = whole(q).into_iter().flat_map(|part| [part.min, part.max]);
    ends.filter(is_within).collect()
}

/// The part that is right, but by `alone` where only one of these crossings is in the interval.
pub(super) fn unless_alone(
    q: &BoxClip,
    crossings: &[f32],
    alone: fn(q: &BoxClip, t: f32) -> Interval,
) -> Option<Interval> {
    let part = BoxClip::right(q)?;
    Some(match crossings {
        [t] => alone(q, *t),
        _ => part,
    })
}

/// The same crossings, but only one of two at an edge.
pub(super) fn once_at_edges(mut crossings: Vec<f32>) -> Vec<f32> {
    crossings.dedup_by(|t, before| (*t - *before).abs() < NEAR);
    crossings
}

/// Whether two faces at once are crossed at a distance.
pub(super) fn is_edge(q: &BoxClip, t: f32) -> bool {
    let p = q.ray.at(t);
    let is_on = |axis: &usize| {
        [q.min, q.max]
            .iter()
            .any(|corner| (corner[*axis] - p[*axis]).abs() < NEAR)
    };
    (0..3).filter(is_on).count() > 1
}

/// No farther away than by rounding, in metres.
const NEAR: f32 = 1e-5;

//! Choices of a cut as students make them: by the cost of a side, by that of a cut, or by another row of the boxes.

use super::{cuts, sah, sah_of, whole};
use crate::cases::ch11_bvh::{around, center, without_faces};
use crate::upon::changed;
use glam::Vec3;
use raybook::math::aabb::Aabb;
use raybook_workbook::exercises::ch11_bvh::SahSplit;
use raybook_workbook::tree_rows::BoxRow;

/// How a cut is chosen: by which place of a box the rows are sorted, what a side costs, and what a cut does along an axis.
#[derive(Clone, Copy)]
pub(super) struct How {
    pub(super) key: fn(&BoxRow) -> Vec3,
    pub(super) side: Side,
    pub(super) cut: Cut,
}

/// What a side costs.
pub(super) type Side = fn(&SahSplit, &[u32]) -> f32;

/// What a cut along an axis costs, if a side costs as much as it does.
pub(super) type Cut = fn(&SahSplit, Side, usize, &[Vec<u32>; 2]) -> f32;

/// The left side of the cheapest cut, but for what is changed.
pub(super) fn split(q: &SahSplit, change: impl FnOnce(&mut How)) -> Vec<u32> {
    let right = How {
        key: center,
        side: sah_of,
        cut: sum,
    };
    left_of_cheapest(q, changed(right, change))
}

fn left_of_cheapest(q: &SahSplit, How { key, side, cut }: How) -> Vec<u32> {
    let cuts = cuts(&q.boxes, key).into_iter();
    let best = cuts.min_by(|a, b| cut(q, side, a.0, &a.1).total_cmp(&cut(q, side, b.0, &b.1)));
    best.map_or(Vec::new(), |(_, [left, _])| left)
}

/// The cost of the left side and of the right one.
pub(super) fn sum(q: &SahSplit, side: Side, _axis: usize, [left, right]: &[Vec<u32>; 2]) -> f32 {
    side(q, left) + side(q, right)
}

/// The left side of the cut that is cheapest if a side costs something else.
pub(super) fn least(q: &SahSplit, side: Side) -> Vec<u32> {
    split(q, |how| how.side = side)
}

/// The left side of the cut that is cheapest if a cut costs something else.
pub(super) fn cut_with(q: &SahSplit, cut: Cut) -> Vec<u32> {
    split(q, |how| how.cut = cut)
}

/// A side's number of boxes times the area of its box without the faces across an axis.
pub(super) fn fewer_faces<const AXIS: usize>(q: &SahSplit, side: &[u32]) -> f32 {
    let (bounds, count) = whole(q, side);
    without_faces(bounds.size(), AXIS) * count
}

/// The cost of both sides, if the cut is one between two of this number of buckets, which are equally long and hold all centres; else ∞.
pub(super) fn between_buckets<const BUCKETS: usize>(
    q: &SahSplit,
    side: Side,
    axis: usize,
    sides: &[Vec<u32>; 2],
) -> f32 {
    let place = |i: u32| center(&q.boxes[i as usize])[axis];
    let all = Aabb::of(q.boxes.iter().map(center));
    let bucket = |i: &u32| {
        let share = BUCKETS as f32 * (place(*i) - all.min[axis]) / all.size()[axis];
        (share as usize).min(BUCKETS - 1)
    };
    let [left, right] = sides;
    if left.last().map(bucket) == right.first().map(bucket) {
        f32::INFINITY
    } else {
        sum(q, side, axis, sides)
    }
}

/// The left side of the cut with the least cost: of its axis and its two sides, cut by cut.
pub(super) fn cheapest(
    q: &SahSplit,
    mut cost: impl FnMut(usize, &[u32], &[u32]) -> f32,
) -> Vec<u32> {
    let costs = cuts(&q.boxes, center)
        .into_iter()
        .map(|(axis, [left, right])| (cost(axis, &left, &right), left));
    let best = costs.min_by(|a, b| a.0.total_cmp(&b.0));
    best.map_or(Vec::new(), |(_, left)| left)
}

/// The left side of the cheapest cut of `q.boxes` that is found, if along each axis the search ends at the first cut that is no cheaper than all
/// before it.
pub(super) fn first_best(q: &SahSplit) -> Vec<u32> {
    let mut best = (f32::INFINITY, Vec::new());
    let mut ended = None;
    for (axis, [left, right]) in cuts(&q.boxes, center) {
        let cost = sah_of(q, &left) + sah_of(q, &right);
        if ended == Some(axis) {
            continue;
        }
        if cost < best.0 {
            best = (cost, left);
        } else {
            ended = Some(axis);
        }
    }
    best.1
}

/// As many boxes as are on the left of the cheapest cut, of a row that is sorted again along each axis: in the order of the last.
pub(super) fn sorted_again(q: &SahSplit) -> Vec<u32> {
    let mut row: Vec<_> = (0..q.boxes.len() as u32).collect();
    let mut best = (f32::INFINITY, 1);
    for axis in 0..3 {
        let place = |i: &u32| center(&q.boxes[*i as usize])[axis];
        row.sort_by(|a, b| place(a).total_cmp(&place(b)));
        for at in 1..row.len() {
            let (left, right) = row.split_at(at);
            let cost = sah_of(q, left) + sah_of(q, right);
            if cost < best.0 {
                best = (cost, at);
            }
        }
    }
    row.truncate(best.1);
    row
}

/// What one more box of a side would cost, if the side's box were not larger.
pub(super) fn once(q: &SahSplit, side: &[u32]) -> f32 {
    sah(&around(&q.boxes, side), 1.0)
}

/// The axis along which all boxes together are longest.
pub(super) fn longest(q: &SahSplit) -> usize {
    let all: Vec<_> = (0..q.boxes.len() as u32).collect();
    around(&q.boxes, &all).size().max_position()
}

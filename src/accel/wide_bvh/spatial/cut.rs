//! The best plane to cut space by, and the triangles with it.

use super::part::parts;
use super::profile::Profile;
use crate::accel::bvh::build::cost::Cost;
use crate::accel::bvh::build::item::{Bounds, Item};
use crate::shape::mesh::Facet;
use arrayvec::ArrayVec;
use glam::Vec3A;

/// Slices of the same thickness, between which planes are tried.
const SLICES: usize = 16;

/// Of more than twice this number of items, the plane is chosen by about as many, evenly from the list, and then priced by all.
///
/// Nearly all the work of choosing is where thousands of items are. In a hall of planks and ropes, builds take 0.7 of the time, and
/// the tree's price is the same within 1 %.
const SAMPLE: usize = 384;

/// A plane, and what is on its sides.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut {
    axis: usize,
    at: f32,
    /// The boxes around what is below and above.
    bounds: [Bounds; 2],
    /// How many items are there, those that the plane meets on both sides.
    counts: [usize; 2],
    /// The price of both sides.
    pub(super) price: f32,
}

/// What is in a slice, how many items begin there, and how many end there.
#[derive(Clone, Copy)]
struct Slice {
    bounds: Bounds,
    begin: usize,
    end: usize,
}

impl Slice {
    const EMPTY: Self = Self {
        bounds: Bounds::EMPTY,
        begin: 0,
        end: 0,
    };

    fn add(&mut self, other: &Self) {
        self.bounds = self.bounds.union(&other.bounds);
        self.begin += other.begin;
        self.end += other.end;
    }
}

/// Planes that are equally far from each other, with slices between them; the first and the last plane enclose all.
struct Planes {
    axis: usize,
    min: f32,
    max: f32,
    /// The distance of two planes, in metres, and its reciprocal.
    apart: f32,
    per_metre: f32,
}

impl Planes {
    fn new(axis: usize, all: &Bounds) -> Self {
        let (min, max) = (along(all.min, axis), along(all.max, axis));
        let apart = (max - min) / SLICES as f32;
        Self {
            axis,
            min,
            max,
            apart,
            per_metre: apart.recip(),
        }
    }

    /// Where a plane is along the axis.
    fn at(&self, i: usize) -> f32 {
        self.min + i as f32 * self.apart
    }

    /// The slice in which a place along the axis is. By 32 bits, for a conversion to 64 takes several steps.
    fn slice_of(&self, at: f32) -> usize {
        (((at - self.min) * self.per_metre) as u32 as usize).min(SLICES - 1)
    }

    /// Adds an item to the slices in which it is: to each the box around the part of the triangle there.
    ///
    /// The part between two planes has its corners on them; but the middle corner of the triangle, and its ends, may lie between
    /// them. These boxes are for prices, and may be rounded; those of the tree are made by [`parts`].
    fn add(&self, item: &Item, facets: &[Facet], slices: &mut [Slice; SLICES]) {
        let ends = [item.bounds.min, item.bounds.max].map(|end| along(end, self.axis));
        let [first, last] = ends.map(|end| self.slice_of(end));
        slices[first].begin += 1;
        slices[last].end += 1;
        if first == last {
            slices[first].bounds = slices[first].bounds.union(&item.bounds);
            return;
        }
        let profile = Profile::new(&facets[item.index as usize], self.axis);
        let mut below = profile.at(self.at(first));
        for (i, slice) in (first..).zip(&mut slices[first..=last]) {
            let above = profile.at(self.at(i + 1));
            let part = profile.between(&below, &above);
            slice.bounds = slice.bounds.union(&part.intersection(&item.bounds));
            below = above;
        }
    }

    /// The cheapest of the planes, and its price, if `step` times as many items are in each slice; none where all is flat.
    fn best(&self, slices: &[Slice; SLICES], step: usize, cost: &Cost) -> Option<(f32, f32)> {
        let price =
            |side: &Slice, count: usize| side.bounds.half_area() * cost.shapes(step * count);
        let (mut above, mut side) = ([0.0; SLICES], Slice::EMPTY);
        for i in (1..SLICES).rev() {
            side.add(&slices[i]);
            above[i] = price(&side, side.end);
        }
        side = Slice::EMPTY;
        let planes = (1..SLICES).map(|i| {
            side.add(&slices[i - 1]);
            (self.at(i), price(&side, side.begin) + above[i])
        });
        let planes = planes.filter(|&(at, _)| self.min < at && at < self.max);
        planes.min_by(|a, b| a.1.total_cmp(&b.1))
    }
}

/// A coordinate of a vector: as an array, because glam's own `[axis]` compares `axis` with each axis.
pub(super) fn along(p: Vec3A, axis: usize) -> f32 {
    p.to_array()[axis]
}

impl Cut {
    /// The cheapest cut of all, across axes along which the box of all is at least half as long as along its longest; none
    /// where that box is flat. Cuts across the other axes are seldom cheaper.
    pub(super) fn best(
        items: &[Item],
        all: &Bounds,
        facets: &[Facet],
        cost: &Cost,
    ) -> Option<Self> {
        let size = all.max - all.min;
        let long = |&axis: &usize| along(size, axis) >= 0.5 * size.max_element();
        let planes: ArrayVec<_, 3> = (0..3)
            .filter(long)
            .map(|axis| Planes::new(axis, all))
            .collect();
        let mut slices = [[Slice::EMPTY; SLICES]; 3];
        // Odd, for neighbours in a list are often pairs. Each item once, for all axes: its triangle is somewhere else in memory.
        let step = (items.len() / SAMPLE) | 1;
        for item in items.iter().step_by(step) {
            for (planes, slices) in planes.iter().zip(&mut slices) {
                planes.add(item, facets, slices);
            }
        }
        let best = planes.iter().zip(&slices).filter_map(|(planes, slices)| {
            let (at, price) = planes.best(slices, step, cost)?;
            Some((planes.axis, at, price))
        });
        let (axis, at, _) = best.min_by(|a, b| a.2.total_cmp(&b.2))?;
        Some(Self::new(axis, at, items, facets, cost))
    }

    /// The cut of all items at a plane.
    fn new(axis: usize, at: f32, items: &[Item], facets: &[Facet], cost: &Cost) -> Self {
        let (mut bounds, mut counts) = ([Bounds::EMPTY; 2], [0; 2]);
        let mut add = |side: usize, part: &Bounds| {
            bounds[side] = bounds[side].union(part);
            counts[side] += 1;
        };
        for item in items {
            if along(item.bounds.max, axis) <= at {
                add(0, &item.bounds);
            } else if along(item.bounds.min, axis) >= at {
                add(1, &item.bounds);
            } else {
                let profile = Profile::new(&facets[item.index as usize], axis);
                let [start, met, end] =
                    [f32::NEG_INFINITY, at, f32::INFINITY].map(|x| profile.at(x));
                add(0, &profile.between(&start, &met).intersection(&item.bounds));
                add(1, &profile.between(&met, &end).intersection(&item.bounds));
            }
        }
        let price = |side: usize| bounds[side].half_area() * cost.shapes(counts[side]);
        Self {
            axis,
            at,
            price: price(0) + price(1),
            bounds,
            counts,
        }
    }

    /// Puts the first `n` items of `room` in the order of the sides, the left one first. The parts of an item that is cut are
    /// one on each side, as long as there is room for another item. Returns the number of items on the left, and of all.
    pub(super) fn apply(mut self, room: &mut [Item], n: usize, facets: &[Facet]) -> (usize, usize) {
        let (mut left, mut right, mut all) = (0, n, n);
        while left < right {
            let item = room[left];
            let side = match self.place(&item, facets, all < room.len()) {
                Place::Beside(side) => side,
                Place::Whole(side) => {
                    self.take_whole(&item, side);
                    side
                }
                Place::Both(parts) => {
                    let [below, above] = parts.map(|bounds| Item { bounds, ..item });
                    (room[left], room[all]) = (below, above);
                    all += 1;
                    0
                }
            };
            if side == 0 {
                left += 1;
            } else {
                right -= 1;
                room.swap(left, right);
            }
        }
        (left, all)
    }

    /// Where an item goes.
    fn place(&self, item: &Item, facets: &[Facet], may_be_cut: bool) -> Place {
        if along(item.bounds.max, self.axis) <= self.at {
            return Place::Beside(0);
        }
        if along(item.bounds.min, self.axis) >= self.at {
            return Place::Beside(1);
        }
        let parts = parts(item, &facets[item.index as usize], self.axis, self.at);
        match parts.map(|part| part.is_empty()) {
            [false, false] => {}
            [is_above, _] => return Place::Whole(usize::from(is_above)),
        }
        let whole = [0, 1].map(|side| {
            let mut other = *self;
            other.take_whole(item, side);
            other.price_one_by_one()
        });
        let side = usize::from(whole[1] < whole[0]);
        if may_be_cut && self.price_one_by_one() < whole[side] {
            Place::Both(parts)
        } else {
            Place::Whole(side)
        }
    }

    /// An item that was to be on both sides is on one, and whole.
    fn take_whole(&mut self, item: &Item, side: usize) {
        self.bounds[side] = self.bounds[side].union(&item.bounds);
        self.counts[1 - side] = self.counts[1 - side].saturating_sub(1);
    }

    /// The price of both sides if triangles were tested one by one: so one less is always cheaper.
    fn price_one_by_one(&self) -> f32 {
        let of = |side: usize| self.bounds[side].half_area() * self.counts[side] as f32;
        of(0) + of(1)
    }
}

/// Where an item goes: to the side on which all of it is; whole to one side, for then it is in one leaf only; or cut, to both.
enum Place {
    Beside(usize),
    Whole(usize),
    Both([Bounds; 2]),
}

//! The best plane to cut space by, and the triangles with it.

use super::part::parts;
use crate::accel::bvh::build::cost::Cost;
use crate::accel::bvh::build::item::{Bounds, Item};
use crate::shape::mesh::Facet;
use glam::Vec3A;

/// Slices of the same thickness, between which planes are tried.
const SLICES: usize = 16;

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

/// Planes that are equally far from each other, with slices between them; the first and the last plane enclose all.
struct Planes {
    axis: usize,
    min: f32,
    /// The distance of two planes, in metres, and its reciprocal.
    apart: f32,
    per_metre: f32,
}

impl Planes {
    fn new(axis: usize, all: &Bounds) -> Self {
        let (min, max) = (all.min[axis], all.max[axis]);
        let apart = (max - min) / SLICES as f32;
        Self {
            axis,
            min,
            apart,
            per_metre: apart.recip(),
        }
    }

    /// Where a plane is along the axis.
    fn at(&self, i: usize) -> f32 {
        self.min + i as f32 * self.apart
    }

    /// How many planes are at or below a place along the axis: 0 is below all slices. By 32 bits, for a conversion to 64 takes
    /// several steps.
    fn planes_below(&self, at: f32) -> usize {
        ((at - self.min) * self.per_metre + 1.0) as u32 as usize
    }

    /// The slice in which a place along the axis is.
    fn slice_of(&self, at: f32) -> usize {
        (((at - self.min) * self.per_metre) as u32 as usize).min(SLICES - 1)
    }

    /// Adds an item to the slices in which it is: to each the box around the part of the triangle there.
    ///
    /// The part between two planes has its corners where the planes cut the edges, and where a corner of the triangle lies between
    /// them. So each edge is followed from plane to plane once; `inside` is room for the boxes of the parts. These boxes are for prices, and may be rounded; those of the
    /// tree are made by [`parts`].
    fn add(
        &self,
        item: &Item,
        facet: &Facet,
        slices: &mut [Slice; SLICES],
        inside: &mut [Bounds; SLICES + 2],
    ) {
        let ends = [item.bounds.min, item.bounds.max].map(|end| along(end, self.axis));
        let [first, last] = ends.map(|end| self.slice_of(end));
        slices[first].begin += 1;
        slices[last].end += 1;
        if first == last {
            slices[first].bounds = slices[first].bounds.union(&item.bounds);
            return;
        }
        // Below the first slice, in the slices, and above the last.
        let inside = &mut inside[..last - first + 3];
        inside.fill(Bounds::EMPTY);
        let mut add = |i: usize, p: Vec3A| {
            inside[i] = inside[i].union(&Bounds { min: p, max: p });
        };
        let corners = facet.corners.map(Vec3A::from);
        let places = corners.map(|p| along(p, self.axis));
        let lies_in = places.map(|at| self.planes_below(at).clamp(first, last + 2) - first);
        for (i, p) in lies_in.into_iter().zip(corners) {
            add(i, p);
        }
        for (p, q) in [(0, 1), (1, 2), (2, 0)] {
            let (p, q) = if lies_in[p] < lies_in[q] {
                (p, q)
            } else {
                (q, p)
            };
            let per_metre = (corners[q] - corners[p]) / (places[q] - places[p]);
            for i in lies_in[p]..lies_in[q] {
                let met = corners[p] + (self.at(first + i) - places[p]) * per_metre;
                add(i, met);
                add(i + 1, met);
            }
        }
        for (slice, part) in slices[first..=last].iter_mut().zip(&inside[1..]) {
            slice.bounds = slice.bounds.union(&part.intersection(&item.bounds));
        }
    }
}

/// A coordinate of a vector: as an array, because glam's own `[axis]` compares `axis` with each axis.
fn along(p: Vec3A, axis: usize) -> f32 {
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
        let axes = (0..3).filter(|&axis| along(size, axis) >= 0.5 * size.max_element());
        let cuts = axes.filter_map(|axis| Self::across(axis, items, all, facets, cost));
        cuts.min_by(|a, b| a.price.total_cmp(&b.price))
    }

    /// The cheapest cut across an axis.
    fn across(
        axis: usize,
        items: &[Item],
        all: &Bounds,
        facets: &[Facet],
        cost: &Cost,
    ) -> Option<Self> {
        let planes = Planes::new(axis, all);
        let empty = Slice {
            bounds: Bounds::EMPTY,
            begin: 0,
            end: 0,
        };
        let mut slices = [empty; SLICES];
        let mut inside = [Bounds::EMPTY; SLICES + 2];
        for item in items {
            let facet = &facets[item.index as usize];
            planes.add(item, facet, &mut slices, &mut inside);
        }
        let mut above = [(Bounds::EMPTY, 0); SLICES];
        for i in (1..SLICES).rev() {
            let (bounds, count) = above.get(i + 1).copied().unwrap_or((Bounds::EMPTY, 0));
            above[i] = (bounds.union(&slices[i].bounds), count + slices[i].end);
        }
        let (mut below, mut count) = (Bounds::EMPTY, 0);
        let cuts = (1..SLICES).map(|i| {
            below = below.union(&slices[i - 1].bounds);
            count += slices[i - 1].begin;
            let (bounds, counts) = ([below, above[i].0], [count, above[i].1]);
            let price = |side: usize| bounds[side].half_area() * cost.shapes(counts[side]);
            Self {
                axis,
                at: planes.at(i),
                bounds,
                counts,
                price: price(0) + price(1),
            }
        });
        let cuts = cuts.filter(|cut| planes.min < cut.at && cut.at < all.max[axis]);
        cuts.min_by(|a, b| a.price.total_cmp(&b.price))
    }

    /// The items of either side; none if one of the sides would have none. At most `spare` items are cut.
    pub(super) fn sides(
        mut self,
        items: &[Item],
        facets: &[Facet],
        mut spare: usize,
    ) -> Option<[Vec<Item>; 2]> {
        let mut sides = self.counts.map(Vec::with_capacity);
        for item in items {
            match self.place(item, &facets[item.index as usize], spare) {
                Place::Beside(side) => sides[side].push(*item),
                Place::Whole(side) => {
                    self.take_whole(item, side);
                    sides[side].push(*item);
                }
                Place::Both(parts) => {
                    spare -= 1;
                    for (side, bounds) in sides.iter_mut().zip(parts) {
                        side.push(Item { bounds, ..*item });
                    }
                }
            }
        }
        sides.iter().all(|side| !side.is_empty()).then_some(sides)
    }

    /// Where an item goes.
    fn place(&self, item: &Item, facet: &Facet, spare: usize) -> Place {
        if item.bounds.max[self.axis] <= self.at {
            return Place::Beside(0);
        }
        if item.bounds.min[self.axis] >= self.at {
            return Place::Beside(1);
        }
        let parts = parts(item, facet, self.axis, self.at);
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
        if spare == 0 || whole[side] <= self.price_one_by_one() {
            Place::Whole(side)
        } else {
            Place::Both(parts)
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

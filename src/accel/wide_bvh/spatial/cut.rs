//! The best plane to cut space by, and the triangles with it.

use super::part::parts;
use crate::accel::bvh::build::cost::Cost;
use crate::accel::bvh::build::item::{Bounds, Extent, Item};
use crate::shape::mesh::Facet;

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

impl Cut {
    /// The cheapest cut of all along the three axes; none where the box of all is flat.
    pub(super) fn best(
        items: &[Item],
        extent: &Extent,
        facets: &[Facet],
        cost: &Cost,
    ) -> Option<Self> {
        let cuts = (0..3).filter_map(|axis| Self::along(axis, items, &extent.bounds, facets, cost));
        cuts.min_by(|a, b| a.price.total_cmp(&b.price))
    }

    /// The cheapest cut along an axis.
    fn along(
        axis: usize,
        items: &[Item],
        all: &Bounds,
        facets: &[Facet],
        cost: &Cost,
    ) -> Option<Self> {
        let (min, max) = (all.min[axis], all.max[axis]);
        let thickness = (max - min) / SLICES as f32;
        let plane = |i: usize| min + i as f32 * thickness;
        let slice_of = |at: f32| (((at - min) / thickness) as usize).min(SLICES - 1);
        let empty = Slice {
            bounds: Bounds::EMPTY,
            begin: 0,
            end: 0,
        };
        let mut slices = [empty; SLICES];
        for item in items {
            let (first, last) = (
                slice_of(item.bounds.min[axis]),
                slice_of(item.bounds.max[axis]),
            );
            slices[first].begin += 1;
            slices[last].end += 1;
            let mut rest = *item;
            for (slice, i) in slices[first..last].iter_mut().zip(first + 1..) {
                let facet = &facets[item.index as usize];
                let [below, above] = parts(&rest, facet, axis, plane(i));
                slice.bounds = slice.bounds.union(&below);
                rest.bounds = above;
            }
            slices[last].bounds = slices[last].bounds.union(&rest.bounds);
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
                at: plane(i),
                bounds,
                counts,
                price: price(0) + price(1),
            }
        });
        let cuts = cuts.filter(|cut| min < cut.at && cut.at < max);
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

//! The best plane to cut space by, and the triangles with it.

use super::part::parts;
use crate::accel::bvh::build::cost::Cost;
use crate::accel::bvh::build::item::{Bounds, Extent, Item};
use crate::shape::mesh::Facet;

/// Planes are tried between so many slices of the same thickness.
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
        let cuts = (0..3).flat_map(|axis| Self::along(axis, items, &extent.bounds, facets, cost));
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
            for i in first..last {
                let facet = &facets[item.index as usize];
                let [below, above] = parts(&rest, facet, axis, plane(i + 1));
                slices[i].bounds = slices[i].bounds.union(&below);
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

    /// The items of either side; none if one of the sides would have none.
    ///
    /// An item that the plane meets is cut, and in both; or stays whole, on one side, where that is cheaper or nothing is spare.
    pub(super) fn sides(
        mut self,
        items: &[Item],
        facets: &[Facet],
        mut spare: usize,
    ) -> Option<[Vec<Item>; 2]> {
        let mut sides = self.counts.map(Vec::with_capacity);
        for item in items {
            let Bounds { min, max } = item.bounds;
            if max[self.axis] <= self.at {
                sides[0].push(*item);
                continue;
            }
            if min[self.axis] >= self.at {
                sides[1].push(*item);
                continue;
            }
            let parts = parts(item, &facets[item.index as usize], self.axis, self.at);
            let whole = [0, 1].map(|side| self.bounds[side].union(&item.bounds));
            let price = |bounds: [&Bounds; 2], counts: [usize; 2]| {
                let of = |side: usize| bounds[side].half_area() * counts[side] as f32;
                of(0) + of(1)
            };
            let [below, above] = &self.bounds;
            let [a, b] = self.counts;
            let in_both = if spare > 0 {
                price([below, above], [a, b])
            } else {
                f32::INFINITY
            };
            let in_below = price([&whole[0], above], [a, b.saturating_sub(1)]);
            let in_above = price([below, &whole[1]], [a.saturating_sub(1), b]);
            if parts[0].is_empty() || parts[1].is_empty() || in_below.min(in_above) <= in_both {
                let side = usize::from(
                    parts[0].is_empty() || (!parts[1].is_empty() && in_above < in_below),
                );
                self.bounds[side] = whole[side];
                self.counts[1 - side] = self.counts[1 - side].saturating_sub(1);
                sides[side].push(*item);
            } else {
                spare -= 1;
                for (side, bounds) in sides.iter_mut().zip(parts) {
                    side.push(Item { bounds, ..*item });
                }
            }
        }
        sides.iter().all(|side| !side.is_empty()).then_some(sides)
    }
}

//! The best split between a few bins: nearly as good as the best of all, and much faster.

use crate::accel::bvh::build::cost::Cost;
use crate::accel::bvh::build::halves::partition;
use crate::accel::bvh::build::item::{Bounds, Item, centers2};
use glam::Vec3A;

/// Bins per axis.
const BINS: usize = 32;

/// The boxes of the items whose centres fall into a slice of the box of all centres, together, and how many these are.
#[derive(Clone, Copy)]
struct Bin {
    bounds: Bounds,
    count: u32,
}

impl Bin {
    const EMPTY: Self = Self {
        bounds: Bounds::EMPTY,
        count: 0,
    };

    fn union(&self, other: &Self) -> Self {
        Self {
            bounds: self.bounds.union(&other.bounds),
            count: self.count + other.count,
        }
    }

    fn cost(&self, cost: &Cost) -> f32 {
        if self.count == 0 {
            0.0
        } else {
            self.bounds.half_area() * cost.shapes(self.count as usize)
        }
    }
}

/// Which bin a centre falls into, along each axis: (c − min)·scale, rounded down.
struct Slices {
    min: Vec3A,
    scale: Vec3A,
}

impl Slices {
    fn of(items: &[Item]) -> Self {
        let centers2 = centers2(items);
        let size = centers2.max - centers2.min;
        Self {
            min: centers2.min,
            // Just below BINS: the largest centre must not fall behind the last bin.
            scale: Vec3A::splat(BINS as f32 * (1.0 - 1e-6))
                / size.max(Vec3A::splat(f32::MIN_POSITIVE)),
        }
    }

    fn of_item(&self, item: &Item) -> [usize; 3] {
        let at = (item.center2() - self.min) * self.scale;
        at.to_array().map(|at| (at as usize).min(BINS - 1))
    }
}

/// Splits the items between two bins, where the surface-area heuristic is least, if that is better than a leaf (Wald 2007).
pub fn split(items: &mut [Item], bounds: &Bounds, cost: &Cost) -> Option<usize> {
    let slices = Slices::of(items);
    let mut bins = [[Bin::EMPTY; BINS]; 3];
    for item in items.iter() {
        for (bins, at) in bins.iter_mut().zip(slices.of_item(item)) {
            bins[at].bounds = bins[at].bounds.union(&item.bounds);
            bins[at].count += 1;
        }
    }
    let (axis, before, total) = best_cut(&bins, cost);
    let parent = bounds.half_area();
    if cost.branch * parent + total >= cost.shapes(items.len()) * parent {
        return None;
    }
    Some(partition(items, |item| slices.of_item(item)[axis] < before))
}

/// The axis, the first bin on the right, and the cost of the best cut.
fn best_cut(bins: &[[Bin; BINS]; 3], cost: &Cost) -> (usize, usize, f32) {
    let mut best = (0, 0, f32::INFINITY);
    for (axis, bins) in bins.iter().enumerate() {
        let mut right = [0.0; BINS];
        let mut all = Bin::EMPTY;
        for i in (1..BINS).rev() {
            all = all.union(&bins[i]);
            right[i] = all.cost(cost);
        }
        all = Bin::EMPTY;
        for i in 1..BINS {
            all = all.union(&bins[i - 1]);
            let total = all.cost(cost) + right[i];
            if total < best.2 {
                best = (axis, i, total);
            }
        }
    }
    best
}

//! The best split between a few bins: nearly as good as the best of all splits, and found much faster.

use crate::accel::bvh::build::cost::Cost;
use crate::accel::bvh::build::halves::partition;
use crate::accel::bvh::build::item::{Bounds, Extent, Item};

/// From `MANY` items on, all three axes are tried, with 16 bins each. Below, only the widest axis is tried, with 8 bins.
const MANY: usize = 64;

/// Splits the items between two bins, where the cost by the surface-area heuristic is least; `None` if a leaf costs no more
/// (Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007).
pub(super) fn split(items: &mut [Item], extent: &Extent, cost: &Cost) -> Option<usize> {
    let cut = if items.len() < MANY {
        Cut::best_along::<8, 1>([extent.widest()], items, extent, cost)
    } else {
        Cut::best::<16>(items, extent, cost)
    };
    cut.split(items, extent, cost)
}

/// The box of all centres, cut into slices of the same thickness along an axis.
#[derive(Clone, Copy)]
struct Slices {
    axis: usize,
    min: f32,
    scale: f32,
    last: usize,
}

impl Slices {
    fn new(count: usize, axis: usize, centers2: &Bounds) -> Self {
        let (min, max) = (centers2.min[axis], centers2.max[axis]);
        Self {
            axis,
            min,
            // A little less than `count`, so that the greatest centre is in the last slice, not beyond it.
            scale: count as f32 * 0.9999 / (max - min).max(f32::MIN_POSITIVE),
            last: count - 1,
        }
    }

    /// The slice in which the item's centre lies.
    fn of(&self, item: &Item) -> usize {
        let at = (item.center2_along(self.axis) - self.min) * self.scale;
        (at as u32 as usize).min(self.last) // by 32 bits: a conversion to 64 takes several steps
    }
}

/// The items with centres in a slice: a box around them, and how many there are.
#[derive(Clone, Copy)]
struct Bin {
    bounds: Bounds,
    count: usize,
}

impl Bin {
    const EMPTY: Self = Self {
        bounds: Bounds::EMPTY,
        count: 0,
    };

    fn add(&mut self, other: &Self) {
        self.bounds = self.bounds.union(&other.bounds);
        self.count += other.count;
    }

    fn cost(&self, cost: &Cost) -> f32 {
        self.bounds.half_area() * cost.shapes(self.count)
    }
}

/// A cut between two slices.
#[derive(Clone, Copy)]
pub(super) struct Cut {
    slices: Slices,
    /// The first slice on the right.
    before: usize,
    /// The cost of both sides: Σ half surface area · price of the shapes.
    pub(super) cost: f32,
}

impl Cut {
    /// The best cut along any axis, between `BINS` bins.
    pub(super) fn best<const BINS: usize>(items: &[Item], extent: &Extent, cost: &Cost) -> Self {
        Self::best_along::<BINS, 3>([0, 1, 2], items, extent, cost)
    }

    /// Splits the items at this cut, if that costs less than a leaf; returns how many are on the left.
    pub(super) fn split(&self, items: &mut [Item], extent: &Extent, cost: &Cost) -> Option<usize> {
        let parent = extent.bounds.half_area();
        let better = cost.branch * parent + self.cost < cost.shapes(items.len()) * parent;
        better.then(|| self.apply(items))
    }

    /// Splits the items at this cut; returns how many are on the left.
    pub(super) fn apply(&self, items: &mut [Item]) -> usize {
        partition(items, |item| self.slices.of(item) < self.before)
    }

    /// The best cut along one of these axes; of equally good ones, the first.
    fn best_along<const BINS: usize, const AXES: usize>(
        axes: [usize; AXES],
        items: &[Item],
        extent: &Extent,
        cost: &Cost,
    ) -> Self {
        let slices = axes.map(|axis| Slices::new(BINS, axis, &extent.centers2));
        let mut bins = [[Bin::EMPTY; BINS]; AXES];
        // Each item once, for all axes: at the root they are far more than the caches hold.
        for item in items {
            let (bounds, count) = (item.bounds, 1);
            for (slices, bins) in slices.iter().zip(&mut bins) {
                bins[slices.of(item)].add(&Bin { bounds, count });
            }
        }
        let mut best = Self {
            slices: slices[0],
            before: 0,
            cost: f32::INFINITY,
        };
        for (slices, bins) in slices.into_iter().zip(&bins) {
            let mut right = [0.0; BINS];
            let mut side = Bin::EMPTY;
            for i in (1..BINS).rev() {
                side.add(&bins[i]);
                right[i] = side.cost(cost);
            }
            side = Bin::EMPTY;
            for i in 1..BINS {
                side.add(&bins[i - 1]);
                let both = side.cost(cost) + right[i];
                if both < best.cost {
                    best = Self {
                        slices,
                        before: i,
                        cost: both,
                    };
                }
            }
        }
        best
    }
}

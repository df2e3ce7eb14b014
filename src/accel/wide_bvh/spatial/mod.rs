//! Cuts through triangles: a long one is in several leaves, each with a box around its part.

mod cut;
mod part;

use crate::accel::bvh::build::cost::Cost;
use crate::accel::bvh::build::fine;
use crate::accel::bvh::build::flat::Flat;
use crate::accel::bvh::build::halves::halve;
use crate::accel::bvh::build::item::{Bounds, Extent, Item};
use crate::accel::bvh::build::tree::{Inside, MAX_DEPTH, Tree, halvings};
use crate::shape::{Shape, mesh::Facet};
use crate::threads;
use cut::Cut;
use glam::Vec3;

/// Cuts are tried where the boxes of two halves share more than this part of the surface area of the root's box (Stich, Friedrich
/// and Dietrich 2009, their α): few rays meet what is smaller, and there most cuts gain nothing.
const OVERLAP: f32 = 1e-4;

/// Below this number of items, another thread does not pay.
const ALONE: usize = 1 << 12;

/// The boxes of long thin triangles are mostly empty: this many times as large as the triangles, on the whole.
///
/// In meshes of scanned things, and in soups and hair, the factor is 4 to 8; there cuts gain nothing, and in a stadium around
/// a teapot they cost: what is cheap for rays from anywhere is not for those that look at the teapot. In a hall of planks,
/// blinds and ropes it is 250, and rays go three times as fast with cuts.
const EMPTY: f64 = 16.0;

/// Whether cuts will pay.
pub(super) fn pays(facets: &[Facet]) -> bool {
    let sum = |area: fn(&Facet) -> f64| facets.iter().map(area).sum::<f64>();
    let of_box = |facet: &Facet| {
        let size = facet.bounds().size().as_dvec3();
        size.x * size.y + size.y * size.z + size.z * size.x
    };
    let of_triangle = |facet: &Facet| {
        let [a, b, c] = facet.corners.map(Vec3::as_dvec3);
        0.5 * (b - a).cross(c - a).length()
    };
    sum(of_box) > EMPTY * sum(of_triangle)
}

/// Builds a tree over the facets, top-down, whose leaves have at most `spare` places more than there are facets.
///
/// At each branch the items go to either side by their centres; or a plane cuts space in two, and the triangles that it
/// meets are on both sides: whatever is cheaper by the surface-area heuristic (Stich, Friedrich and Dietrich 2009). An item is a
/// triangle's part in a box. The leaves hold whole triangles, so it is of no importance by which of the parts one is found.
pub(super) fn build(facets: &[Facet], cost: &Cost, spare: usize) -> Flat {
    let items = threads::list(facets.len(), |i| Item::new((i, &facets[i].bounds())));
    let most_shared = OVERLAP * Extent::of(&items).bounds.half_area();
    let builder = Builder {
        facets,
        cost,
        most_shared,
    };
    let mut order = Vec::with_capacity(items.len());
    let tree = builder.subtree(items, spare, MAX_DEPTH, &mut order);
    Flat::new(&tree, order)
}

/// What all subtrees share.
struct Builder<'a> {
    facets: &'a [Facet],
    cost: &'a Cost,
    /// Half the surface area, in square metres, that two halves may share before cuts are tried.
    most_shared: f32,
}

impl Builder<'_> {
    /// The subtree over the items, with at most `levels` branches above any leaf; appends the facets of its leaves.
    fn subtree(&self, items: Vec<Item>, spare: usize, levels: u32, order: &mut Vec<u32>) -> Tree {
        let (n, extent) = (items.len(), Extent::of(&items));
        let bounds = extent.bounds;
        let [left, right] = match self.split(items, &extent, spare, levels) {
            Ok(sides) => sides,
            Err(leaf) => {
                order.extend(leaf.iter().map(|item| item.index));
                let inside = Inside::Leaf(n as u32);
                return Tree { bounds, inside };
            }
        };
        let spare = spare - (left.len() + right.len() - n);
        // By the areas of their boxes: small triangles need no cut.
        let need = |side: &[Item]| -> f32 { side.iter().map(|item| item.bounds.half_area()).sum() };
        let (of_left, of_right) = (need(&left), need(&right));
        let for_left = ((spare as f32 * of_left / (of_left + of_right)) as usize).min(spare);
        let left = |order: &mut _| self.subtree(left, for_left, levels - 1, order);
        let right = |order: &mut _| self.subtree(right, spare - for_left, levels - 1, order);
        let children = if n < ALONE {
            [left(order), right(order)]
        } else {
            let mut order_of_right = Vec::new();
            let (left, right) = threads::join(|| left(order), || right(&mut order_of_right));
            order.append(&mut order_of_right);
            [left, right]
        };
        let inside = Inside::Branch(Box::new(children));
        Tree { bounds, inside }
    }

    /// The items of two children; or, as an error, those of a leaf, where that is better.
    fn split(
        &self,
        mut items: Vec<Item>,
        extent: &Extent,
        spare: usize,
        levels: u32,
    ) -> Result<[Vec<Item>; 2], Vec<Item>> {
        let n = items.len();
        let may_stay = n <= self.cost.most as usize;
        if n < 2 {
            return Err(items);
        }
        let stay = (self.cost.shapes(n) - self.cost.branch) * extent.bounds.half_area();
        let (mut at, price) = fine::best(&mut items, extent, self.cost);
        // Each side may then be as large as all.
        let room = spare > 0 && halvings(n) < levels;
        if room && shared_area(&items, at) > self.most_shared {
            let cut = Cut::best(&items, &extent.bounds, self.facets, self.cost);
            let better = |cut: &Cut| cut.price < price && (!may_stay || cut.price < stay);
            if let Some(sides) = cut
                .filter(better)
                .and_then(|cut| cut.sides(&items, self.facets, spare))
            {
                return Ok(sides);
            }
        }
        if may_stay && price >= stay {
            return Err(items);
        }
        let fits = |left: usize| (1..n).contains(&left) && halvings(left.max(n - left)) < levels;
        if !fits(at) {
            at = halve(&mut items, extent);
        }
        let right = items.split_off(at);
        Ok([items, right])
    }
}

/// Half the surface area of what the boxes of two sides share.
fn shared_area(items: &[Item], at: usize) -> f32 {
    let (left, right) = items.split_at(at);
    let [left, right] = [left, right].map(|side| {
        let boxes = side.iter().map(|item| item.bounds);
        boxes.fold(Bounds::EMPTY, |all, bounds| all.union(&bounds))
    });
    left.intersection(&right).half_area()
}

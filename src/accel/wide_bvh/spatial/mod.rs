//! Cuts through triangles: a long one is in several leaves, each with a box around its part.

mod cut;
pub(crate) mod few;
mod part;
mod profile;

use crate::accel::bvh::build::cost::Cost;
use crate::accel::bvh::build::fine;
use crate::accel::bvh::build::flat::Flat;
use crate::accel::bvh::build::halves::halve;
use crate::accel::bvh::build::item::{Bounds, Extent, Item};
use crate::accel::bvh::build::tree::{Inside, MAX_DEPTH, Tree, halvings};
use crate::accel::pages;
use crate::math::aabb::Aabb;
use crate::shape::{Shape, mesh::Facet};
use crate::threads;
use cut::Cut;
use glam::{DVec2, Vec3};

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
    let of_box = |facet: &Facet| {
        let size = facet.bounds().size().as_dvec3();
        size.x * size.y + size.y * size.z + size.z * size.x
    };
    let of_triangle = |facet: &Facet| {
        let [a, b, c] = facet.corners.map(Vec3::as_dvec3);
        0.5 * (b - a).cross(c - a).length()
    };
    let add = |sum, facet| sum + DVec2::new(of_box(facet), of_triangle(facet));
    let areas = facets.iter().fold(DVec2::ZERO, add);
    areas.x > EMPTY * areas.y
}

/// Builds a tree over the facets, top-down, whose leaves have at most `spare` places more than there are facets.
///
/// At each branch the items go to either side by their centres; or a plane cuts space in two, and the triangles that it
/// meets are on both sides: whatever is cheaper by the surface-area heuristic (Stich, Friedrich and Dietrich 2009). An item is a
/// triangle's part in a box. The leaves hold whole triangles, so it is of no importance by which of the parts one is found.
pub(super) fn build(facets: &[Facet], cost: &Cost, spare: usize) -> Flat {
    let n = facets.len();
    let mut room = pages::list(n + spare);
    threads::fill(&mut room, n + spare, |i| match facets.get(i) {
        Some(facet) => Item::new((i, &facet.bounds())),
        None => Item::new((i, &Aabb::EMPTY)),
    });
    let most_shared = OVERLAP * Extent::of(&room[..n]).bounds.half_area();
    let builder = Builder {
        facets,
        cost,
        most_shared,
    };
    let mut order = Vec::with_capacity(n);
    let places = &mut room;
    let tree = builder.subtree(Room { places, n }, MAX_DEPTH, &mut order);
    Flat::new(&tree, order)
}

/// Items, and free places after them for parts of items that are cut.
struct Room<'a> {
    /// The items come first.
    places: &'a mut [Item],
    /// Number of items.
    n: usize,
}

impl Room<'_> {
    fn items(&mut self) -> &mut [Item] {
        &mut self.places[..self.n]
    }

    /// Number of free places.
    fn spare(&self) -> usize {
        self.places.len() - self.n
    }

    /// The room of the first `left` items, with some of the free places, and that of the others with the rest.
    fn divide(self, left: usize, spare: usize) -> [Self; 2] {
        let Self { places, n } = self;
        // Where these free places are to be, items of the right side are: they move to its end.
        let moved = spare.min(n - left);
        places.copy_within(left..left + moved, n + spare - moved);
        let (of_left, of_right) = places.split_at_mut(left + spare);
        let room = |places, n| Self { places, n };
        [room(of_left, left), room(of_right, n - left)]
    }
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
    fn subtree(&self, mut room: Room, levels: u32, order: &mut Vec<u32>) -> Tree {
        let extent = Extent::of(room.items());
        let bounds = extent.bounds;
        let Some(left) = self.split(&mut room, &extent, levels) else {
            order.extend(room.items().iter().map(|item| item.index));
            let inside = Inside::Leaf(room.n as u32);
            return Tree { bounds, inside };
        };
        let for_left = spare_for_left(&mut room, left);
        let n = room.n;
        let [left, right] = room.divide(left, for_left);
        let left = |order: &mut _| self.subtree(left, levels - 1, order);
        let right = |order: &mut _| self.subtree(right, levels - 1, order);
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

    /// Puts the items of the left child first, and returns their number; none if a leaf is better.
    fn split(&self, room: &mut Room, extent: &Extent, levels: u32) -> Option<usize> {
        let n = room.n;
        let may_stay = n <= self.cost.most as usize;
        if n < 2 {
            return None;
        }
        let stay = (self.cost.shapes(n) - self.cost.branch) * extent.bounds.half_area();
        let (mut left, price) = if n <= few::FEW {
            few::best(room.items(), self.cost)
        } else {
            fine::of_many(room.items(), extent, self.cost)
        };
        // Each side may then be as large as all.
        let may_cut = room.spare() > 0 && halvings(n) < levels;
        if may_cut && shared_area(room.items(), left) > self.most_shared {
            let cut = Cut::best(room.items(), &extent.bounds, self.facets, self.cost);
            let better = |cut: &Cut| cut.price < price && (!may_stay || cut.price < stay);
            if let Some(cut) = cut.filter(better) {
                (left, room.n) = cut.apply(room.places, n, self.facets);
                if (1..room.n).contains(&left) {
                    return Some(left);
                }
            }
        }
        if may_stay && price >= stay {
            return None;
        }
        let fits = (1..n).contains(&left) && halvings(left.max(n - left)) < levels;
        if !fits {
            left = halve(room.items(), extent);
        }
        Some(left)
    }
}

/// How many of the free places the left child gets: by the areas of the items' boxes, for small triangles need no cut.
fn spare_for_left(room: &mut Room, left: usize) -> usize {
    let spare = room.spare();
    if spare == 0 {
        return 0;
    }
    let need = |items: &[Item]| -> f32 { items.iter().map(|item| item.bounds.half_area()).sum() };
    let (of_left, of_right) = room.items().split_at(left);
    let (of_left, of_right) = (need(of_left), need(of_right));
    ((spare as f32 * of_left / (of_left + of_right)) as usize).min(spare)
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

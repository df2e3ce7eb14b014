//! The bounding volume hierarchy (BVH): boxes in boxes, and shapes in the smallest boxes.
//!
//! ```
//! use raybook::accel::Tests;
//! use raybook::prelude::*;
//!
//! let facets = raybook::scene::terrain::terrain(32).facets();
//! let all = facets.len();
//! let mut tests = Tests::default();
//! let ray = Ray::new(vec3(0.3, 9.0, 0.4), -Dir3::Y);
//! assert!(Bvh::new(facets).closest_counted(&ray, Interval::AHEAD, &mut tests).is_some());
//! assert!(all == 2048 && tests.boxes + tests.shapes < 60);
//! ```

pub mod build;
pub(crate) mod pair;
pub(crate) mod validate;

use crate::accel::bvh::build::cost::{self, Cost};
use crate::accel::bvh::build::flat::{Flat, Node};
use crate::accel::bvh::build::tree::MAX_DEPTH;
use crate::accel::bvh::build::{Method, build};
use crate::accel::bvh::pair::{Pair, RayPair};
use crate::accel::{Accel, Count, bounded::bounded, list::List, pages};
use crate::math::{interval::Interval, ray::Ray};
use crate::shape::{Hit, Shape};
use crate::threads;
use arrayvec::ArrayVec;

/// A bounding volume hierarchy, a tree of boxes: a ray that misses a box misses everything in the box.
///
/// For each branch that a search opens, two boxes are counted: those of its children.
#[derive(Clone, Debug)]
pub struct Bvh<S> {
    root: Option<Node>,
    pairs: Vec<Pair>,
    /// In the order of the leaves.
    shapes: Vec<S>,
    unbounded: List<S>,
}

/// The prices of this tree's steps: testing a shape takes as long as testing the two boxes of a pair.
pub(crate) const COST: Cost = Cost {
    branch: 1.0,
    block: 1.0,
    block_size: 1,
    most: 8,
};

/// Size of the stack of nodes that wait: one for each branch on the way down, and the root.
const STACK: usize = 1 + MAX_DEPTH as usize;

impl<S: Shape> Bvh<S> {
    /// A tree built by [`Method::Fine`], the best method for its time: the surface-area heuristic with many bins.
    pub fn new(shapes: Vec<S>) -> Self {
        Self::build(shapes, Method::Fine)
    }

    /// A tree built by this method.
    pub fn build(shapes: Vec<S>, method: Method) -> Self {
        Self::with_leaves(shapes, method, COST.most)
    }

    /// A tree whose leaves hold at most `most` shapes each; a `most` of 0 counts as 1. The surface-area heuristic makes smaller
    /// leaves wherever they cost less.
    pub fn with_leaves(shapes: Vec<S>, method: Method, most: u32) -> Self {
        let (shapes, unbounded) = bounded(shapes);
        let boxes = threads::list(shapes.len(), |i| shapes[i].bounds());
        let most = most.max(1);
        let flat = build(&boxes, method, &Cost { most, ..COST });
        Self {
            unbounded,
            ..Self::from_flat(flat, shapes)
        }
    }

    /// The accelerator of a tree that has been built from the boxes of these shapes.
    pub(crate) fn from_flat(flat: Flat, shapes: Vec<S>) -> Self {
        let mut shapes: Vec<_> = shapes.into_iter().map(Some).collect();
        let mut in_order = pages::list(shapes.len());
        in_order.extend(flat.order.iter().filter_map(|&i| shapes[i as usize].take()));
        Self {
            shapes: in_order,
            root: flat.root,
            pairs: pages::packed(flat.pairs),
            unbounded: List::new(Vec::new()),
        }
    }

    /// The root, and the pairs of all other nodes, depth-first.
    pub(crate) fn nodes(&self) -> (Option<&Node>, &[Pair]) {
        (self.root.as_ref(), &self.pairs)
    }

    /// The shapes with finite boxes, in the order of the leaves.
    pub fn shapes(&self) -> &[S] {
        &self.shapes
    }

    /// The expected cost of a search by the surface-area heuristic, in tests: testing a pair of boxes costs 1, and testing a
    /// shape costs 1.
    pub fn sah_cost(&self) -> f32 {
        cost::sah_cost(self.root.as_ref(), &self.pairs, &COST)
    }

    /// Checks the invariants that `accel/bvh/validate.rs` states.
    ///
    /// # Errors
    /// Says which invariant is broken, and where.
    pub fn validate(&self) -> Result<(), String> {
        let boxes: Vec<_> = self.shapes.iter().map(Shape::bounds).collect();
        validate::validate(self.root.as_ref(), &self.pairs, &boxes)
    }

    /// Memory of the tree and of the shapes in it, in bytes.
    pub fn bytes(&self) -> usize {
        size_of::<Self>() + size_of_val(&*self.pairs) + size_of_val(&*self.shapes)
    }
}

impl<S: Shape> Accel<S> for Bvh<S> {
    // ANCHOR: bvh_closest
    /// Descends from the root, always into the nearer node of a pair first.
    ///
    /// The farther node waits on a stack. A hit shortens the interval, and a waiting node that begins beyond the hit is dropped.
    fn closest_counted(
        &self,
        ray: &Ray,
        mut within: Interval,
        count: &mut impl Count,
    ) -> Option<(&S, Hit)> {
        let mut closest = self.unbounded.closest_before(ray, &mut within, count);
        let Some(root) = self.root else {
            return closest;
        };
        let (mut ready, hit_by_ray) = (RayPair::new(ray, within, &root.bounds), S::hit_by(ray));
        let mut waiting = ArrayVec::<_, STACK>::new();
        waiting.push((f32::NEG_INFINITY, root.link));
        'search: while let Some((enters, mut link)) = waiting.pop() {
            if enters >= within.max {
                continue;
            }
            while link.count == 0 {
                let pair = &self.pairs[link.first as usize];
                count.tested_box();
                count.tested_box();
                link = match ready.enters(pair) {
                    [Some(left), Some(right)] if left <= right => {
                        waiting.push((right, pair.links[1]));
                        pair.links[0]
                    }
                    [Some(left), Some(_)] => {
                        waiting.push((left, pair.links[0]));
                        pair.links[1]
                    }
                    [Some(_), None] => pair.links[0],
                    [None, Some(_)] => pair.links[1],
                    [None, None] => continue 'search,
                };
            }
            let leaf = &self.shapes[link.first as usize..][..link.count as usize];
            for shape in leaf {
                count.tested_shape();
                if let Some(hit) = hit_by_ray(shape, within) {
                    within = within.before(hit.t);
                    ready.shorten(hit.t);
                    closest = Some((shape, hit));
                }
            }
        }
        closest
    }
    // ANCHOR_END: bvh_closest

    /// As [`Accel::closest_counted`], but without distances: any hit is enough.
    fn any(&self, ray: &Ray, within: Interval) -> bool {
        let Some(root) = self.root else {
            return self.unbounded.any(ray, within);
        };
        let (ready, blocks) = (RayPair::new(ray, within, &root.bounds), S::blocked_by(ray));
        let mut waiting = ArrayVec::<_, STACK>::new();
        waiting.push(root.link);
        'search: while let Some(mut link) = waiting.pop() {
            while link.count == 0 {
                let pair = &self.pairs[link.first as usize];
                link = match ready.enters(pair) {
                    [Some(_), Some(_)] => {
                        waiting.push(pair.links[1]);
                        pair.links[0]
                    }
                    [Some(_), None] => pair.links[0],
                    [None, Some(_)] => pair.links[1],
                    [None, None] => continue 'search,
                };
            }
            let leaf = &self.shapes[link.first as usize..][..link.count as usize];
            if leaf.iter().any(|shape| blocks(shape, within)) {
                return true;
            }
        }
        self.unbounded.any(ray, within)
    }
}

//! The bounding volume hierarchy: boxes in boxes, and shapes in the smallest.

pub mod build;
pub mod pair;
pub mod validate;

use crate::accel::bvh::build::cost::Cost;
use crate::accel::bvh::build::flat::{Flat, Node};
use crate::accel::bvh::build::tree::MAX_DEPTH;
use crate::accel::bvh::build::{Method, build};
use crate::accel::bvh::pair::{Link, Pair, RayPair, limits};
use crate::accel::{Accel, Count, bounded::bounded, list::List};
use crate::math::{aabb::Aabb, interval::Interval, ray::Ray};
use crate::shape::{Hit, Shape};
use glam::Vec4Swizzles;
use rayon::prelude::*;

/// A tree of boxes. Each holds the boxes below it, so a ray that misses it misses everything below.
///
/// A box counts as tested when a ray is tested against it; the two of a pair are tested together.
#[derive(Clone, Debug)]
pub struct Bvh<S> {
    root: Option<Node>,
    pairs: Vec<Pair>,
    /// As they follow each other in the leaves.
    shapes: Vec<S>,
    unbounded: List<S>,
}

/// Testing a shape costs about as much as testing the two boxes of a pair.
pub const COST: Cost = Cost {
    branch: 1.0,
    block: 1.0,
    block_size: 1,
    most: 8,
};

impl<S: Shape> Bvh<S> {
    /// The tree that is best for its time.
    pub fn new(shapes: Vec<S>) -> Self {
        Self::build(shapes, Method::Binned)
    }

    /// A tree made by a method of choice.
    pub fn build(shapes: Vec<S>, method: Method) -> Self {
        let (shapes, unbounded) = bounded(shapes);
        let boxes: Vec<Aabb> = shapes.par_iter().map(Shape::bounds).collect();
        let Flat { root, pairs, order } = build(&boxes, method, &COST);
        let mut shapes: Vec<_> = shapes.into_iter().map(Some).collect();
        let ordered = order.iter().filter_map(|&i| shapes[i as usize].take());
        Self {
            root,
            pairs,
            shapes: ordered.collect(),
            unbounded,
        }
    }

    /// Checks the invariants of `accel/bvh/validate.rs`.
    ///
    /// # Errors
    /// Says which one is broken, and where.
    pub fn validate(&self) -> Result<(), String> {
        let boxes: Vec<_> = self.shapes.iter().map(Shape::bounds).collect();
        validate::validate(self.root.as_ref(), &self.pairs, &boxes)
    }

    /// Memory in use, in bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.pairs) + size_of_val(&*self.shapes)
    }
}
impl<S: Shape> Accel<S> for Bvh<S> {
    // ANCHOR: bvh_closest
    /// The nearer child is searched first; whatever is hit there shortens the interval for the farther one.
    fn closest_counted(
        &self,
        ray: &Ray,
        mut within: Interval,
        count: &mut impl Count,
    ) -> Option<(&S, Hit)> {
        let mut closest = self.unbounded.closest_counted(ray, within, count);
        if let Some((_, hit)) = closest {
            within = within.before(hit.t);
        }
        let Some(root) = self.root else {
            return closest;
        };
        let ready = RayPair::new(ray);
        let mut limit = limits(within);
        let mut node = Link {
            first: root.first,
            count: root.count,
        };
        let mut stack = [(0.0_f32, node); MAX_DEPTH as usize];
        let mut height = 0;
        loop {
            if node.count == 0 {
                let pair = &self.pairs[node.first as usize];
                count.tested_box();
                count.tested_box();
                let t = ready.enters(pair, limit);
                let hit = t.cmple(-t.zwxy()).bitmask() & 3;
                if hit == 3 {
                    let far = usize::from(t.x <= t.y);
                    node = pair.links[1 - far];
                    stack[height] = (if far == 1 { t.y } else { t.x }, pair.links[far]);
                    height += 1;
                    continue;
                }
                if hit != 0 {
                    node = pair.links[hit as usize - 1];
                    continue;
                }
            } else {
                for shape in &self.shapes[node.first as usize..][..node.count as usize] {
                    count.tested_shape();
                    if let Some(hit) = shape.hit(ray, within) {
                        within = within.before(hit.t);
                        limit = limits(within);
                        closest = Some((shape, hit));
                    }
                }
            }
            loop {
                if height == 0 {
                    return closest;
                }
                height -= 1;
                if stack[height].0 < within.max {
                    node = stack[height].1;
                    break;
                }
            }
        }
    }
    // ANCHOR_END: bvh_closest

    fn any(&self, ray: &Ray, within: Interval) -> bool {
        self.closest(ray, within).is_some()
    }
}

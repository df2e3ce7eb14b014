//! The octree: cells that hold many shapes are cut in eight.
//!
//! ```
//! use raybook::accel::octree::Octree;
//! use raybook::prelude::*;
//!
//! let mesh = raybook::shape::teapot::mesh(2);
//! let (octree, list) = (Octree::of_facets(mesh.facets()), List::new(mesh.facets()));
//! let ray = Ray::new(vec3(0.0, 9.0, 0.1), -Dir3::Y);
//! assert_eq!(octree.closest(&ray, Interval::AHEAD), list.closest(&ray, Interval::AHEAD));
//! ```

pub mod build;
pub mod reach;
pub(crate) mod tree;
mod validate;
pub(crate) mod walk;

use crate::accel::{Accel, Count, bounded::bounded, list::List, order, pages};
use crate::math::{aabb::Aabb, interval::Interval, ray::Ray};
use crate::shape::{Hit, Shape, mesh::Facet};
use build::{Limits, build};
use glam::Vec3;
use tree::Tree;
use walk::Walk;

/// An octree (Meagher 1982; for rays: Glassner 1984).
#[derive(Clone, Debug)]
pub struct Octree<S> {
    tree: Tree,
    /// The shapes, in the order in which the leaves first name them: so neighbours in space are near in memory too.
    shapes: Vec<S>,
    /// The shapes without a box in the domain: every ray tests them.
    unbounded: List<S>,
}

impl<S: Shape> Octree<S> {
    /// An octree of shapes, each in the leaves that its bounding box reaches.
    pub fn new(shapes: Vec<S>) -> Self {
        Self::with(shapes, Limits::USUAL, reach::by_bounds)
    }

    /// An octree with these limits; `reached` returns which of eight cells a shape reaches, one bit each. A depth above
    /// [`Limits::DEEPEST`] counts as that, and copies above [`Limits::MOST_COPIES`], or a NaN, as those.
    pub fn with(shapes: Vec<S>, limits: Limits, reached: impl Fn(&S, &[Aabb; 8]) -> u8) -> Self {
        let (mut shapes, unbounded) = bounded(shapes);
        let limits = Limits {
            depth: limits.depth.min(Limits::DEEPEST),
            copies: limits.copies.min(Limits::MOST_COPIES), // which is not the NaN
            ..limits
        };
        let mut tree = build(
            cube_around(&shapes),
            shapes.len() as u32,
            limits,
            &|i, cells| reached(&shapes[i as usize], cells),
        );
        order::by_first_use(&mut shapes, &mut tree.named);
        let tree = Tree {
            nodes: pages::packed(tree.nodes),
            named: pages::packed(tree.named),
            ..tree
        };
        Self {
            tree,
            shapes: pages::packed(shapes),
            unbounded,
        }
    }

    /// The tree of cells.
    pub(crate) fn tree(&self) -> &Tree {
        &self.tree
    }

    /// The shapes, by the numbers that [`Tree::named`] gives them.
    pub(crate) fn shapes(&self) -> &[S] {
        &self.shapes
    }

    /// Memory of the tree and of the shapes in it, in bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.tree.nodes) + size_of_val(&*self.tree.named) + size_of_val(&*self.shapes)
    }
}

impl Octree<Facet> {
    /// An octree of facets, each only in the leaves that the triangle itself reaches, not in all those that its box reaches.
    pub fn of_facets(facets: Vec<Facet>) -> Self {
        Self::with(facets, Limits::USUAL, reach::by_triangle)
    }
}

impl<S: Shape> Accel<S> for Octree<S> {
    /// The boxes that are counted are the nodes that the ray enters, leaves included.
    fn closest_counted(
        &self,
        ray: &Ray,
        mut within: Interval,
        count: &mut impl Count,
    ) -> Option<(&S, Hit)> {
        let mut closest = self.unbounded.closest_before(ray, &mut within, count);
        let (hit_by_ray, mut walk) = (S::hit_by(ray), Walk::new(&self.tree, ray, within));
        while let Some(leaf) = walk.next_leaf(within.max, count) {
            for &i in self.tree.shapes_in(leaf) {
                let shape = &self.shapes[i as usize];
                count.tested_shape();
                if let Some(hit) = hit_by_ray(shape, within) {
                    within = within.before(hit.t);
                    closest = Some((shape, hit));
                }
            }
        }
        closest
    }

    fn any(&self, ray: &Ray, within: Interval) -> bool {
        let (blocks, mut walk) = (S::blocked_by(ray), Walk::new(&self.tree, ray, within));
        while let Some(leaf) = walk.next_leaf(within.max, &mut ()) {
            let mut shapes = self.tree.shapes_in(leaf).iter();
            if shapes.any(|&i| blocks(&self.shapes[i as usize], within)) {
                return true;
            }
        }
        self.unbounded.any(ray, within)
    }
}

/// Shapes whose common box is thinner than this part of its length are a strip or a sheet.
const THIN: f32 = 1.0 / 64.0;

/// A smallest cube around the shapes: cut in halves along each axis, a cube gives cubes.
///
/// The shapes are in the cube's middle. But along an axis in which they are thin, they begin at the cube's lower face. In the
/// middle, a long strip would lie across two middle planes, and so in four children of every cell: no cut would pay.
fn cube_around<S: Shape>(shapes: &[S]) -> Aabb {
    let all = shapes.iter().map(Shape::bounds).reduce(|a, b| a.union(&b));
    let bounds = all.unwrap_or(Aabb::of([Vec3::ZERO]));
    let size = bounds.size();
    let side = size.max_element();
    let thin = size.cmplt(Vec3::splat(THIN * side));
    let min = Vec3::select(thin, bounds.min, bounds.center() - 0.5 * side);
    let max = Vec3::select(thin, bounds.min + side, bounds.center() + 0.5 * side);
    // The union with the shapes' box, because the centre is rounded.
    bounds.union(&Aabb { min, max })
}

//! Floor 3: which of many shapes a ray hits first.
//!
//! ```
//! use raybook::accel::{Tests, grid::Grid};
//! use raybook::prelude::*;
//!
//! // A row of balls. A list tests all of them; a structure finds the same ball with fewer tests.
//! let balls: Vec<_> = (0..100).map(|i| Sphere::new(vec3(3.0 * i as f32, 0.0, 0.0), 1.0)).collect();
//! let (list, grid) = (List::new(balls.clone()), Grid::new(balls));
//! let ray = Ray::new(vec3(150.0, 5.0, 0.0), -Dir3::Y);
//! let [mut by_list, mut by_grid] = [Tests::default(); 2];
//! let hit = list.closest_counted(&ray, Interval::AHEAD, &mut by_list);
//! assert_eq!(grid.closest_counted(&ray, Interval::AHEAD, &mut by_grid), hit);
//! assert!(by_list.shapes == 100 && by_grid.shapes < 5);
//! ```

mod bounded;
mod budget;
pub mod bvh;
pub mod grid;
pub(crate) mod lattice;
pub mod list;
mod margin;
pub mod octree;
pub(crate) mod order;
pub(crate) mod overlap;
pub(crate) mod pages;
pub(crate) mod ray_box;
pub mod two_level_grid;
pub(crate) mod walk;
pub mod wide_bvh;

use crate::math::{aabb::Aabb, interval::Interval, ray::Ray};
use crate::shape::mesh::{Facet, Mesh};
use crate::shape::{Hit, Shape, Surface};

/// An acceleration structure: many shapes, searched for the one that a ray hits.
pub trait Accel<S: Shape>: Send + Sync {
    /// The nearest shape that the ray hits within the interval, and the hit; `count` counts the work.
    fn closest_counted(
        &self,
        ray: &Ray,
        within: Interval,
        count: &mut impl Count,
    ) -> Option<(&S, Hit)>;

    /// As [`Accel::closest_counted`], without counting.
    fn closest(&self, ray: &Ray, within: Interval) -> Option<(&S, Hit)> {
        self.closest_counted(ray, within, &mut ())
    }

    /// Whether the ray hits any shape within the interval: all that a shadow needs to know.
    fn any(&self, ray: &Ray, within: Interval) -> bool;
}

/// Counts the work of one search.
pub trait Count {
    /// A box (a node, a cell) was tested.
    fn tested_box(&mut self);
    /// A shape was tested.
    fn tested_shape(&mut self);
}

/// Counts nothing, and costs nothing: the compiler removes the calls.
impl Count for () {
    fn tested_box(&mut self) {}
    fn tested_shape(&mut self) {}
}

/// The counts of one search, or of several in a row.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tests {
    /// Boxes (nodes, cells) tested.
    pub boxes: u64,
    /// Shapes tested.
    pub shapes: u64,
}

impl Count for Tests {
    fn tested_box(&mut self) {
        self.boxes += 1;
    }

    fn tested_shape(&mut self) {
        self.shapes += 1;
    }
}

/// A mesh and an accelerator over its facets: together one shape, which can itself be in an accelerator.
#[derive(Clone, Debug)]
pub struct Meshed<A> {
    mesh: Mesh,
    facets: A,
}

impl<A: Accel<Facet>> Meshed<A> {
    /// The mesh as a shape; `build` makes the accelerator out of its facets.
    pub fn new(mesh: Mesh, build: impl FnOnce(Vec<Facet>) -> A) -> Self {
        Self {
            facets: build(mesh.facets()),
            mesh,
        }
    }

    /// The mesh.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// The accelerator over its facets.
    pub fn facets(&self) -> &A {
        &self.facets
    }
}

impl<A: Accel<Facet>> Shape for Meshed<A> {
    fn bounds(&self) -> Aabb {
        self.mesh.bounds()
    }

    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        self.facets.closest(ray, within).map(|(_, hit)| hit)
    }

    fn blocks(&self, ray: &Ray, within: Interval) -> bool {
        self.facets.any(ray, within)
    }

    fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        self.mesh.surface(ray, hit)
    }
}

//! The uniform grid: space cut into equal cells, each with a list of the shapes that reach it.
//!
//! ```
//! use glam::UVec3;
//! use raybook::accel::grid::Grid;
//! use raybook::prelude::*;
//!
//! let ball = |x| Sphere::new(vec3(x, 0.0, 0.0), 0.5);
//! let grid = Grid::with_resolution(vec![ball(0.0), ball(7.0)], UVec3::new(8, 1, 1));
//! assert!(grid.references() < 8); // each ball is in few of the 8 cells
//! let hit = grid.closest(&Ray::new(vec3(-2.0, 0.0, 0.0), Dir3::X), Interval::AHEAD);
//! assert_eq!(hit.map(|(_, hit)| hit.t), Some(1.5));
//! ```

pub(crate) mod build;
pub(crate) mod lists;
mod mailbox;
pub(crate) mod resolution;
mod validate;

use crate::accel::grid::{
    build::Parts,
    lists::Lists,
    resolution::{DENSITY, grid_resolution},
};
use crate::accel::{
    Accel, Count,
    bounded::bounded,
    budget::Budget,
    lattice::Lattice,
    list::List,
    margin::is_too_far,
    walk::{break_if, walk},
};
use crate::math::{interval::Interval, ray::Ray};
use crate::shape::{Hit, Shape, mesh::Facet};
use glam::UVec3;
use std::ops::ControlFlow;

/// A uniform grid (Fujimoto, Tanaka and Iwata, "ARTS: accelerated ray-tracing system", 1986). The boxes that a search counts are
/// the cells that it visits.
#[derive(Clone, Debug)]
pub struct Grid<S> {
    parts: Parts<S>,
    /// The shapes without a box in the domain: every ray tests them.
    unbounded: List<S>,
}

impl<S: Shape> Grid<S> {
    /// A grid with the resolution of [`grid_resolution`]; a shape is in each cell that its bounding box meets.
    pub fn new(shapes: Vec<S>) -> Self {
        Self::built(shapes, None, build::by_bounds)
    }

    /// A grid of `resolution` cells along each axis, at least 1 each; of fewer if cells and references would take more than
    /// 256 MB.
    pub fn with_resolution(shapes: Vec<S>, resolution: UVec3) -> Self {
        Self::built(shapes, Some(resolution), build::by_bounds)
    }

    /// The grid's planes.
    pub(crate) fn lattice(&self) -> &Lattice {
        &self.parts.lattice
    }

    /// The total length of the cells' lists: each shape counts once for each cell that it is in.
    pub fn references(&self) -> usize {
        self.parts.references.len()
    }

    /// Memory of the cells, of their lists and of the shapes in them, in bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.parts.shapes)
            + size_of_val(&*self.parts.starts)
            + size_of_val(&*self.parts.references)
    }

    fn built(
        shapes: Vec<S>,
        resolution: Option<UVec3>,
        cells_of: impl Fn(&Lattice, f32, &S) -> Vec<UVec3>,
    ) -> Self {
        let (shapes, unbounded) = bounded(shapes);
        let budget = match resolution {
            Some(_) => Budget::of_a_wish(shapes.len()),
            None => Budget::of(shapes.len()),
        };
        let resolution =
            |size, count| resolution.unwrap_or_else(|| grid_resolution(size, count, DENSITY));
        Self {
            parts: build::build(shapes, resolution, budget, cells_of),
            unbounded,
        }
    }

    /// Visits the lists of the cells along the ray, each with the distance at which the ray leaves the cell.
    fn visit(
        &self,
        ray: &Ray,
        within: Interval,
        mut visit: impl FnMut(&[u32], f32) -> ControlFlow<()>,
    ) {
        if is_too_far(ray, &self.parts.lattice.bounds(), self.parts.margin) {
            let _ = visit(&self.parts.references, f32::INFINITY);
            return;
        }
        walk(&self.parts.lattice, ray, within, |cell, inside| {
            let i = self.parts.lattice.index(cell);
            let list = self.parts.starts[i] as usize..self.parts.starts[i + 1] as usize;
            visit(&self.parts.references[list], inside.max)
        });
    }
}

impl Grid<Facet> {
    /// A grid with the resolution of [`grid_resolution`]; a facet is only in the cells that the triangle itself meets.
    pub fn of_facets(facets: Vec<Facet>) -> Self {
        Self::built(facets, None, build::by_triangle)
    }

    /// As [`Grid::of_facets`], with `resolution` cells along each axis, and the limits of [`Grid::with_resolution`].
    pub fn of_facets_with_resolution(facets: Vec<Facet>, resolution: UVec3) -> Self {
        Self::built(facets, Some(resolution), build::by_triangle)
    }
}

impl<S: Shape> Accel<S> for Grid<S> {
    fn closest_counted(
        &self,
        ray: &Ray,
        mut within: Interval,
        count: &mut impl Count,
    ) -> Option<(&S, Hit)> {
        let mut closest = self.unbounded.closest_before(ray, &mut within, count);
        let (hit_by_ray, mut lists) = (S::hit_by(ray), Lists::new(&self.parts.shapes));
        self.visit(ray, within, |places, leave| {
            count.tested_box();
            if !places.is_empty()
                && let Some(nearer) = lists.nearest(places, &hit_by_ray, &mut within, count)
            {
                closest = Some(nearer);
            }
            // A hit beyond this cell does not end the walk: a shape of a later cell may be nearer.
            break_if(within.max <= leave)
        });
        closest
    }

    fn any(&self, ray: &Ray, within: Interval) -> bool {
        let mut blocked = self.unbounded.any(ray, within);
        if !blocked {
            let (blocks, mut lists) = (S::blocked_by(ray), Lists::new(&self.parts.shapes));
            self.visit(ray, within, |places, _| {
                blocked = !places.is_empty() && lists.block(places, |shape| blocks(shape, within));
                break_if(blocked)
            });
        }
        blocked
    }
}

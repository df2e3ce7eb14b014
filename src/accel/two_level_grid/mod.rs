//! The two-level grid: a coarse grid, each of whose cells is a grid of its own.
//!
//! ```
//! use raybook::accel::{Tests, grid::Grid, two_level_grid::TwoLevelGrid};
//! use raybook::prelude::*;
//! use raybook::scene::stadium::stadium;
//!
//! // A teapot in a stadium: one cell of the grid holds the whole teapot; a coarse cell is cut again.
//! let facets = stadium(1).mesh.facets();
//! let ray = Ray::new(vec3(0.0, 5.0, 0.01), -Dir3::Y);
//! let [mut one_level, mut two_levels] = [Tests::default(); 2];
//! Grid::of_facets(facets.clone()).closest_counted(&ray, Interval::AHEAD, &mut one_level);
//! TwoLevelGrid::of_facets(facets).closest_counted(&ray, Interval::AHEAD, &mut two_levels);
//! assert!(two_levels.shapes < one_level.shapes);
//! ```

pub mod build;
pub(crate) mod levels;
pub(crate) mod refine;
mod validate;
pub(crate) mod walk;

use crate::accel::grid::{build as grid, lists::Lists};
use crate::accel::{
    Accel, Count, bounded::bounded, budget::Budget, list::List, margin::is_too_far, walk::break_if,
};
use crate::math::{interval::Interval, ray::Ray};
use crate::shape::{Hit, Shape, mesh::Facet};
use build::{Densities, Parts};
use levels::Levels;
use std::ops::ControlFlow;
use walk::walk_two_levels;

/// A two-level grid (Kalojanov, Billeter and Slusallek, "Two-level grids for ray tracing on GPUs", 2011). The boxes that a search
/// counts are the cells that it visits, coarse and fine.
#[derive(Clone, Debug)]
pub struct TwoLevelGrid<S> {
    parts: Parts<S>,
    /// The shapes without a box in the domain: every ray tests them.
    unbounded: List<S>,
}

impl<S: Shape> TwoLevelGrid<S> {
    /// A two-level grid of the usual densities; a shape is in each cell that its bounding box meets.
    pub fn new(shapes: Vec<S>) -> Self {
        let (shapes, unbounded) = bounded(shapes);
        let budget = Budget::of(shapes.len());
        Self {
            parts: build::build(shapes, Densities::USUAL, budget, grid::by_bounds),
            unbounded,
        }
    }

    /// The cells.
    pub(crate) fn levels(&self) -> &Levels {
        &self.parts.levels
    }

    /// The total length of the fine cells' lists: each shape counts once for each fine cell that it is in.
    pub fn references(&self) -> usize {
        self.parts.references.len()
    }

    /// Memory of the cells, of their lists and of the shapes in them, in bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.parts.shapes)
            + size_of_val(&*self.parts.levels.cuts)
            + size_of_val(&*self.parts.starts)
            + size_of_val(&*self.parts.references)
    }

    /// Visits the cells along the ray, coarse cells with `None`, fine cells with their lists, each with the distance at which the
    /// ray leaves the cell.
    fn visit(
        &self,
        ray: &Ray,
        within: Interval,
        mut visit: impl FnMut(Option<&[u32]>, f32) -> ControlFlow<()>,
    ) {
        let Parts {
            levels,
            margin,
            starts,
            references,
            ..
        } = &self.parts;
        if is_too_far(ray, &levels.top.bounds(), *margin) {
            let _ = visit(Some(references), f32::INFINITY);
            return;
        }
        walk_two_levels(levels, ray, within, |place, inside| {
            let list = place.map(|i| &references[starts[i] as usize..starts[i + 1] as usize]);
            visit(list, inside.max)
        });
    }
}

impl TwoLevelGrid<Facet> {
    /// A two-level grid of the usual densities; a facet is only in the cells that the triangle itself meets.
    pub fn of_facets(facets: Vec<Facet>) -> Self {
        let budget = Budget::of(facets.len());
        Self::built(facets, Densities::USUAL, budget)
    }

    /// As [`TwoLevelGrid::of_facets`], with these densities, or lower ones if cells and references would take more than 256 MB.
    pub fn of_facets_with(facets: Vec<Facet>, densities: Densities) -> Self {
        let budget = Budget::of_a_wish(facets.len());
        Self::built(facets, densities, budget)
    }

    fn built(facets: Vec<Facet>, densities: Densities, budget: Budget) -> Self {
        let (facets, unbounded) = bounded(facets);
        Self {
            parts: build::build(facets, densities, budget, grid::by_triangle),
            unbounded,
        }
    }
}

impl<S: Shape> Accel<S> for TwoLevelGrid<S> {
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
            let list = places.unwrap_or_default();
            if !list.is_empty()
                && let Some(nearer) = lists.nearest(list, &hit_by_ray, &mut within, count)
            {
                closest = Some(nearer);
            }
            // A coarse cell is visited before its fine cells, so only the fine cells can end the walk.
            break_if(places.is_some() && within.max <= leave)
        });
        closest
    }

    fn any(&self, ray: &Ray, within: Interval) -> bool {
        let mut blocked = self.unbounded.any(ray, within);
        if !blocked {
            let (blocks, mut lists) = (S::blocked_by(ray), Lists::new(&self.parts.shapes));
            self.visit(ray, within, |places, _| {
                let list = places.unwrap_or_default();
                blocked = !list.is_empty() && lists.block(list, |shape| blocks(shape, within));
                break_if(blocked)
            });
        }
        blocked
    }
}

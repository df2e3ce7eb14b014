//! Sorting shapes into coarse cells, and the shapes of each coarse cell into its fine cells.
//!
//! ```
//! use raybook::accel::two_level_grid::{TwoLevelGrid, build::Densities};
//! use raybook::scene::soup::soup;
//!
//! let facets = soup(500, 1).facets();
//! let coarse = TwoLevelGrid::of_facets_with(facets.clone(), Densities { fine: 0.5, ..Densities::USUAL });
//! let fine = TwoLevelGrid::of_facets_with(facets, Densities { fine: 8.0, ..Densities::USUAL });
//! assert!(fine.references() > coarse.references()); // smaller cells: a facet is in more of them
//! ```

use crate::accel::two_level_grid::{
    levels::Levels,
    refine::{fine_cells, refine_cell},
};
use crate::accel::{
    budget::Budget, grid::resolution::grid_resolution, lattice::Lattice, order, pages,
};
use crate::math::{aabb::Aabb, domain::SMALLEST};
use crate::shape::Shape;
use glam::{UVec3, Vec3};
use std::cell::Cell;

/// The parts of a two-level grid.
#[derive(Clone, Debug)]
pub struct Parts<S> {
    /// The shapes, in the order of the first fine cell that lists them.
    pub shapes: Vec<S>,
    /// The cells.
    pub levels: Levels,
    /// How far a cell looks beyond its planes, in metres.
    pub margin: f32,
    /// Fine cell i of the row holds the references from `starts[i]` to `starts[i + 1]`.
    pub starts: Vec<u32>,
    /// Places in `shapes`.
    pub references: Vec<u32>,
}

/// λ, the number of cells per shape, for both levels. A number below 0 or a NaN gives one cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Densities {
    /// Coarse cells per shape.
    pub coarse: f32,
    /// Fine cells per shape of a coarse cell.
    pub fine: f32,
}

impl Densities {
    /// The coarse density of Kalojanov, Billeter and Slusallek (2011), and the fine density of a uniform grid.
    pub const USUAL: Self = Self {
        coarse: 1.0 / 8.0,
        fine: 5.0,
    };
}

/// Sorts shapes with finite bounds into the cells of both levels; `cells_of` returns the cells of a lattice that a shape
/// reaches, with a margin.
///
/// If the work or the memory exceeds the budget, both densities are lowered until it does not; at last there is a single cell.
pub(crate) fn build<S: Shape>(
    mut shapes: Vec<S>,
    densities: Densities,
    budget: Budget,
    cells_of: impl Fn(&Lattice, f32, &S) -> Vec<UVec3>,
) -> Parts<S> {
    let all = shapes.iter().map(Shape::bounds).reduce(|a, b| a.union(&b));
    let bounds = all.unwrap_or(Aabb::of([Vec3::ZERO]));
    let margin = margin(&bounds);
    let grown = bounds.grown(margin);
    let boxes: Vec<_> = shapes.iter().map(Shape::bounds).collect();
    let cells_of =
        |shape: u32, lattice: &Lattice| cells_of(lattice, margin, &shapes[shape as usize]);
    // No coarse cell is smaller than the margin.
    let most = (bounds.size() / margin).as_uvec3();
    // ∞ could not be lowered.
    let finite = |density: f32| density.clamp(0.0, f32::MAX);
    let mut densities = Densities {
        coarse: finite(densities.coarse),
        fine: finite(densities.fine),
    };
    let (levels, starts, mut references) = loop {
        let resolution = grid_resolution(bounds.size(), shapes.len(), densities.coarse);
        let top = Lattice::new(&grown, resolution.min(most));
        let reach = Reach {
            boxes: &boxes,
            margin,
            cells_of: &cells_of,
        };
        let sorted = sort_in(top, densities.fine, &reach, budget);
        if let Some(sorted) = sorted {
            break sorted;
        }
        densities.coarse /= 8.0;
        densities.fine /= 4.0;
    };
    order::by_first_use(&mut shapes, &mut references);
    Parts {
        shapes: pages::packed(shapes),
        levels,
        margin,
        starts: pages::packed(starts),
        references: pages::packed(references),
    }
}

/// The places of the shapes.
struct Reach<'a, F> {
    boxes: &'a [Aabb],
    margin: f32,
    /// The cells of a lattice that a shape reaches, from the shape's number.
    cells_of: &'a F,
}

/// The cells of both levels, the places where the fine cells' lists begin, and the lists; `None` if they exceed the budget.
fn sort_in(
    top: Lattice,
    density: f32,
    reach: &Reach<'_, impl Fn(u32, &Lattice) -> Vec<UVec3>>,
    mut budget: Budget,
) -> Option<(Levels, Vec<u32>, Vec<u32>)> {
    let Reach {
        boxes,
        margin,
        cells_of,
    } = *reach;
    let in_reach = |allowed: bool| allowed.then_some(());
    in_reach(budget.allows(&top, margin, boxes.iter().copied()))?;
    let mut lists = vec![Vec::new(); top.cells()];
    let mut coarse = budget;
    for shape in 0..boxes.len() as u32 {
        let cells = cells_of(shape, &top);
        in_reach(coarse.take(cells.len()))?;
        for cell in cells {
            lists[top.index(cell)].push(shape);
        }
    }
    // First, all tests are counted against the budget, before any is made.
    for cell in top.all() {
        let shapes = &lists[top.index(cell)];
        let fine = fine_cells(&top.only(cell), shapes.len(), density);
        let boxes = shapes.iter().map(|&shape| boxes[shape as usize]);
        in_reach(budget.allows(&fine, margin, boxes))?;
    }
    in_reach(budget.take(top.cells()))?;
    let left = Cell::new(budget.entries);
    let take = |entries: usize| {
        let enough = entries <= left.get();
        left.set(if enough { left.get() - entries } else { 0 });
        enough
    };
    // Once the budget of references is used up, no more are made.
    let cells_of = |shape: u32, fine: &Lattice| {
        let cells = if left.get() > 0 {
            cells_of(shape, fine)
        } else {
            Vec::new()
        };
        if take(cells.len()) { cells } else { Vec::new() }
    };
    let (mut resolutions, mut starts, mut references) = (Vec::new(), Vec::new(), Vec::new());
    for cell in top.all() {
        let shapes = &lists[top.index(cell)];
        let refined = refine_cell(&top.only(cell), shapes, density, cells_of);
        resolutions.push(refined.resolution);
        let cells = refined.resolution.as_uvec3().element_product();
        in_reach(take(cells as usize) && left.get() > 0)?;
        references.reserve(refined.entries.len());
        let mut entries = refined.entries.iter().peekable();
        for cell in 0..cells {
            starts.push(references.len() as u32);
            while let Some(&(_, shape)) = entries.next_if(|entry| entry.0 == cell) {
                references.push(shape);
            }
        }
    }
    starts.push(references.len() as u32);
    Some((Levels::new(top, resolutions), starts, references))
}

/// How far a cell looks beyond its planes, in metres: 2⁻¹⁵ of the extent, a quarter of a uniform grid's
/// [`margin`](crate::accel::margin::margin), because the cells are smaller, and the same part of the coordinates.
fn margin(bounds: &Aabb) -> f32 {
    let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
    bounds.size().max_element() / 32768.0 + 4.0 * f32::EPSILON * largest + SMALLEST / 32768.0
}

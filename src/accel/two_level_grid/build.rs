//! Sorting shapes into coarse cells, and those of each coarse cell into its fine cells.

use crate::accel::two_level_grid::{levels::Levels, refine::refine_cell};
use crate::accel::{grid::resolution::grid_resolution, lattice::Lattice, order};
use crate::math::aabb::Aabb;
use crate::shape::Shape;
use glam::{UVec3, Vec3};

/// The parts of a two-level grid.
#[derive(Clone, Debug)]
pub struct Parts<S> {
    /// The shapes, in the order of the first fine cell in which they are.
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

/// λ, cells per shape, of both levels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Densities {
    /// Coarse cells per shape.
    pub coarse: f32,
    /// Fine cells per shape of a coarse cell.
    pub fine: f32,
}

impl Densities {
    /// Measured, see the chapter's page.
    pub const USUAL: Self = Self {
        coarse: 1.0 / 8.0,
        fine: 5.0,
    };
}

/// More references or cells than this and than 32 per shape mean shapes that suit no grid.
const MOST: usize = 1 << 24;

/// Sorts shapes with finite bounds; `cells_of` tells which cells of a lattice a shape reaches, with a margin.
///
/// Where shapes are so large that the lists would not fit into memory, there are fewer cells, at last a single one.
pub fn build<S: Shape>(
    mut shapes: Vec<S>,
    mut densities: Densities,
    cells_of: impl Fn(&Lattice, f32, &S) -> Vec<UVec3>,
) -> Parts<S> {
    let all = shapes.iter().map(Shape::bounds).reduce(|a, b| a.union(&b));
    let bounds = all.unwrap_or(Aabb::of([Vec3::ZERO]));
    let margin = margin(&bounds);
    let grown = bounds.grown(margin);
    let cells_of =
        |shape: u32, lattice: &Lattice| cells_of(lattice, margin, &shapes[shape as usize]);
    let (levels, starts, mut references) = loop {
        let resolution = grid_resolution(bounds.size(), shapes.len(), densities.coarse);
        let top = Lattice::new(&grown, resolution);
        let sorted = sort_in(top, shapes.len() as u32, densities.fine, &cells_of);
        if let Some(sorted) = sorted {
            break sorted;
        }
        densities.coarse /= 8.0;
        densities.fine /= 2.0;
    };
    order::by_first_use(&mut shapes, &mut references);
    Parts {
        shapes,
        levels,
        margin,
        starts,
        references,
    }
}

/// The cells, where the lists of the fine ones begin, and the lists; `None` if they would be too long.
fn sort_in(
    top: Lattice,
    count: u32,
    density: f32,
    cells_of: &impl Fn(u32, &Lattice) -> Vec<UVec3>,
) -> Option<(Levels, Vec<u32>, Vec<u32>)> {
    let most = MOST.max(32 * count as usize);
    let mut lists = vec![Vec::new(); top.cells()];
    let mut entries = 0;
    for shape in 0..count {
        for cell in cells_of(shape, &top) {
            lists[top.index(cell)].push(shape);
            entries += 1;
        }
        if entries > most {
            return None;
        }
    }
    let (mut resolutions, mut starts, mut references) = (Vec::new(), Vec::new(), Vec::new());
    for cell in top.all() {
        let shapes = &lists[top.index(cell)];
        let refined = refine_cell(&top.only(cell), shapes, density, cells_of);
        resolutions.push(refined.resolution);
        let cells = refined.resolution.as_uvec3().element_product();
        let mut entries = refined.entries.iter().peekable();
        for cell in 0..cells {
            starts.push(references.len() as u32);
            while let Some(&(_, shape)) = entries.next_if(|entry| entry.0 == cell) {
                references.push(shape);
            }
        }
        if references.len() > most || starts.len() > most {
            return None;
        }
    }
    starts.push(references.len() as u32);
    Some((Levels::new(top, resolutions), starts, references))
}

/// A quarter of the margin of the uniform grid, whose cells are larger: 2⁻¹⁵ of the extent.
fn margin(bounds: &Aabb) -> f32 {
    let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
    bounds.size().max_element() / 32768.0 + 4.0 * f32::EPSILON * largest + f32::MIN_POSITIVE
}

//! Cutting a coarse cell into fine cells, and sorting its shapes into them.

use crate::accel::{grid::resolution::grid_resolution, lattice::Lattice};
use glam::{U8Vec3, UVec3};

/// The fine cells of a coarse cell, and the shapes in them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Refined {
    /// Number of fine cells along each axis; 0 × 0 × 0 for a coarse cell without shapes.
    pub resolution: U8Vec3,
    /// Pairs of a fine cell, by its [`Lattice::index`], and a shape that reaches it, sorted.
    pub entries: Vec<(u32, u32)>,
}

// ANCHOR: refine_cell
/// Cuts `coarse`, a lattice of one cell, into fine cells, and sorts the shapes that reach it into them.
///
/// The rule is that of the uniform grid, with the extents of the coarse cell and the number of its shapes: `density` fine cells
/// per shape (Kalojanov, Billeter and Slusallek 2011). So a crowded cell gets many fine cells, a cell with one shape a few, and
/// an empty cell none; at most 255 along each axis, which fits into a byte. `cells_of` returns the cells of a lattice that a
/// shape reaches.
pub fn refine_cell(
    coarse: &Lattice,
    shapes: &[u32],
    density: f32,
    cells_of: impl Fn(u32, &Lattice) -> Vec<UVec3>,
) -> Refined {
    if shapes.is_empty() {
        return Refined::default();
    }
    let fine = fine_cells(coarse, shapes.len(), density);
    let mut entries = Vec::with_capacity(3 * shapes.len());
    for &shape in shapes {
        let cells = cells_of(shape, &fine).into_iter();
        entries.extend(cells.map(|cell| (fine.index(cell) as u32, shape)));
    }
    entries.sort_unstable();
    Refined {
        resolution: fine.resolution.as_u8vec3(),
        entries,
    }
}
// ANCHOR_END: refine_cell

/// The fine cells of a coarse cell that holds this number of shapes.
pub(super) fn fine_cells(coarse: &Lattice, shapes: usize, density: f32) -> Lattice {
    let bounds = coarse.bounds();
    let resolution = grid_resolution(bounds.size(), shapes, density);
    Lattice::new(&bounds, resolution.min(UVec3::splat(255)))
}

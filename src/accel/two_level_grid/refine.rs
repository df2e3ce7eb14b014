//! How finely a coarse cell is cut, and what lies where in it.

use crate::accel::{grid::resolution::grid_resolution, lattice::Lattice};
use glam::{U8Vec3, UVec3};

/// The fine cells of a coarse cell, and the shapes in them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Refined {
    /// How many fine cells there are along each axis; 0 × 0 × 0 for a cell without shapes.
    pub resolution: U8Vec3,
    /// A fine cell, by its [`Lattice::index`], and a shape that reaches it: sorted.
    pub entries: Vec<(u32, u32)>,
}

// ANCHOR: refine_cell
/// Cuts a coarse cell, a lattice of one cell, for the shapes that reach it, and sorts them in.
///
/// The rule is that of the uniform grid, with the cell's own extents and the number of shapes in it: `density` fine cells per
/// shape (Kalojanov, Billeter and Slusallek 2011). So a crowded cell gets many, a lonely shape a few, and an empty cell none
/// at all; along each axis at most 255, which fit into a byte. `cells_of` tells which cells of a lattice a shape reaches.
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

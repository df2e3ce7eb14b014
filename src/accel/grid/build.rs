//! Which shapes are in which cell.

use crate::accel::lattice::{Lattice, range};
use crate::accel::{budget::Budget, margin::margin, overlap::Separation, pages};
use crate::math::aabb::Aabb;
use crate::shape::{Shape, mesh::Facet};
use glam::{UVec3, Vec3};

/// The parts of a grid.
#[derive(Clone, Debug)]
pub(crate) struct Parts<S> {
    /// The shapes, in the order of the first cell in which they are.
    pub shapes: Vec<S>,
    /// The cells' planes.
    pub lattice: Lattice,
    /// How far a cell looks beyond its planes, in metres.
    pub margin: f32,
    /// Cell i holds the references from `starts[i]` to `starts[i + 1]`.
    pub starts: Vec<u32>,
    /// Places in `shapes`.
    pub references: Vec<u32>,
}

/// Sorts shapes with finite bounds into cells. `resolution` gets the extents of the box of all shapes, in metres, and their
/// number. `cells_of` returns the cells that a shape is in.
///
/// A counting sort: the first pass counts the shapes of each cell, the sums of the counts are where the lists begin, and the
/// second pass writes each shape into its lists. So there are two arrays, and not a separate list for each cell.
///
/// If the work or the memory exceeds the budget, the resolution is halved until it does not.
pub(crate) fn build<S: Shape>(
    shapes: Vec<S>,
    resolution: impl FnOnce(Vec3, usize) -> UVec3,
    budget: Budget,
    cells_of: impl Fn(&Lattice, f32, &S) -> Vec<UVec3>,
) -> Parts<S> {
    let all = shapes.iter().map(Shape::bounds).reduce(|a, b| a.union(&b));
    let bounds = all.unwrap_or(Aabb::of([Vec3::ZERO]));
    let margin = margin(&bounds);
    let grown = bounds.grown(margin);
    // No cell is smaller than the margin.
    let most = (bounds.size() / margin).as_uvec3();
    let mut lattice = Lattice::new(&grown, resolution(bounds.size(), shapes.len()).min(most));
    let lists = loop {
        let mut budget = budget;
        let allowed = budget.allows(&lattice, margin, shapes.iter().map(Shape::bounds));
        let cells_of = |shape: &S| cells_of(&lattice, margin, shape);
        match allowed
            .then(|| lists(&shapes, &lattice, budget, cells_of))
            .flatten()
        {
            Some(lists) => break lists,
            None => lattice = Lattice::new(&grown, lattice.resolution / 2),
        }
    };

    // Neighbours in space become neighbours in memory.
    let mut listed: Vec<_> = lists.into_iter().zip(shapes).collect();
    listed.sort_by_key(|(cells, _)| cells.first().copied());
    let mut starts = vec![0; lattice.cells() + 1];
    for (cells, _) in &listed {
        for &cell in cells {
            starts[cell as usize + 1] += 1;
        }
    }
    for i in 1..starts.len() {
        starts[i] += starts[i - 1];
    }
    let mut next = starts.clone();
    let mut references = vec![0; starts[lattice.cells()] as usize];
    for ((cells, _), place) in listed.iter().zip(0..) {
        for &cell in cells {
            references[next[cell as usize] as usize] = place;
            next[cell as usize] += 1;
        }
    }
    Parts {
        shapes: pages::packed(listed.into_iter().map(|(_, shape)| shape)),
        lattice,
        margin,
        starts: pages::packed(starts),
        references: pages::packed(references),
    }
}

/// The cells of each shape, as places in an array of all cells; `None` if there are too many for the budget.
fn lists<S>(
    shapes: &[S],
    lattice: &Lattice,
    mut budget: Budget,
    cells_of: impl Fn(&S) -> Vec<UVec3>,
) -> Option<Vec<Vec<u32>>> {
    if !budget.take(lattice.cells()) {
        return None;
    }
    let index = |cell| lattice.index(cell) as u32;
    let list = |shape| {
        let cells = cells_of(shape);
        let allowed = budget.take(cells.len());
        // Not collected: `collect` would reuse the memory of the list of cells, which is three times as large.
        let mut list = Vec::with_capacity(cells.len());
        list.extend(cells.into_iter().map(index));
        allowed.then_some(list)
    };
    shapes.iter().map(list).collect()
}

/// The cells that the shape's bounding box reaches.
pub(crate) fn by_bounds<S: Shape>(lattice: &Lattice, margin: f32, shape: &S) -> Vec<UVec3> {
    let (first, last) = lattice.cells_of(&shape.bounds().grown(margin));
    range(first, last).collect()
}

/// The cells that the triangle itself reaches, not only its bounding box.
pub(crate) fn by_triangle(lattice: &Lattice, margin: f32, facet: &Facet) -> Vec<UVec3> {
    voxels_of_triangle(lattice, margin, &facet.corners)
}

// ANCHOR: voxels_of_triangle
/// The cells of the lattice that a triangle reaches: those whose box, grown by `margin` metres on every side, meets the
/// triangle. Cells that the triangle only touches, up to rounding, may be among them.
///
/// The cells of the triangle's bounding box are tested one by one by the separating axes (Akenine-Möller 2001): most of them
/// are off the triangle's plane. The cells are returned in the order of [`range`].
pub fn voxels_of_triangle(lattice: &Lattice, margin: f32, corners: &[Vec3; 3]) -> Vec<UVec3> {
    let (reach, whole) = (Aabb::of(*corners).grown(margin), lattice.bounds());
    if reach.max.cmplt(whole.min).any() || reach.min.cmpgt(whole.max).any() {
        return Vec::new();
    }
    let (first, last) = lattice.cells_of(&reach);
    let separation = Separation::new(corners, 0.5 * lattice.cell + margin);
    let center = |cell: UVec3| lattice.min + (cell.as_vec3() + 0.5) * lattice.cell;
    range(first, last)
        .filter(|&cell| !separation.separates(center(cell)))
        .collect()
}
// ANCHOR_END: voxels_of_triangle

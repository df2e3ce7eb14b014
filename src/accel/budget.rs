//! How much work and memory a grid may take, whatever its shapes are.

use crate::accel::lattice::Lattice;
use crate::math::aabb::Aabb;

/// The limits of one build.
///
/// A grid of ordinary shapes stays far below them: it has 5 cells and 4 to 20 references per shape. Many shapes in the same
/// place, or many that are as long as the scene, would take a cell or a reference for each shape and each cell, that is N².
/// Such a grid is made coarser until it keeps to the limits; at last it is a single cell, which always does.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Budget {
    /// Cells and references together; each takes 4 bytes.
    pub entries: usize,
    /// Pairs of a shape and a cell that are tried.
    pub tries: usize,
}

impl Budget {
    /// For N shapes: at most 400 bytes each, or 92 where they are many, which leaves room for lists that grow while
    /// they are sorted in; and O(N) of time.
    pub(super) fn of(shapes: usize) -> Self {
        Self {
            entries: (100 * shapes).min(23 * shapes + 4096).max(2),
            tries: 256 * shapes,
        }
    }

    /// For a caller who chooses the resolution: 256 MB.
    pub(super) fn of_a_wish(shapes: usize) -> Self {
        let entries = (1 << 26).max(Self::of(shapes).entries);
        let tries = (1 << 28).max(Self::of(shapes).tries);
        Self { entries, tries }
    }

    /// Takes the cells of a lattice and the pairs that shapes with these bounds, grown by a margin, have with them; false if
    /// they are too many.
    pub(super) fn allows(
        &mut self,
        lattice: &Lattice,
        margin: f32,
        shapes: impl IntoIterator<Item = Aabb>,
    ) -> bool {
        if lattice.cells() > self.entries {
            return false;
        }
        shapes.into_iter().all(|bounds| {
            let (first, last) = lattice.cells_of(&bounds.grown(margin));
            take(&mut self.tries, lattice.cells_between(first, last))
        })
    }

    /// Takes this number of entries; false if they are too many.
    pub(super) fn take(&mut self, entries: usize) -> bool {
        take(&mut self.entries, entries)
    }
}

fn take(left: &mut usize, some: usize) -> bool {
    let enough = some <= *left;
    *left = left.saturating_sub(some);
    enough
}

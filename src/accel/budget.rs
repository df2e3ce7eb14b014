//! How much work and memory a grid may take, whatever its shapes are.

use crate::accel::lattice::Lattice;
use crate::math::aabb::Aabb;

/// The limits of one build.
///
/// An ordinary grid usually keeps to them: it has 5 cells and 4 to 20 references per shape. Many shapes in the same place, or
/// many that are as long as the scene, would take a reference for each shape in each cell: O(N²) for N shapes. Such a grid is
/// made coarser until it keeps to the limits. A single cell always does.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Budget {
    /// Cells and references together; each takes 4 bytes.
    pub entries: usize,
    /// Tests of a shape against a cell.
    pub tries: usize,
}

impl Budget {
    /// The limits for a grid of `shapes` shapes whose resolution the library chooses: at most 400 bytes per shape, or about 92
    /// where there are many (the lists take more while they grow), and 256 tests per shape, which is O(N) of time.
    pub(super) fn of(shapes: usize) -> Self {
        Self {
            entries: (100 * shapes).min(23 * shapes + 4096).max(2),
            tries: 256 * shapes,
        }
    }

    /// The limits for a grid whose resolution the caller chooses: 256 MB, or those of [`Budget::of`] if they are higher.
    pub(super) fn of_a_wish(shapes: usize) -> Self {
        let entries = (1 << 26).max(Self::of(shapes).entries);
        let tries = (1 << 28).max(Self::of(shapes).tries);
        Self { entries, tries }
    }

    /// Whether the lattice's cells, and the tests of shapes against them, are within the limits; takes the tests off.
    ///
    /// A shape is tested against each cell that its bounds, grown by the margin, meet.
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

    /// Takes `entries` cells and references off; false if there are not enough left.
    pub(super) fn take(&mut self, entries: usize) -> bool {
        take(&mut self.entries, entries)
    }
}

fn take(left: &mut usize, some: usize) -> bool {
    let enough = some <= *left;
    *left = left.saturating_sub(some);
    enough
}

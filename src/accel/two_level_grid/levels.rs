//! Cells in cells: coarse cells, each with a resolution of its own.

use crate::accel::lattice::Lattice;
use glam::{U8Vec3, UVec3};

/// A coarse lattice, and for each of its cells the resolution of its fine cells.
///
/// The fine cells of all coarse cells are in one row: those of the first coarse cell, then those of the second, and so on.
#[derive(Clone, Debug)]
pub struct Levels {
    /// The coarse cells.
    pub top: Lattice,
    /// The cut of each coarse cell, in the order of [`Lattice::index`].
    pub cuts: Vec<Cut>,
}

/// The cut of one coarse cell into fine cells, in eight bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cut {
    /// The place of the first fine cell in the row of all fine cells.
    pub first: u32,
    /// Number of fine cells along each axis; 0 × 0 × 0 for an empty coarse cell.
    pub resolution: U8Vec3,
}

impl Levels {
    /// Coarse cells with these resolutions, in the order of [`Lattice::index`].
    pub fn new(top: Lattice, resolutions: impl IntoIterator<Item = U8Vec3>) -> Self {
        let mut first = 0;
        let cut = |resolution: U8Vec3| {
            let cut = Cut { first, resolution };
            first += resolution.as_uvec3().element_product();
            cut
        };
        Self {
            top,
            cuts: resolutions.into_iter().map(cut).collect(),
        }
    }

    /// The place of a coarse cell's first fine cell in the row of all, and the lattice of its fine cells; `None` for an empty
    /// coarse cell.
    pub fn fine(&self, coarse: UVec3) -> Option<(usize, Lattice)> {
        let (first, resolution) = self.resolution(coarse)?;
        let cell = self.top.only(coarse);
        Some((first, Lattice::new(&cell.bounds(), resolution)))
    }

    /// As [`Levels::fine`] without the planes: the place, and the number of fine cells along each axis.
    #[inline]
    pub fn resolution(&self, coarse: UVec3) -> Option<(usize, UVec3)> {
        let Cut { first, resolution } = self.cuts[self.top.index(coarse)];
        (resolution.x > 0).then(|| (first as usize, resolution.as_uvec3()))
    }

    /// The lattice of the whole grid if every coarse cell were cut into `resolution` fine cells.
    #[inline]
    pub fn cut(&self, resolution: UVec3) -> Lattice {
        Lattice {
            min: self.top.min,
            cell: self.top.cell / resolution.as_vec3(),
            resolution: self.top.resolution * resolution,
        }
    }

    /// Number of fine cells in all.
    pub fn cells(&self) -> usize {
        let cells = |cut: &Cut| cut.resolution.as_usizevec3().element_product();
        self.cuts.iter().map(cells).sum()
    }
}

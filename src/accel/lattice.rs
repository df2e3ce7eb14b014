//! A box cut into equal cells.

use crate::math::aabb::Aabb;
use glam::{UVec3, Vec3};

/// A box cut into equal cells by planes perpendicular to the axes.
///
/// Plane i of an axis is at minᵢ + i·cellᵢ, for i from 0 to the resolution; cell i lies between the planes i and i + 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lattice {
    /// The least corner of the box.
    pub min: Vec3,
    /// The extent of one cell along each axis, in metres.
    pub cell: Vec3,
    /// Number of cells along each axis; at least 1 each.
    pub resolution: UVec3,
}

impl Lattice {
    /// A box cut into `resolution` cells along each axis, at least 1 each.
    pub fn new(bounds: &Aabb, resolution: UVec3) -> Self {
        let resolution = resolution.max(UVec3::ONE);
        Self {
            min: bounds.min,
            cell: bounds.size() / resolution.as_vec3(),
            resolution,
        }
    }

    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.resolution.as_usizevec3().element_product()
    }

    /// Number of cells from `first` to `last`, both included; no coordinate of `first` is greater than that of `last`.
    pub fn cells_between(&self, first: UVec3, last: UVec3) -> usize {
        (last - first + UVec3::ONE).as_usizevec3().element_product()
    }

    /// The box of all cells.
    #[inline]
    pub fn bounds(&self) -> Aabb {
        self.bounds_of(UVec3::ZERO, self.resolution - UVec3::ONE)
    }

    /// The box of the cells from `first` to `last`, both included.
    #[inline]
    pub fn bounds_of(&self, first: UVec3, last: UVec3) -> Aabb {
        Aabb {
            min: self.min + first.as_vec3() * self.cell,
            max: self.min + (last + UVec3::ONE).as_vec3() * self.cell,
        }
    }

    /// All cells, in the order of their places in an array.
    pub fn all(&self) -> impl Iterator<Item = UVec3> + use<> {
        range(UVec3::ZERO, self.resolution - UVec3::ONE)
    }

    /// One cell, as a lattice.
    #[must_use]
    pub fn only(&self, cell: UVec3) -> Self {
        Self {
            min: self.min + cell.as_vec3() * self.cell,
            resolution: UVec3::ONE,
            ..*self
        }
    }

    /// The cell that holds a point; for a point outside, the nearest cell along each axis.
    ///
    /// A point on a plane between two cells, up to rounding, may be in either cell.
    #[inline]
    pub fn cell_at(&self, p: Vec3) -> UVec3 {
        // The conversion to an integer rounds down, makes 0 of negative numbers and of NaN (0/0: a box without extent),
        // and the largest integer of numbers that are too large.
        ((p - self.min) / self.cell)
            .as_uvec3()
            .min(self.resolution - UVec3::ONE)
    }

    /// The first and the last of the cells that a box meets, along each axis; for a box outside, the nearest cells.
    pub fn cells_of(&self, bounds: &Aabb) -> (UVec3, UVec3) {
        (self.cell_at(bounds.min), self.cell_at(bounds.max))
    }

    /// The place of a cell in an array of all cells: along x first, then y, then z.
    #[inline]
    pub fn index(&self, cell: UVec3) -> usize {
        index(cell, self.resolution)
    }
}

/// The place of a cell in an array of all cells of a resolution: along x first, then y, then z.
#[inline]
pub(crate) fn index(cell: UVec3, resolution: UVec3) -> usize {
    let (cell, along) = (cell.as_usizevec3(), resolution.as_usizevec3());
    cell.x + along.x * (cell.y + along.y * cell.z)
}

/// All cells from `first` to `last`, both included, along x first.
pub fn range(first: UVec3, last: UVec3) -> impl Iterator<Item = UVec3> {
    (first.z..=last.z).flat_map(move |z| {
        (first.y..=last.y).flat_map(move |y| (first.x..=last.x).map(move |x| UVec3::new(x, y, z)))
    })
}

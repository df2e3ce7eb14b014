//! Chapter 8: `grid_resolution`, `voxels_of_triangle`, `grid_walk`.

use crate::exercise::exercises;
use crate::record::row;
use glam::{UVec3, Vec3, uvec3};
use raybook::inside::grid::{self, Lattice, walk};
use raybook::math::{interval::Interval, ray::Ray};
use std::ops::ControlFlow;

exercises! { ($) ch08_grid
    /// Return how many cells a grid has along each axis. There are density times shapes cells in all, each about a cube:
    /// e·∛(cells/volume) cells along an axis of extent e, rounded. An axis that would get less than one cell has 1 and
    /// is left out; the other two then share all cells: e·√(cells/area).
    GridResolution: grid_resolution(
        /// The extents of the box, in metres.
        extents: Vec3,
        /// The number of shapes in it.
        shapes: u32,
        /// The number of cells per shape,
        density: f32 [above 0],
    ) -> (
        /// The number of cells along each axis, 1 or more.
        cells: Cell,
    ) {
        grid::grid_resolution(extents, shapes as usize, density).into()
    }

    /// Return the cells, in any order, whose box, grown by the margin on every side, meets the triangle.
    VoxelsOfTriangle: voxels_of_triangle(
        /// The least corner of the lattice, in metres.
        min: Vec3,
        /// The extents of one cell, in metres.
        cell: Vec3,
        /// The number of cells along x.
        nx: u32,
        /// The number of cells along y.
        ny: u32,
        /// The number of cells along z.
        nz: u32,
        /// How far each cell reaches beyond its planes, in metres.
        margin: f32,
        /// The triangle's first corner, in metres.
        p0: Vec3,
        /// The triangle's second corner, in metres.
        p1: Vec3,
        /// The triangle's third corner, in metres.
        p2: Vec3,
    ) -> (
        /// The cells that the triangle meets, in any order.
        cells: Vec<Cell>,
    ) |q| {
        let cells = grid::voxels_of_triangle(&q.lattice(), q.margin, &[q.p0, q.p1, q.p2]);
        cells.into_iter().map(Cell::from).collect()
    }

    /// List the cells that the ray passes through within the interval, in order, each with the distance at which the
    /// ray leaves it or the interval ends.
    ///
    /// In Rust: call `visit` with each cell and the interval in which the ray is in it, until it breaks off.
    GridWalk: grid_walk(
        /// The least corner of the lattice, in metres.
        min: Vec3,
        /// The extents of one cell, in metres.
        cell: Vec3,
        /// The number of cells along x.
        nx: u32,
        /// The number of cells along y.
        ny: u32,
        /// The number of cells along z.
        nz: u32,
        /// The ray.
        ray: Ray,
        /// The distances that count, in metres.
        within: Interval,
    ) -> (
        /// The cells on the ray's way, in order.
        visits: Vec<Visit>,
    ) |q| {
        let mut visits = Vec::new();
        walk(&q.lattice(), &q.ray, q.within, |cell, inside| {
            let UVec3 { x, y, z } = cell;
            let leave = inside.max;
            visits.push(Visit { x, y, z, leave });
            ControlFlow::Continue(())
        });
        visits
    }
}

row! {
    /// A cell by its numbers along the axes, from 0; or how many there are along each.
    pub struct Cell {
        /// Along x: a cell's number, from 0; or how many cells there are.
        pub x: u32,
        /// Along y: a cell's number, from 0; or how many cells there are.
        pub y: u32,
        /// Along z: a cell's number, from 0; or how many cells there are.
        pub z: u32,
    }
}

impl From<UVec3> for Cell {
    fn from(cell: UVec3) -> Self {
        let UVec3 { x, y, z } = cell;
        Self { x, y, z }
    }
}

impl VoxelsOfTriangle {
    /// The lattice.
    pub fn lattice(&self) -> Lattice {
        lattice(self.min, self.cell, [self.nx, self.ny, self.nz])
    }
}

impl GridWalk {
    /// The lattice.
    pub fn lattice(&self) -> Lattice {
        lattice(self.min, self.cell, [self.nx, self.ny, self.nz])
    }
}

row! {
    /// A cell that a ray passes through.
    pub struct Visit {
        /// The cell's number along x, from 0.
        pub x: u32,
        /// The cell's number along y, from 0.
        pub y: u32,
        /// The cell's number along z, from 0.
        pub z: u32,
        /// The distance at which the ray leaves the cell or the interval ends, in metres.
        pub leave: f32,
    }
}

impl Visit {
    /// The cell.
    pub fn cell(&self) -> UVec3 {
        uvec3(self.x, self.y, self.z)
    }
}

fn lattice(min: Vec3, cell: Vec3, resolution: [u32; 3]) -> Lattice {
    Lattice {
        min,
        cell,
        resolution: UVec3::from(resolution),
    }
}

//! Chapter 8: `grid_resolution`, `voxels_of_triangle`, `grid_walk`.

use raybook::inside::grid::{self, Lattice, walk};
use raybook::math::{interval::Interval, ray::Ray};
use crate::exercise::{Asked, Exercise};
use crate::row::row;
use glam::{UVec3, Vec3, uvec3};
use std::ops::ControlFlow;

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[&GridResolution, &VoxelsOfTriangle, &GridWalk];

row! {
    /// A cell by its numbers along the axes, from 0; or how many there are along each.
    pub struct Cell {
        /// Along x.
        pub x: u32,
        /// Along y.
        pub y: u32,
        /// Along z.
        pub z: u32,
    }
}

impl From<UVec3> for Cell {
    fn from(cell: UVec3) -> Self {
        let UVec3 { x, y, z } = cell;
        Self { x, y, z }
    }
}

/// See [`Exercise::TASK`].
pub struct GridResolution;

row! {
    /// What a grid is made for.
    pub struct GridResolutionQuestion {
        /// The extents of the box, in metres.
        pub extents: Vec3,
        /// How many shapes are in it.
        pub shapes: u32,
        /// How many cells there should be per shape.
        pub density: f32,
    }
}

impl Exercise for GridResolution {
    type Question = GridResolutionQuestion;
    type Answer = Cell;
    const NAME: &'static str = "grid_resolution";
    const ANSWER: &'static str = "cells";
    const TASK: &'static str = "Return how many cells a grid has along each axis: density times shapes in all, each about a cube, and so e·∛(cells/volume) along an axis of extent e, rounded; an axis that would get less than one cell has 1 and is left out of the volume, so that the others share all the cells.";

    fn answer(q: &Self::Question) -> Self::Answer {
        grid::grid_resolution(q.extents, q.shapes as usize, q.density).into()
    }
}

/// See [`Exercise::TASK`].
pub struct VoxelsOfTriangle;

row! {
    /// A lattice, a margin and a triangle.
    pub struct VoxelsOfTriangleQuestion {
        /// The least corner of the lattice.
        pub min: Vec3,
        /// The extents of one cell.
        pub cell: Vec3,
        /// How many cells there are along x.
        pub nx: u32,
        /// How many along y.
        pub ny: u32,
        /// How many along z.
        pub nz: u32,
        /// How far each cell reaches beyond its planes.
        pub margin: f32,
        /// The triangle's first corner.
        pub p0: Vec3,
        /// The second corner.
        pub p1: Vec3,
        /// The third corner.
        pub p2: Vec3,
    }
}

impl VoxelsOfTriangleQuestion {
    /// The lattice.
    pub fn lattice(&self) -> Lattice {
        lattice(self.min, self.cell, [self.nx, self.ny, self.nz])
    }
}

impl Exercise for VoxelsOfTriangle {
    type Question = VoxelsOfTriangleQuestion;
    type Answer = Vec<Cell>;
    const NAME: &'static str = "voxels_of_triangle";
    const ANSWER: &'static str = "cells";
    const TASK: &'static str = "Return the cells, in any order, whose box, grown by the margin on every side, meets the triangle.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let cells = grid::voxels_of_triangle(&q.lattice(), q.margin, &[q.p0, q.p1, q.p2]);
        cells.into_iter().map(Cell::from).collect()
    }
}

/// See [`Exercise::TASK`].
pub struct GridWalk;

row! {
    /// A lattice, a ray, and the distances that count.
    pub struct GridWalkQuestion {
        /// The least corner of the lattice.
        pub min: Vec3,
        /// The extents of one cell.
        pub cell: Vec3,
        /// How many cells there are along x.
        pub nx: u32,
        /// How many along y.
        pub ny: u32,
        /// How many along z.
        pub nz: u32,
        /// The ray.
        pub ray: Ray,
        /// Only what lies between these distances counts.
        pub within: Interval,
    }
}

impl GridWalkQuestion {
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
        /// Along y.
        pub y: u32,
        /// Along z.
        pub z: u32,
        /// The distance at which the ray leaves it, or the interval ends.
        pub leave: f32,
    }
}

impl Visit {
    /// The cell.
    pub fn cell(&self) -> UVec3 {
        uvec3(self.x, self.y, self.z)
    }
}

impl Exercise for GridWalk {
    type Question = GridWalkQuestion;
    type Answer = Vec<Visit>;
    const NAME: &'static str = "grid_walk";
    const ANSWER: &'static str = "visits";
    const TASK: &'static str = "Visit the cells that the ray passes through within the interval, in order, each with the distances at which the ray enters and leaves it, until `visit` breaks off.";

    fn answer(q: &Self::Question) -> Self::Answer {
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

fn lattice(min: Vec3, cell: Vec3, resolution: [u32; 3]) -> Lattice {
    Lattice {
        min,
        cell,
        resolution: UVec3::from(resolution),
    }
}

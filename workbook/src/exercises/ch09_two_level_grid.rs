//! Chapter 9: `refine_cell`, `two_level_walk`.

use crate::exercise::exercises;
use crate::exercises::ch05_box::Corners;
use crate::record::row;
use glam::{U8Vec3, UVec3, Vec3};
use raybook::inside::grid::{Lattice, range};
use raybook::inside::two_level_grid::{self, Levels, walk_two_levels};
use raybook::math::{aabb::Aabb, interval::Interval, ray::Ray};
use std::ops::ControlFlow;

exercises! { ($) ch09_two_level_grid
    /// Cut a coarse cell into fine ones: along each axis as many as grid_resolution gives for its extents, its number
    /// of shapes and the density, but at most 255, and 0 without shapes. Return the resolution, and all pairs of a fine
    /// cell and a shape whose box reaches it, in any order.
    ///
    /// In Rust: `cells_of(shape, &fine)` lists the cells of a lattice that the shape with this number reaches, and
    /// `fine_cells` below makes the lattice of the fine cells. An entry is a cell's `index` in it, and the shape.
    RefineCell: refine_cell(
        /// The coarse cell's least corner, in metres.
        min: Vec3,
        /// The coarse cell's greatest corner, in metres.
        max: Vec3,
        /// The number of fine cells per shape.
        density: f32,
        /// The shapes' boxes; their numbers count from 0.
        shapes: Vec<Corners>,
    ) -> (
        /// The fine cells, and what is in them.
        answer: RefineCellAnswer,
    ) {
        let cell = Aabb { min, max };
        let coarse = Lattice::new(&cell, UVec3::ONE);
        let numbers: Vec<_> = (0..shapes.len() as u32).collect();
        let refined = two_level_grid::refine_cell(&coarse, &numbers, density, |shape, fine| {
            let Corners { min, max } = shapes[shape as usize];
            let (first, last) = fine.cells_of(&Aabb { min, max });
            range(first, last).collect()
        });
        let along = refined.resolution.as_uvec3();
        let entry = |&(cell, shape): &(u32, u32)| Entry {
            x: cell % along.x,
            y: cell / along.x % along.y,
            z: cell / along.x / along.y,
            shape,
        };
        RefineCellAnswer {
            nx: along.x,
            ny: along.y,
            nz: along.z,
            entries: refined.entries.iter().map(entry).collect(),
        }
    }

    /// List the fine cells on the ray's way in order, coarse cell by coarse cell. Each is named by its place in the row
    /// of all fine cells: those of the first coarse cell, then those of the next; in each along x first, then y, then
    /// z.
    ///
    /// In Rust: call `visit` with None for each coarse cell. If the cell is not empty, call `visit` also for each of its
    /// fine cells on the ray's way, with Some of its place. End when `visit` breaks off.
    TwoLevelWalk: two_level_walk(
        /// The ray.
        ray: Ray,
        /// The distances that count, in metres.
        within: Interval,
        /// The grid's least corner, in metres.
        min: Vec3,
        /// The grid's greatest corner, in metres.
        max: Vec3,
        /// The number of coarse cells along each axis.
        coarse: Resolution,
        /// For each coarse cell, along x first, then y, then z: the number of fine cells along each axis; 0 0 0 for
        /// an empty coarse cell.
        fine: Vec<Resolution>,
    ) -> (
        /// The places of the visited fine cells in the row of all fine cells, from 0, in order.
        cell: Vec<u32>,
    ) |q| {
        let mut cells = Vec::new();
        walk_two_levels(&q.levels(), &q.ray, q.within, |place, _| {
            cells.extend(place.map(|place| place as u32));
            ControlFlow::Continue(())
        });
        cells
    }
}

row! {
    /// A fine cell, counted from 0 along each axis, and a shape that reaches it.
    pub struct Entry {
        /// The fine cell's number along x, from 0.
        pub x: u32,
        /// The fine cell's number along y, from 0.
        pub y: u32,
        /// The fine cell's number along z, from 0.
        pub z: u32,
        /// The shape's number, from 0.
        pub shape: u32,
    }
}

row! {
    /// How many fine cells there are along each axis, and what is in them.
    pub struct RefineCellAnswer {
        /// The number of fine cells along x.
        pub nx: u32,
        /// The number of fine cells along y.
        pub ny: u32,
        /// The number of fine cells along z.
        pub nz: u32,
        /// All pairs of a fine cell and a shape that reaches it, in any order.
        pub entries: Vec<Entry>,
    }
}

row! {
    /// How many cells there are along each axis.
    pub struct Resolution {
        /// The number of cells along x.
        pub nx: u32,
        /// The number of cells along y.
        pub ny: u32,
        /// The number of cells along z.
        pub nz: u32,
    }
}

impl TwoLevelWalk {
    /// The cells, as the library stores them; a missing resolution is taken for an empty cell.
    pub fn levels(&self) -> Levels {
        let cells = |r: &Resolution| UVec3::new(r.nx, r.ny, r.nz);
        let bounds = Aabb {
            min: self.min,
            max: self.max,
        };
        let top = Lattice::new(&bounds, cells(&self.coarse));
        let fine = self.fine.iter().map(|r| cells(r).as_u8vec3());
        let fine = fine
            .chain(std::iter::repeat(U8Vec3::ZERO))
            .take(top.cells());
        Levels::new(top, fine)
    }
}

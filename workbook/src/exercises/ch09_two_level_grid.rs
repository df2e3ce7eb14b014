//! Chapter 9: `refine_cell`, `two_level_walk`.

use raybook::accel::lattice::{Lattice, range};
use raybook::accel::two_level_grid::{levels::Levels, refine, walk::walk_two_levels};
use raybook::math::{aabb::Aabb, interval::Interval, ray::Ray};
use crate::exercise::exercises;
use crate::exercises::ch05_box::Corners;
use crate::record::row;
use glam::{U8Vec3, UVec3, Vec3};
use std::ops::ControlFlow;

exercises! { ($) ch09_two_level_grid
    /// Cut a coarse cell with the resolution that grid_resolution gives for its extents, the number of shapes in it and
    /// the density, at most 255 along an axis and 0 × 0 × 0 without shapes, and return it with all pairs of a fine cell
    /// and a shape that reaches it, sorted.
    RefineCell: refine_cell(
        /// The coarse cell's least corner.
        min: Vec3,
        /// Its greatest corner.
        max: Vec3,
        /// How many fine cells there shall be per shape.
        density: f32,
        /// The shapes' boxes.
        shapes: Vec<Corners>,
    ) -> (
        /// Answer.
        answer: RefineCellAnswer,
    ) {
        let cell = Aabb {
            min,
            max,
        };
        let coarse = Lattice::new(&cell, UVec3::ONE);
        let numbers: Vec<_> = (0..shapes.len() as u32).collect();
        let refined = refine::refine_cell(&coarse, &numbers, density, |shape, fine| {
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

    /// Visit the coarse cells on the ray's way, each as None, and after each one that is not empty its fine cells on
    /// the ray's way, as Some of their places in the row of all fine cells, in order, until `visit` breaks off.
    TwoLevelWalk: two_level_walk(
        /// The ray.
        ray: Ray,
        /// Only this stretch of the ray counts.
        within: Interval,
        /// The grid's least corner.
        min: Vec3,
        /// Its greatest corner.
        max: Vec3,
        /// How many coarse cells there are.
        coarse: Resolution,
        /// How many fine cells there are in each coarse one, along x first, then y, then z; 0 0 0 in an empty one.
        fine: Vec<Resolution>,
    ) -> (
        /// Cell.
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
        /// Along x.
        pub x: u32,
        /// Along y.
        pub y: u32,
        /// Along z.
        pub z: u32,
        /// Which shape.
        pub shape: u32,
    }
}

row! {
    /// How many fine cells there are along each axis, and what is in them.
    pub struct RefineCellAnswer {
        /// Along x.
        pub nx: u32,
        /// Along y.
        pub ny: u32,
        /// Along z.
        pub nz: u32,
        /// Which shape is in which cell, in any order.
        pub entries: Vec<Entry>,
    }
}

row! {
    /// How many cells there are along each axis.
    pub struct Resolution {
        /// Along x.
        pub nx: u32,
        /// Along y.
        pub ny: u32,
        /// Along z.
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

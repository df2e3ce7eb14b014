//! Chapter 9: `refine_cell`, `two_level_walk`.

use raybook::inside::grid::{Lattice, range};
use raybook::inside::two_level_grid::{self, Levels, walk_two_levels};
use raybook::math::{aabb::Aabb, interval::Interval, ray::Ray};
use crate::exercise::{Asked, Exercise};
use crate::exercises::ch05_box::Corners;
use crate::row::row;
use glam::{U8Vec3, UVec3, Vec3};
use std::ops::ControlFlow;

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[&RefineCell, &TwoLevelWalk];

/// See [`Exercise::TASK`].
pub struct RefineCell;

row! {
    /// A coarse cell and the boxes of the shapes that reach it.
    pub struct RefineCellQuestion {
        /// The coarse cell's least corner.
        pub min: Vec3,
        /// Its greatest corner.
        pub max: Vec3,
        /// How many fine cells there shall be per shape.
        pub density: f32,
        /// The shapes' boxes.
        pub shapes: Vec<Corners>,
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

impl Exercise for RefineCell {
    type Question = RefineCellQuestion;
    type Answer = RefineCellAnswer;
    const NAME: &'static str = "refine_cell";
    const TASK: &'static str = "Cut a coarse cell with the resolution that grid_resolution gives for its extents, the number of shapes in it and the density, \
        at most 255 along an axis and 0 × 0 × 0 without shapes, and return it with all pairs of a fine cell and a shape that reaches it, sorted.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let cell = Aabb {
            min: q.min,
            max: q.max,
        };
        let coarse = Lattice::new(&cell, UVec3::ONE);
        let shapes: Vec<_> = (0..q.shapes.len() as u32).collect();
        let refined = two_level_grid::refine_cell(&coarse, &shapes, q.density, |shape, fine| {
            let Corners { min, max } = q.shapes[shape as usize];
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
}

/// See [`Exercise::TASK`].
pub struct TwoLevelWalk;

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

row! {
    /// A ray, the distances that count, a coarse grid, and how each of its cells is cut.
    pub struct TwoLevelWalkQuestion {
        /// The ray.
        pub ray: Ray,
        /// Only this stretch of the ray counts.
        pub within: Interval,
        /// The grid's least corner.
        pub min: Vec3,
        /// Its greatest corner.
        pub max: Vec3,
        /// How many coarse cells there are.
        pub coarse: Resolution,
        /// How many fine cells there are in each coarse one, along x first, then y, then z; 0 0 0 in an empty one.
        pub fine: Vec<Resolution>,
    }
}

impl TwoLevelWalkQuestion {
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

impl Exercise for TwoLevelWalk {
    type Question = TwoLevelWalkQuestion;
    type Answer = Vec<u32>;
    const NAME: &'static str = "two_level_walk";
    const ANSWER: &'static str = "cell";
    const TASK: &'static str = "Visit the coarse cells on the ray's way, each as None, and after each one that is not empty its fine cells on the ray's way, \
        as Some of their places in the row of all fine cells, in order, until `visit` breaks off.";

    /// The fine cells; the coarse ones are left out.
    fn answer(q: &Self::Question) -> Self::Answer {
        let mut cells = Vec::new();
        walk_two_levels(&q.levels(), &q.ray, q.within, |place, _| {
            cells.extend(place.map(|place| place as u32));
            ControlFlow::Continue(())
        });
        cells
    }
}

//! A student's own sampling patterns: the library's patterns that are exercises, and how n points are asked of an answer program.

pub mod ask;
pub mod file;
pub mod got;

use crate::patterns::got::Wanted;
use glam::Vec2;
use rand::seq::SliceRandom;
use raybook::inside::Space;
use raybook::math::pcg;
use raybook::sample::pattern::{dart_throwing, poisson_disk, rotated_grid, rows};
use raybook_workbook::exercise::Exercise;
use raybook_workbook::exercises::ch22_antialiasing::{
    Jittered, PoissonDisk, RandomPattern, RegularGrid, RotatedGrid,
};

/// Answers a question with points.
pub type Ask<'a> = &'a mut dyn FnMut(String) -> Vec<Vec2>;

/// A pattern that is an exercise.
pub struct OwnPattern {
    /// The pattern's name.
    pub name: &'static str,
    /// The exercise's name.
    pub exercise: &'static str,
    /// Whether it is another one with each seed.
    pub random: bool,
    /// n points, as the library makes them, but of what the program answers. The questions do not depend on the answers.
    pub points: fn(n: usize, seed: u32, ask: Ask) -> Vec<Vec2>,
}

impl OwnPattern {
    /// How many realisations of it are wanted.
    pub fn realisations(&self, wanted: &Wanted) -> usize {
        if self.random {
            wanted.realisations as usize
        } else {
            1
        }
    }
}

/// All of them.
pub const OWN_PATTERNS: [OwnPattern; 5] = [
    OwnPattern {
        name: "regular-grid",
        exercise: RegularGrid::NAME,
        random: false,
        points: |n, _, ask| rows::in_rows(n, |columns, rows| regular_grid(columns, rows, ask)),
    },
    OwnPattern {
        name: "rotated-grid",
        exercise: RotatedGrid::NAME,
        random: false,
        points: |n, _, ask| rotated_grid::of(n, |spacing, offset| rotated(spacing, offset, ask)),
    },
    OwnPattern {
        name: "random",
        exercise: RandomPattern::NAME,
        random: true,
        points: |n, seed, ask| {
            let n = n as u32;
            ask(line::<RandomPattern>(&RandomPattern { n, seed }))
        },
    },
    OwnPattern {
        name: "jittered",
        exercise: Jittered::NAME,
        random: true,
        points: |n, seed, ask| {
            let mut grids = 0..;
            rows::in_rows(n, |columns, rows| {
                // Every grid of cells has a seed of its own.
                let seed = seed + (grids.next().unwrap_or(0) << 20);
                jittered(columns, rows, seed, ask)
            })
        },
    },
    OwnPattern {
        name: "poisson-disk",
        exercise: PoissonDisk::NAME,
        random: true,
        points: poisson_disk,
    },
];

/// A question as a program reads it.
fn line<E: Exercise>(question: &E) -> String {
    format!("{} {}", E::NAME, question.write())
}

fn regular_grid(columns: usize, rows: usize, ask: Ask) -> Vec<Vec2> {
    ask(line::<RegularGrid>(&RegularGrid {
        x: 0,
        y: 0,
        columns: columns as u32,
        rows: rows as u32,
    }))
}

fn rotated(spacing: f32, offset: Vec2, ask: Ask) -> Vec<Vec2> {
    ask(line::<RotatedGrid>(&RotatedGrid { spacing, offset }))
}

fn jittered(columns: usize, rows: usize, seed: u32, ask: Ask) -> Vec<Vec2> {
    ask(line::<Jittered>(&Jittered {
        columns: columns as u32,
        rows: rows as u32,
        seed,
    }))
}

/// The points for the distance at which about n have room; any that are too many are left out by chance, and darts fill up what is
/// missing. But the answer is returned as it is if it lacks a fifth: then it has gaps, which darts would hide.
fn poisson_disk(n: usize, seed: u32, ask: Ask) -> Vec<Vec2> {
    let mut points = ask(line::<PoissonDisk>(&PoissonDisk {
        distance: poisson_disk::distance_for(n, Space::Square) as f32,
        seed,
    }));
    let Some(first) = points.first() else {
        return points;
    };
    if points.len() < n.saturating_sub(4) * 8 / 10 {
        return points;
    }
    // The same answer makes the same points.
    let rng = &mut pcg::stream(22, first.x.to_bits().into());
    points.shuffle(rng);
    dart_throwing::fill(points, n, Space::Square, rng)
}

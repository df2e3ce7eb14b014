//! Chapter 22: `regular_grid`, `rotated_grid`, `random_pattern`, `jittered`, `poisson_disk`, `pixel_average`.

use raybook::image::rgb::Rgb;
use raybook::math::pcg;
use raybook::sample::filter::{self, Filter};
use raybook::inside::Space;
use raybook::sample::pattern::{jittered, poisson_disk, random_pattern, regular_grid, rotated_grid};
use crate::exercise::{Asked, Exercise};
use crate::row::row;
use glam::{Vec2, vec2};

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[
    &RegularGrid,
    &RotatedGrid,
    &RandomPattern,
    &Jittered,
    &PoissonDisk,
    &PixelAverage,
];

/// See [`Exercise::TASK`].
pub struct RegularGrid;

row! {
    /// A pixel, and into how many cells it is divided.
    pub struct RegularGridQuestion {
        /// The pixel's column in the picture.
        pub x: u32,
        /// The pixel's row in the picture.
        pub y: u32,
        /// How many cells lie side by side.
        pub columns: u32,
        /// How many cells lie one under the other.
        pub rows: u32,
    }
}

impl Exercise for RegularGrid {
    type Question = RegularGridQuestion;
    type Answer = Vec<Vec2>;
    const NAME: &'static str = "regular_grid";
    const ANSWER: &'static str = "point";
    const TASK: &'static str = "Return the middles of columns × rows equal cells of the unit square, in any order; the answer is the list of these points in the pixel of column x and row y, each moved by (x, y).";

    fn answer(q: &Self::Question) -> Self::Answer {
        let points = regular_grid::regular_grid(q.columns as usize, q.rows as usize);
        let moved = |p: Vec2| p + vec2(q.x as f32, q.y as f32);
        points.into_iter().map(moved).collect()
    }
}

/// See [`Exercise::TASK`].
pub struct RotatedGrid;

row! {
    /// A lattice.
    pub struct RotatedGridQuestion {
        /// From a point to its nearest neighbours.
        pub spacing: f32,
        /// Where on the lattice the middle of the square is, in spacings along the lattice.
        pub offset: Vec2,
    }
}

impl Exercise for RotatedGrid {
    type Question = RotatedGridQuestion;
    type Answer = Vec<Vec2>;
    const NAME: &'static str = "rotated_grid";
    const ANSWER: &'static str = "point";
    const TASK: &'static str = "Return all points of a rotated grid in the unit square, in any order: (½, ½) + spacing · (i + offset.x, j + offset.y) rotated by arctan ½ about the origin, in either sense, for all whole numbers i and j; leave out what is not in [0, 1)².";

    fn answer(q: &Self::Question) -> Self::Answer {
        rotated_grid::rotated_grid(q.spacing, q.offset)
    }
}

/// See [`Exercise::TASK`].
pub struct RandomPattern;

row! {
    /// How many points, and from what they follow.
    pub struct RandomPatternQuestion {
        /// How many points.
        pub n: u32,
        /// What the random numbers follow from, if you like.
        pub seed: u32,
    }
}

impl Exercise for RandomPattern {
    type Question = RandomPatternQuestion;
    type Answer = Vec<Vec2>;
    const NAME: &'static str = "random_pattern";
    const ANSWER: &'static str = "point";
    const TASK: &'static str = "Return n random points of the unit square [0, 1)², each anywhere with the same probability and independent of the others; any generator will do.";

    fn answer(q: &Self::Question) -> Self::Answer {
        random_pattern::random_pattern(q.n as usize, &mut pcg::stream(22, q.seed.into()))
    }
}

/// See [`Exercise::TASK`].
pub struct Jittered;

row! {
    /// Into how many cells the pixel is divided, and from what the points follow.
    pub struct JitteredQuestion {
        /// How many cells lie side by side.
        pub columns: u32,
        /// How many cells lie one under the other.
        pub rows: u32,
        /// What the random numbers follow from, if you like.
        pub seed: u32,
    }
}

impl Exercise for Jittered {
    type Question = JitteredQuestion;
    type Answer = Vec<Vec2>;
    const NAME: &'static str = "jittered";
    const ANSWER: &'static str = "point";
    const TASK: &'static str = "Return a random point in each of columns × rows equal cells of the unit square, in any order, each anywhere in its cell with the same probability and independent of the others; any generator will do.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let rng = &mut pcg::stream(22, q.seed.into());
        jittered::jittered(q.columns as usize, q.rows as usize, rng)
    }
}

/// See [`Exercise::TASK`].
pub struct PoissonDisk;

row! {
    /// How far apart the points are to be, and from what they follow.
    pub struct PoissonDiskQuestion {
        /// The least distance between two points.
        pub distance: f32,
        /// What the random numbers follow from, if you like.
        pub seed: u32,
    }
}

impl Exercise for PoissonDisk {
    type Question = PoissonDiskQuestion;
    type Answer = Vec<Vec2>;
    const NAME: &'static str = "poisson_disk";
    const ANSWER: &'static str = "point";
    const TASK: &'static str = "Return random points of the unit square [0, 1)² of which no two are nearer to each other than the distance, so many that hardly another one fits in between; any method and any generator will do, and here the square's edges are just edges.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let rng = &mut pcg::stream(22, q.seed.into());
        poisson_disk::poisson_disk(q.distance, Space::Square, rng)
    }
}

/// See [`Exercise::TASK`].
pub struct PixelAverage;

row! {
    /// What a ray saw, and where.
    pub struct Seen {
        /// From the pixel's centre, in pixels.
        pub offset: Vec2,
        /// What was seen there.
        pub radiance: Rgb,
    }
}

row! {
    /// Samples around a pixel, and how far away they still count.
    pub struct PixelAverageQuestion {
        /// The tent filter's radius, in pixels.
        pub radius: f32,
        /// The samples.
        pub samples: Vec<Seen>,
    }
}

impl Exercise for PixelAverage {
    type Question = PixelAverageQuestion;
    type Answer = Rgb;
    const NAME: &'static str = "pixel_average";
    const ANSWER: &'static str = "radiance";
    const TASK: &'static str = "Return the average of the samples' radiance, each counted by the filter's weight at its offset from the pixel's centre: Σ w L/Σ w, or black if the weights sum up to 0; here the filter is a tent, w = (1 − |x|/radius) · (1 − |y|/radius), and 0 where either factor would be below 0.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let tent = Filter {
            radius: q.radius,
            ..Filter::TENT
        };
        let sample = |seen: &Seen| filter::Sample {
            offset: seen.offset,
            radiance: seen.radiance,
        };
        let samples: Vec<_> = q.samples.iter().map(sample).collect();
        filter::pixel_average(&tent, &samples)
    }
}

//! Chapter 22: `regular_grid`, `rotated_grid`, `random_pattern`, `jittered`, `poisson_disk`, `pixel_average`.

use crate::exercise::exercises;
use crate::record::row;
use glam::{Vec2, vec2};
use raybook::image::rgb::Rgb;
use raybook::inside::Space;
use raybook::math::pcg;
use raybook::sample::filter::{self, Filter};
use raybook::sample::pattern::{
    jittered, poisson_disk, random_pattern, regular_grid, rotated_grid,
};

exercises! { ($) ch22_antialiasing
    /// Return the middles of columns × rows equal cells of the unit square, in any order; the answer is the list of
    /// these points in the pixel of column x and row y, each moved by (x, y).
    RegularGrid: regular_grid(
        /// The pixel's column in the picture, from 0.
        x: u32,
        /// The pixel's row in the picture, from 0.
        y: u32,
        /// The number of cells side by side, along x.
        columns: u32,
        /// The number of cells one under the other, along y.
        rows: u32,
    ) -> (
        /// The points, in pixels from the picture's top left, in any order.
        point: Vec<Vec2>,
    ) {
        let points = regular_grid::regular_grid(columns as usize, rows as usize);
        let moved = |p: Vec2| p + vec2(x as f32, y as f32);
        points.into_iter().map(moved).collect()
    }

    /// Return all points of a rotated grid that lie in [0, 1)², in any order: (½, ½) + spacing · R (i + offset.x, j +
    /// offset.y) for all whole numbers i and j, where R rotates by arctan ½ about (0, 0), in either sense.
    RotatedGrid: rotated_grid(
        /// The distance from a point to its nearest neighbours, in sides of the square.
        spacing: f32,
        /// From the middle of the square to the lattice's point i = j = 0, in spacings along the lattice.
        offset: Vec2,
    ) -> (
        /// The points, in the unit square, in any order.
        point: Vec<Vec2>,
    ) {
        rotated_grid::rotated_grid(spacing, offset)
    }

    /// Return n random points of the unit square [0, 1)², each anywhere with the same probability and independent of
    /// the others; any generator will do.
    RandomPattern: random_pattern(
        /// The number of points.
        n: u32,
        /// The seed of the random numbers: another seed gives other points.
        seed: u32,
    ) -> (
        /// The points, in the unit square.
        point: Vec<Vec2>,
    ) {
        random_pattern::random_pattern(n as usize, &mut pcg::stream(22, seed.into()))
    }

    /// Return a random point in each of columns × rows equal cells of the unit square, in any order, each anywhere in
    /// its cell with the same probability and independent of the others; any generator will do.
    Jittered: jittered(
        /// The number of cells side by side, along x.
        columns: u32,
        /// The number of cells one under the other, along y.
        rows: u32,
        /// The seed of the random numbers: another seed gives other points.
        seed: u32,
    ) -> (
        /// The points, in the unit square, in any order.
        point: Vec<Vec2>,
    ) {
        let rng = &mut pcg::stream(22, seed.into());
        jittered::jittered(columns as usize, rows as usize, rng)
    }

    /// Return random points of the unit square [0, 1)² of which no two are nearer to each other than the distance, so
    /// many that hardly another one fits in between. Any method and any generator will do. The square's edges are just
    /// edges: nothing is repeated beyond them.
    PoissonDisk: poisson_disk(
        /// The least distance between two points, in sides of the square.
        distance: f32,
        /// The seed of the random numbers: another seed gives other points.
        seed: u32,
    ) -> (
        /// The points, in the unit square, in any order.
        point: Vec<Vec2>,
    ) {
        let rng = &mut pcg::stream(22, seed.into());
        poisson_disk::poisson_disk(distance, Space::Square, rng)
    }

    /// Return the average of the samples' radiance, each weighted by the filter at its offset from the pixel's centre:
    /// Σ w L/Σ w, or black if the weights sum up to 0. The filter is a tent: w = (1 − |x|/radius) · (1 − |y|/radius),
    /// and 0 where either factor would be negative.
    PixelAverage: pixel_average(
        /// The tent filter's radius, in pixels,
        radius: f32 [above 0],
        /// The samples.
        samples: Vec<Seen>,
    ) -> (
        /// The average of the radiance, in W·m⁻²·sr⁻¹.
        radiance: Rgb,
    ) {
        let tent = Filter {
            radius,
            ..Filter::TENT
        };
        let sample = |seen: &Seen| filter::Sample {
            offset: seen.offset,
            radiance: seen.radiance,
        };
        let samples: Vec<_> = samples.iter().map(sample).collect();
        filter::pixel_average(&tent, &samples)
    }
}

row! {
    /// What a ray saw, and where.
    pub struct Seen {
        /// The place from the pixel's centre, in pixels.
        pub offset: Vec2,
        /// The radiance that was seen there, in W·m⁻²·sr⁻¹.
        pub radiance: Rgb,
    }
}

//! Chapter 22: patterns by other constructions and other generators, and a weighted average.

use crate::alternatives::student::{Alternative, Answer, Question};
use glam::{DVec2, DVec3};

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "regular_grid",
        method: "column by column, in f64",
        answer: |q| {
            let (x, y, columns, rows) = (q.number(), q.number(), q.whole(), q.whole());
            let cells = (0..columns).flat_map(|i| (0..rows).map(move |j| (i as f64, j as f64)));
            let place = |(i, j)| {
                DVec2::new(
                    x + (2.0 * i + 1.0) / (2.0 * columns as f64),
                    y + (2.0 * j + 1.0) / (2.0 * rows as f64),
                )
            };
            list(cells.map(place))
        },
    },
    Alternative {
        exercise: "rotated_grid",
        method: "clockwise, by the angle",
        answer: |q| lattice(q, -0.5_f64.atan()),
    },
    Alternative {
        exercise: "rotated_grid",
        method: "counter-clockwise, by the angle",
        answer: |q| lattice(q, 0.5_f64.atan()),
    },
    Alternative {
        exercise: "random_pattern",
        method: "by the minimal standard generator",
        answer: |q| {
            let (n, mut rng) = (q.whole(), MinimalStandard::new(q));
            list((0..n).map(|_| rng.point()))
        },
    },
    Alternative {
        exercise: "random_pattern",
        method: "printed with a few digits, one of them rounded up to 1",
        answer: |q| {
            let (n, mut rng) = (q.whole(), MinimalStandard::new(q));
            let rounded = |i| if i == 0 { 1.0 } else { rng.number() };
            let numbers: Vec<_> = (0..2 * n).map(rounded).collect();
            list(numbers.chunks_exact(2).map(DVec2::from_slice))
        },
    },
    Alternative {
        exercise: "jittered",
        method: "from the last cell to the first, by another generator",
        answer: |q| {
            let (columns, rows) = (q.whole(), q.whole());
            let mut rng = MinimalStandard::new(q);
            let count = DVec2::new(columns as f64, rows as f64);
            let cells = (0..columns * rows).rev();
            let cell = |i| DVec2::new((i % columns) as f64, (i / columns) as f64);
            list(cells.map(|i| (cell(i) + rng.point()) / count))
        },
    },
    Alternative {
        exercise: "poisson_disk",
        method: "darts, until two thousand in a row miss",
        answer: |q| darts(q, 2000, glam::DVec2::distance),
    },
    Alternative {
        exercise: "poisson_disk",
        method: "all places of a fine raster in random order, each a little moved",
        answer: |q| {
            let (distance, mut rng) = (q.number(), MinimalStandard::new(q));
            let mut order: Vec<_> = (0..RASTER * RASTER).collect();
            for i in (1..order.len()).rev() {
                order.swap(i, (rng.number() * (i + 1) as f64) as usize);
            }
            let mut points: Vec<DVec2> = Vec::new();
            for i in order {
                let cell = DVec2::new((i % RASTER) as f64, (i / RASTER) as f64);
                let p = (cell + rng.point()) / RASTER as f64;
                if points.iter().all(|other| p.distance(*other) >= distance) {
                    points.push(p);
                }
            }
            list(points.into_iter())
        },
    },
    Alternative {
        exercise: "pixel_average",
        method: "weights first, divided by their sum, in f64",
        answer: |q| {
            let radius = q.number();
            let samples = q.list(|q| (q.pair(), q.vector()));
            let weight = |offset: &DVec2| {
                let along = |x: f64| ((radius - x.abs()) / radius).max(0.0);
                along(offset.x) * along(offset.y)
            };
            let sum: f64 = samples.iter().map(|(offset, _)| weight(offset)).sum();
            let shares = samples.iter().map(|(offset, light)| match sum {
                0.0 => DVec3::ZERO,
                _ => weight(offset) / sum * *light,
            });
            Some(shares.sum::<DVec3>().to_array().to_vec())
        },
    },
];

/// Cells of the raster along each side.
const RASTER: usize = 90;

fn list(points: impl Iterator<Item = DVec2>) -> Answer {
    let numbers: Vec<_> = points.flat_map(|p| p.to_array()).collect();
    Some([vec![(numbers.len() / 2) as f64], numbers].concat())
}

/// The question's lattice, turned by an angle.
fn lattice(q: &mut Question, angle: f64) -> Answer {
    let (spacing, offset) = (q.number(), q.pair());
    let whole = (-30..30).flat_map(|i| (-30..30).map(move |j| DVec2::new(i.into(), j.into())));
    let places = whole.map(|p| 0.5 + spacing * DVec2::from_angle(angle).rotate(p + offset));
    list(places.filter(|p| p.cmpge(DVec2::ZERO).all() && p.cmplt(DVec2::ONE).all()))
}

/// Darts that are kept if they are far enough from all others, until `misses` in a row are not.
fn darts(q: &mut Question, misses: u32, apart: fn(DVec2, DVec2) -> f64) -> Answer {
    let (distance, mut rng) = (q.number(), MinimalStandard::new(q));
    let (mut points, mut missed) = (Vec::new(), 0);
    while missed < misses {
        let dart = rng.point();
        if points.iter().all(|p| apart(*p, dart) >= distance) {
            points.push(dart);
            missed = 0;
        } else {
            missed += 1;
        }
    }
    list(points.into_iter())
}

/// Park and Miller's generator (1988), as old libraries have it.
struct MinimalStandard(u64);

impl MinimalStandard {
    /// From the question's seed, which is its last number.
    fn new(q: &mut Question) -> Self {
        let mut rng = Self(q.whole() as u64 % 2_147_483_646 + 1);
        rng.number(); // the first is nearly the seed
        rng
    }

    fn number(&mut self) -> f64 {
        self.0 = self.0 * 48_271 % 2_147_483_647;
        self.0 as f64 / 2_147_483_647.0
    }

    fn point(&mut self) -> DVec2 {
        DVec2::new(self.number(), self.number())
    }
}

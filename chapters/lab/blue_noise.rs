//! A blue-noise reference: points computed once, with much effort, and kept in `blue_noise.txt`.

use glam::{Vec2, Vec2Swizzles, vec2};
use rand::RngExt;
use raybook::math::pcg;
use raybook::sample::pattern::Pattern;
use std::sync::OnceLock;

/// Cells of the raster along each side of the square.
pub const SIDE: usize = 512;

/// How many points are kept.
pub const COUNT: usize = 4096;

/// Number of points of the first pattern, which is relaxed; all other points are added one by one.
const FIRST: usize = 32;

/// The reference as a pattern: the first n points of the set, at most 4096. All points together are mirrored, transposed and
/// moved at random; points that leave the square come in again at the other side.
pub const BLUE_NOISE: Pattern = Pattern {
    name: "blue-noise",
    title: "blue noise",
    five: "the first five of the set",
    points: |n, rng| {
        let by = vec2(rng.random(), rng.random());
        let [mirrored, transposed] = [rng.random_bool(0.5), rng.random_bool(0.5)];
        let place = |p: &Vec2| {
            let p = if mirrored { vec2(p.x, 1.0 - p.y) } else { *p };
            let p = if transposed { p.yx() } else { p };
            (p + by).map(|x| x.fract().min(1.0_f32.next_down()))
        };
        kept().iter().take(n).map(place).collect()
    },
};

/// The points in the file: a line for each, with its column and its row on the raster.
pub fn kept() -> &'static [Vec2] {
    static POINTS: OnceLock<Vec<Vec2>> = OnceLock::new();
    POINTS.get_or_init(|| {
        let numbers = include_str!("blue_noise.txt").split_whitespace();
        let cells: Vec<_> = numbers.filter_map(|cell| cell.parse().ok()).collect();
        cells.into_iter().map(place).collect()
    })
}

/// The middle of a cell of the raster.
fn place(cell: usize) -> Vec2 {
    (vec2((cell % SIDE) as f32, (cell / SIDE) as f32) + 0.5) / SIDE as f32
}

/// Makes the set: the cells of `count` points, so that the first n are blue noise for every n.
///
/// Void and cluster (Ulichney, *The void-and-cluster method for dither array generation*, 1993). A Gaussian around every point
/// says how crowded a place is. A few random points are relaxed first: the point in the tightest cluster goes to the largest
/// void, until this void is the place that the point has left. These points are put in order: the point in the tightest cluster
/// is taken out, again and again. Then every further point goes to the largest void. The Gaussian has a standard deviation of
/// half the distance between points, and so becomes narrower whenever the number of points has doubled.
pub fn make(count: usize, seed: u64) -> Vec<usize> {
    let rng = &mut pcg::stream(seed, 0);
    let mut crowd = Crowd::new(FIRST);
    for _ in 0..FIRST {
        crowd.add(rng.random_range(0..SIDE * SIDE));
    }
    for _ in 0..100 * FIRST {
        let tightest = crowd.tightest();
        let left = crowd.remove(tightest);
        let void = crowd.void();
        crowd.add(void);
        if void == left {
            break;
        }
    }
    let mut crowd = Crowd::of(&in_order(crowd.cells), FIRST);
    while crowd.cells.len() < count {
        if crowd.cells.len().is_power_of_two() {
            crowd = Crowd::of(&crowd.cells, 2 * crowd.cells.len());
        }
        crowd.add(crowd.void());
    }
    crowd.cells.truncate(count);
    crowd.cells
}

/// Points in an order in which the first points are as even as possible: the point in the tightest cluster is last, and so on.
fn in_order(mut cells: Vec<usize>) -> Vec<usize> {
    let mut last_first = Vec::new();
    while !cells.is_empty() {
        let tightest = Crowd::of(&cells, cells.len()).tightest();
        last_first.push(cells.remove(tightest));
    }
    last_first.reverse();
    last_first
}

/// Points on a raster, and how crowded every cell is.
struct Crowd {
    cells: Vec<usize>,
    density: Vec<f32>,
    /// exp(−d²/2σ²) for each distance d along an axis, from 0 to 4σ, in cells.
    gauss: Vec<f32>,
}

impl Crowd {
    /// No points yet, of about `count`.
    fn new(count: usize) -> Self {
        let sigma = 0.5 * SIDE as f32 / (count as f32).sqrt();
        let reach = ((4.0 * sigma) as usize).min(SIDE / 2 - 1);
        let at = |d: usize| (-0.5 * (d as f32 / sigma).powi(2)).exp();
        Self {
            cells: Vec::new(),
            density: vec![0.0; SIDE * SIDE],
            gauss: (0..=reach).map(at).collect(),
        }
    }

    /// These points, with Gaussians for about `count` points.
    fn of(cells: &[usize], count: usize) -> Self {
        let mut crowd = Self::new(count);
        for cell in cells {
            crowd.add(*cell);
        }
        crowd
    }

    fn add(&mut self, cell: usize) {
        self.cells.push(cell);
        self.spread(cell, 1.0);
    }

    /// Takes the point of this number out, and returns its cell.
    fn remove(&mut self, number: usize) -> usize {
        let cell = self.cells.remove(number);
        self.spread(cell, -1.0);
        cell
    }

    /// Adds the Gaussian around a cell, multiplied by `times`; beyond an edge it goes on at the other side.
    fn spread(&mut self, cell: usize, times: f32) {
        let reach = self.gauss.len() - 1;
        for dy in 0..=2 * reach {
            let row = (cell / SIDE + dy + SIDE - reach) % SIDE;
            let of_row = times * self.gauss[dy.abs_diff(reach)];
            for dx in 0..=2 * reach {
                let column = (cell % SIDE + dx + SIDE - reach) % SIDE;
                self.density[row * SIDE + column] += of_row * self.gauss[dx.abs_diff(reach)];
            }
        }
    }

    /// The number of the point in the most crowded cell.
    fn tightest(&self) -> usize {
        let crowded = |i: &usize, j: &usize| {
            let [a, b] = [i, j].map(|number| self.density[self.cells[*number]]);
            a.total_cmp(&b)
        };
        (0..self.cells.len()).max_by(crowded).unwrap_or(0)
    }

    /// The least crowded cell.
    fn void(&self) -> usize {
        let emptier = |i: &usize, j: &usize| self.density[*i].total_cmp(&self.density[*j]);
        (0..self.density.len()).min_by(emptier).unwrap_or(0)
    }
}

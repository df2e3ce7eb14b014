//! Which points are near: the unit square in cells, each with its points.

use glam::Vec2;
use std::iter::successors;

/// How distances are measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// In the plane.
    Square,
    /// Over the edges too: what leaves the square comes in on the other side, so that copies of it side by side fit.
    Torus,
}

impl Space {
    /// |p − q|², exact but for the last digit of an `f64`.
    pub fn distance_squared(self, p: Vec2, q: Vec2) -> f64 {
        let apart = (p.as_dvec2() - q.as_dvec2()).abs();
        let apart = match self {
            Self::Square => apart,
            Self::Torus => apart.min(1.0 - apart),
        };
        apart.length_squared()
    }
}

/// Points in cells, each cell a list.
#[derive(Clone, Debug)]
pub struct Neighbours {
    space: Space,
    /// Cells along each side.
    cells: i32,
    /// The last point of each cell.
    last: Vec<Option<u32>>,
    /// The point before each, in its cell.
    before: Vec<Option<u32>>,
    points: Vec<Vec2>,
}

impl Neighbours {
    /// No points yet; whatever is within `reach` of a point will be found in the 3 × 3 cells around it.
    pub fn new(reach: f64, space: Space) -> Self {
        let cells = (1.0 / reach).clamp(1.0, 2048.0) as i32; // more cells would cost more than they save
        Self {
            space,
            cells,
            last: vec![None; (cells * cells) as usize],
            before: Vec::new(),
            points: Vec::new(),
        }
    }

    /// All points, in the order in which they came.
    pub fn points(&self) -> &[Vec2] {
        &self.points
    }

    /// The points themselves.
    pub fn into_points(self) -> Vec<Vec2> {
        self.points
    }

    /// One more point.
    pub fn push(&mut self, p: Vec2) {
        let [x, y] = self.cell(p);
        let cell = (y * self.cells + x) as usize;
        self.before.push(self.last[cell]);
        self.last[cell] = Some(self.points.len() as u32);
        self.points.push(p);
    }

    /// Whether no point is nearer than this distance, which is at most the reach.
    pub fn has_room(&self, p: Vec2, distance: f64) -> bool {
        self.squares(p, 1)
            .all(|square| square >= distance * distance)
    }

    /// The squared distance to the nearest point; infinite without any.
    pub fn nearest_squared(&self, p: Vec2) -> f64 {
        let mut rings = 1;
        loop {
            let found = self.squares(p, rings).fold(f64::INFINITY, f64::min);
            let sure = f64::from(rings) / f64::from(self.cells);
            if found <= sure * sure || rings >= self.cells {
                return found;
            }
            rings *= 2;
        }
    }

    /// The squared distances to the points in the cells of `rings` rings.
    fn squares(&self, p: Vec2, rings: i32) -> impl Iterator<Item = f64> {
        let [x, y] = self.cell(p);
        let columns = move |j| (x - rings..=x + rings).filter_map(move |i| self.index(i, j));
        let cells = (y - rings..=y + rings).flat_map(columns);
        let before = move |i: &u32| self.before[*i as usize];
        let points = cells.flat_map(move |cell| successors(self.last[cell], before));
        points.map(move |i| self.space.distance_squared(p, self.points[i as usize]))
    }

    fn cell(&self, p: Vec2) -> [i32; 2] {
        let along = |x: f32| ((x * self.cells as f32) as i32).clamp(0, self.cells - 1);
        [along(p.x), along(p.y)]
    }

    /// The cell in column i and row j, on the torus counted on over the edges; in the plane `None` outside.
    fn index(&self, i: i32, j: i32) -> Option<usize> {
        let inside = |i: i32| (0..self.cells).contains(&i);
        let (i, j) = match self.space {
            Space::Torus => (i.rem_euclid(self.cells), j.rem_euclid(self.cells)),
            Space::Square if inside(i) && inside(j) => (i, j),
            Space::Square => return None,
        };
        Some((j * self.cells + i) as usize)
    }
}

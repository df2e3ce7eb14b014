//! Finding near points: the unit square is cut into cells, each with a list of its points.

use glam::Vec2;
use std::iter::successors;

/// How distances are measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// In the plane.
    Square,
    /// On a torus, over the edges too: the left edge is next to the right one, so that copies of the square fit side by side.
    Torus,
}

impl Space {
    /// |p − q|², up to the rounding of an `f64`.
    pub fn distance_squared(self, p: Vec2, q: Vec2) -> f64 {
        let apart = (p.as_dvec2() - q.as_dvec2()).abs();
        let apart = match self {
            Self::Square => apart,
            Self::Torus => apart.min(1.0 - apart),
        };
        apart.length_squared()
    }
}

/// Points in cells; each cell is a linked list.
#[derive(Clone, Debug)]
pub struct Neighbours {
    space: Space,
    /// Number of cells along each side.
    cells: i32,
    /// The last point of each cell.
    last: Vec<Option<u32>>,
    /// For each point, the point before it in the same cell.
    before: Vec<Option<u32>>,
    points: Vec<Vec2>,
}

impl Neighbours {
    /// No points yet. Points within the distance `reach` (above 0) of a point will be in the 3 × 3 cells around it.
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

    /// All points, in the order in which they were added.
    pub fn points(&self) -> &[Vec2] {
        &self.points
    }

    /// All points, in the order in which they were added.
    pub fn into_points(self) -> Vec<Vec2> {
        self.points
    }

    /// Adds a point of [0, 1)².
    pub fn push(&mut self, p: Vec2) {
        let [x, y] = self.cell(p);
        let cell = (y * self.cells + x) as usize;
        self.before.push(self.last[cell]);
        self.last[cell] = Some(self.points.len() as u32);
        self.points.push(p);
    }

    /// Whether no point is nearer to p than `distance`, which is at most the reach.
    pub fn has_room(&self, p: Vec2, distance: f64) -> bool {
        self.squares(p, 1)
            .all(|square| square >= distance * distance)
    }

    /// The squared distance from p to the nearest point; ∞ if there are no points.
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

    /// The squared distances from p to the points in p's cell and in `rings` rings of cells around it.
    pub fn squares(&self, p: Vec2, rings: i32) -> impl Iterator<Item = f64> {
        let [x, y] = self.cell(p).map(|along| self.around(along, rings));
        let cells = y.flat_map(move |j| x.clone().map(move |i| (j * self.cells + i) as usize));
        let before = move |i: &u32| self.before[*i as usize];
        let points = cells.flat_map(move |cell| successors(self.last[cell], before));
        points.map(move |i| self.space.distance_squared(p, self.points[i as usize]))
    }

    fn cell(&self, p: Vec2) -> [i32; 2] {
        let along = |x: f32| ((x * self.cells as f32) as i32).clamp(0, self.cells - 1);
        [along(p.x), along(p.y)]
    }

    /// The cells within `rings` cells of a cell along one axis, each once, the nearest first: who looks for a near point finds it
    /// early. On the torus, cells continue over the edges; in the plane, they end there.
    fn around(&self, along: i32, rings: i32) -> impl Iterator<Item = i32> + Clone + use<> {
        let (space, cells) = (self.space, self.cells);
        let all = 2 * rings + 1;
        let count = match space {
            Space::Torus => all.min(cells),
            Space::Square => all,
        };
        (0..count).filter_map(move |k| {
            let i = along + if k % 2 == 0 { k / 2 } else { -(k + 1) / 2 };
            match space {
                // `rem_euclid` would be a division for each cell.
                Space::Torus if i < 0 => Some(i + cells),
                Space::Torus if i >= cells => Some(i - cells),
                _ => (0..cells).contains(&i).then_some(i),
            }
        })
    }
}

//! Space seen along one of its axes: boxes are rectangles there.

use super::diagram::{Diagram, Ink};
use glam::{DVec2, DVec3, dvec2};

/// The names of the axes.
pub const AXES: [&str; 3] = ["x", "y", "z"];

/// Which axes a drawing has.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// The axis along which one looks.
    hidden: usize,
    /// The axis to the right.
    pub across: usize,
    /// The axis upwards.
    pub up: usize,
}

impl View {
    /// The view along an axis.
    pub fn along(hidden: usize) -> Self {
        let [across, up] = [[1, 2], [0, 2], [0, 1]][hidden];
        Self { hidden, across, up }
    }

    /// The view along the axis along which something reaches least: a direction, or the sides of a box.
    pub fn least(size: DVec3) -> Self {
        Self::along(size.abs().min_position())
    }

    /// Where a point, or a vector, is seen.
    pub fn at(&self, p: DVec3) -> DVec2 {
        dvec2(p[self.across], p[self.up])
    }

    /// The rectangle as which a box is seen.
    pub fn rectangle(&self, min: DVec3, max: DVec3) -> [DVec2; 4] {
        let [min, max] = [self.at(min), self.at(max)];
        [min, dvec2(max.x, min.y), max, dvec2(min.x, max.y)]
    }

    /// The planes of a lattice of cells, as lines.
    pub fn lattice(&self, drawing: &mut Diagram, [min, max]: [DVec3; 2], counts: [u32; 3]) {
        let [min, max] = [self.at(min), self.at(max)];
        let line = |i: u32, count: u32| f64::from(i) / f64::from(count.max(1));
        for i in 0..=counts[self.across] {
            let x = min.x + line(i, counts[self.across]) * (max.x - min.x);
            drawing.line(&[dvec2(x, min.y), dvec2(x, max.y)], Ink::Guide);
        }
        for i in 0..=counts[self.up] {
            let y = min.y + line(i, counts[self.up]) * (max.y - min.y);
            drawing.line(&[dvec2(min.x, y), dvec2(max.x, y)], Ink::Guide);
        }
    }

    /// The view in words.
    pub fn words(&self) -> String {
        let [hidden, across, up] = [self.hidden, self.across, self.up].map(|axis| AXES[axis]);
        format!("seen along {hidden}: {across} to the right, {up} upwards")
    }
}

/// A rectangle that is this part of another's width and height, in the same place.
pub fn shrunk(corners: [DVec2; 4], share: f64) -> [DVec2; 4] {
    let middle = middle(&corners);
    corners.map(|p| middle.lerp(p, share))
}

/// The middle of a rectangle.
pub fn middle(corners: &[DVec2; 4]) -> DVec2 {
    0.5 * (corners[0] + corners[2])
}

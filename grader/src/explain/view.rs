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

/// Fills the rectangles of the right answer, and those of yours, each with a share of its width and height, so that both are seen. A list of a
/// student's may hold anything: what has no rectangle is left out.
pub fn fill_both(
    drawing: &mut Diagram,
    right: &[u32],
    yours: Option<&Vec<u32>>,
    [of_right, of_yours]: [f64; 2],
    rectangle: impl Fn(u32) -> Option<[DVec2; 4]>,
) {
    let yours = yours.map_or(&[][..], Vec::as_slice);
    for (answer, share, ink) in [(right, of_right, Ink::Right), (yours, of_yours, Ink::Yours)] {
        for corners in answer.iter().filter_map(|number| rectangle(*number)) {
            drawing.area(&shrunk(corners, share), ink);
        }
    }
}

/// The middle of a rectangle.
pub fn middle(corners: &[DVec2; 4]) -> DVec2 {
    0.5 * (corners[0] + corners[2])
}

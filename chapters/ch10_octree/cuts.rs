//! Cuts through the middle beside cuts where they pay: the same crowd in a quad-tree and in a k-d tree.

use crate::kit::figure::Figure;
use crate::kit::palette::{BLUE, INK, VERMILION};
use crate::kit::sketch::{flat, xy};
use glam::{Vec2, Vec3};

/// The dots: a crowd in a corner, and one far away.
const DOTS: [Vec3; 7] = [
    xy(0.07, 0.245),
    xy(0.145, 0.31),
    xy(0.11, 0.16),
    xy(0.21, 0.21),
    xy(0.24, 0.29),
    xy(0.09, 0.34),
    xy(0.7, 0.9),
];

/// The most dots in a cell.
const MOST: usize = 2;

/// A cut of the k-d tree: whether it is one through x, where, and between which other coordinates.
const CUTS: [(bool, f32, [f32; 2]); 4] = [
    (true, 0.375, [0.0, 1.0]),
    (false, 0.385, [0.0, 0.375]),
    (true, 0.175, [0.0, 0.385]),
    (false, 0.28, [0.0, 0.175]),
];

/// Where the second square is.
const SECOND: Vec3 = xy(1.6, 0.0);

/// What the diagram shows.
pub(super) const CAPTION: &str = "The quad-tree needs three levels of cuts through the middle until no cell has more than two dots, and eight of its \
    cells are empty. The k-d tree cuts off the empty space with two cuts, and divides the crowd with two more: again no cell has more than two \
    dots, and only one cell is empty.";

/// Draws both.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    flat((720, 340), xy(1.3, 0.43), 1.32, |sketch| {
        let mut lines = Vec::new();
        quad_cuts(Vec3::ZERO, 1.0, &mut lines);
        for [from, to] in lines {
            sketch.line(&[from, to], BLUE, 4)?;
        }
        for (through_x, at, [from, to]) in CUTS {
            let end = |other| {
                if through_x {
                    xy(at, other)
                } else {
                    xy(other, at)
                }
            };
            sketch.line(&[from, to].map(|other| SECOND + end(other)), BLUE, 4)?;
        }
        for (corner, words) in [
            (Vec3::ZERO, "quad-tree: cut in the middle"),
            (SECOND, "k-d tree: cut where it pays"),
        ] {
            let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)];
            sketch.line(&square.map(|(x, y)| corner + xy(x, y)), INK, 6)?;
            for dot in DOTS {
                sketch.dot(corner + dot, 9, VERMILION)?;
            }
            sketch.label(corner + xy(0.5, -0.1), Vec2::ZERO, words, INK)?;
        }
        Ok(())
    })
}

/// The cuts of a quad-tree below a square: through its middle, as long as it has more than the most dots.
fn quad_cuts(corner: Vec3, size: f32, lines: &mut Vec<[Vec3; 2]>) {
    let is_inside = |p: &&Vec3| {
        let q = (**p - corner) / size;
        q.x >= 0.0 && q.x < 1.0 && q.y >= 0.0 && q.y < 1.0
    };
    if DOTS.iter().filter(is_inside).count() <= MOST {
        return;
    }
    let half = 0.5 * size;
    let middle = corner + xy(half, half);
    for along in [Vec3::X, Vec3::Y] {
        lines.push([middle - half * along, middle + half * along]);
    }
    for (x, y) in [(0.0, 0.0), (half, 0.0), (0.0, half), (half, half)] {
        quad_cuts(corner + xy(x, y), half, lines);
    }
}

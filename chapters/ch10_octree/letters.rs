//! The letters of the lesson: a cell with its children, in the plane and as a tree.

use crate::kit::figure::{Figure, LEFT};
use crate::kit::palette::{BLUE, INK, ORANGE, VERMILION};
use crate::kit::sketch::{Sketch, flat, xy};
use crate::kit::stage::Drawn;
use glam::{Vec2, Vec3, vec2};

/// The width of the cell.
const SIZE: f32 = 2.0;

/// The shapes, as dots.
const SHAPES: [Vec3; 5] = [
    xy(0.2, 0.75),
    xy(0.45, 0.15),
    xy(0.75, 0.62),
    xy(1.75, 0.2),
    xy(1.55, 1.8),
];

/// Where the ray starts and ends.
const RAY: [Vec3; 2] = [xy(-0.35, 0.45), xy(2.45, 1.8)];

/// The root of the tree beside the cell.
const ROOT: Vec3 = xy(4.1, 1.75);

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson, in the plane. A cell with n shapes has children with n₀, n₁, … shapes. Opening the node \
    costs as much as c tests. One bit for each axis makes the number of a child. The ray visits child 0, then 2, then 3: upwards in the \
    numbers.";

/// The number of the child in which a point is: a bit for each axis.
fn child(p: Vec3) -> usize {
    usize::from(p.x > 0.5 * SIZE) + 2 * usize::from(p.y > 0.5 * SIZE)
}

/// Draws the cell and the tree.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    flat((760, 360), xy(2.5, 1.0), 2.75, |sketch| {
        cell(sketch)?;
        tree(sketch)
    })
}

fn cell(sketch: &Sketch) -> Drawn {
    let half = 0.5 * SIZE;
    let [a, b, c, d] = [xy(0.0, 0.0), xy(SIZE, 0.0), xy(SIZE, SIZE), xy(0.0, SIZE)];
    sketch.line(&[xy(half, 0.0), xy(half, SIZE)], BLUE, 4)?;
    sketch.line(&[xy(0.0, half), xy(SIZE, half)], BLUE, 4)?;
    sketch.line(&[a, b, c, d, a], INK, 6)?;
    for corner in [a, b, c, d] {
        let middle = corner.midpoint(xy(half, half));
        let place = corner.lerp(middle, 0.24);
        sketch.label(place, Vec2::ZERO, &child(middle).to_string(), BLUE)?;
    }
    sketch.label(xy(half, SIZE), vec2(0.0, -32.0), "x: 0 | 1", BLUE)?;
    for (y, words) in [(half - 0.18, "y: 0"), (half + 0.18, "y: 1")] {
        sketch.words(xy(SIZE, y), vec2(16.0, 0.0), words, BLUE, LEFT)?;
    }
    for shape in SHAPES {
        sketch.dot(shape, 11, ORANGE)?;
    }
    sketch.arrow(RAY[0], RAY[1], VERMILION, 5)
}

fn tree(sketch: &Sketch) -> Drawn {
    let leaf = |i: usize| ROOT + xy(0.62 * (i as f32 - 1.5), -1.0);
    let counts = [0, 1, 2, 3].map(|i| SHAPES.iter().filter(|p| child(**p) == i).count());
    for i in 0..4 {
        sketch.line(&[ROOT, leaf(i)], INK, 3)?;
    }
    sketch.circled(ROOT, 0.25, "n", BLUE)?;
    sketch.words(ROOT, vec2(90.0, 0.0), "opening: c", INK, LEFT)?;
    for (i, index) in ["₀", "₁", "₂", "₃"].into_iter().enumerate() {
        sketch.circled(leaf(i), 0.23, &format!("n{index}"), ORANGE)?;
    }
    let [n0, n1, n2, n3] = counts;
    let words = format!("{n0} + {n1} + {n2} + {n3} shapes, n = {}", SHAPES.len());
    sketch.label(ROOT + xy(0.0, -1.55), Vec2::ZERO, &words, INK)
}

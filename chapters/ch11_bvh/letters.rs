//! The letters of the lesson: a box with two boxes in it, and the same as a tree.

use crate::kit::figure::{Figure, LEFT};
use crate::kit::palette::{BLUE, GREEN, INK, ORANGE, VERMILION};
use crate::kit::sketch::{Sketch, flat, xy};
use crate::kit::stage::Drawn;
use glam::{Vec2, Vec3, vec2};
use plotters::prelude::RGBColor;
use raybook::math::aabb::Aabb;

/// The triangles of the left and of the right side.
const LEFT_SIDE: [[Vec3; 3]; 2] = [
    [xy(0.0, 0.5), xy(0.4, 1.2), xy(0.58, 0.6)],
    [xy(0.7, 0.0), xy(1.2, 0.3), xy(0.9, 0.8)],
];
const RIGHT_SIDE: [[Vec3; 3]; 3] = [
    [xy(1.9, 1.3), xy(2.3, 1.9), xy(2.4, 1.4)],
    [xy(2.5, 1.0), xy(2.95, 0.8), xy(2.88, 1.35)],
    [xy(3.0, 1.5), xy(3.4, 1.7), xy(3.2, 1.9)],
];

/// Where the ray starts and ends: it meets the root and the left side.
const RAY: [Vec3; 2] = [xy(-0.3, 0.9), xy(3.75, 0.25)];

/// The root of the tree beside the boxes.
const ROOT: Vec3 = xy(5.0, 1.45);

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson. A(n) is the surface area of the box of node n, and |n| is the number of shapes in it. A \
    split has a left side L and a right side R. Opening a branch costs c branch, and testing a shape costs c shape.";

/// Draws the boxes and the tree.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    flat((800, 350), xy(2.85, 0.9), 2.95, |sketch| {
        boxes(sketch)?;
        tree(sketch)
    })
}

fn boxes(sketch: &Sketch) -> Drawn {
    let left = Aabb::of(LEFT_SIDE.concat());
    let right = Aabb::of(RIGHT_SIDE.concat());
    let root = left.union(&right);
    outline(sketch, &root.grown(0.04), INK)?;
    for (bounds, colour) in [(left, BLUE), (right, GREEN)] {
        outline(sketch, &bounds, colour)?;
    }
    for [a, b, c] in LEFT_SIDE.into_iter().chain(RIGHT_SIDE) {
        sketch.area(&[a, b, c], ORANGE, 0.7)?;
        sketch.line(&[a, b, c, a], INK, 2)?;
    }
    sketch.arrow(RAY[0], RAY[1], VERMILION, 5)?;
    sketch.label(RAY[1], vec2(-10.0, 36.0), "ray", VERMILION)?;
    let above = root.min.with_y(root.max.y);
    sketch.words(above, vec2(0.0, -34.0), "root: area A(root)", INK, LEFT)?;
    let words = |side: &str, count| format!("{side}: A({side}), |{side}| = {count}");
    let place = left.min.with_y(left.max.y);
    sketch.words(
        place,
        vec2(0.0, -28.0),
        &words("L", LEFT_SIDE.len()),
        BLUE,
        LEFT,
    )?;
    let place = right.min;
    sketch.words(
        place,
        vec2(-34.0, 34.0),
        &words("R", RIGHT_SIDE.len()),
        GREEN,
        LEFT,
    )
}

fn outline(sketch: &Sketch, bounds: &Aabb, colour: RGBColor) -> Drawn {
    let (min, max) = (bounds.min.with_z(0.0), bounds.max.with_z(0.0));
    let corners = [min, min.with_x(max.x), max, max.with_x(min.x), min];
    sketch.area(&corners, colour, 0.06)?;
    sketch.line(&corners, colour, 5)
}

fn tree(sketch: &Sketch) -> Drawn {
    let leaves = [-0.6, 0.6].map(|x| ROOT + xy(x, -1.15));
    for leaf in leaves {
        sketch.line(&[ROOT, leaf], INK, 3)?;
    }
    sketch.circled(ROOT, 0.3, "root", INK)?;
    sketch.label(ROOT, vec2(0.0, -96.0), "c branch", INK)?;
    for (leaf, name, colour, shapes) in [
        (leaves[0], "L", BLUE, LEFT_SIDE.len()),
        (leaves[1], "R", GREEN, RIGHT_SIDE.len()),
    ] {
        sketch.circled(leaf, 0.24, name, colour)?;
        let words = format!("{shapes} · c shape");
        sketch.label(leaf + xy(0.0, -0.42), Vec2::ZERO, &words, INK)?;
    }
    Ok(())
}

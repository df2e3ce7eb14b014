//! The letters of the lesson: a binary tree that becomes one node, and a ray through a box.

use crate::kit::figure::Figure;
use crate::kit::palette::{BLUE, FAINT, GREEN, INK, ORANGE, VERMILION};
use crate::kit::sketch::{Sketch, flat, xy};
use crate::kit::stage::Drawn;
use glam::{Vec2, Vec3, vec2};
use plotters::prelude::WHITE;

/// The nodes of the binary tree with their places and their children; who has none is a leaf.
const NODES: [(f32, f32, Option<[usize; 2]>); 13] = [
    (1.7, 0.0, Some([1, 2])),
    (0.65, -0.55, Some([3, 4])),
    (2.9, -0.55, Some([7, 8])),
    (0.2, -1.1, None),
    (1.05, -1.1, Some([5, 6])),
    (0.8, -1.65, None),
    (1.3, -1.65, None),
    (2.4, -1.1, Some([9, 10])),
    (3.4, -1.1, Some([11, 12])),
    (2.15, -1.65, None),
    (2.65, -1.65, None),
    (3.15, -1.65, None),
    (3.65, -1.65, None),
];

/// Where the wide node is, and the places that it has for children.
const WIDE: Vec3 = xy(6.2, 0.0);
const PLACES: usize = 8;

/// Radius of a node and half of the width of a leaf.
const RADIUS: f32 = 0.21;
const LEAF: f32 = 0.19;

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson. Above: a binary tree with seven leaves (squares) becomes one node with seven children and an \
    empty place. Below, along one axis: a ray starts at o and goes by d per unit of t. The planes of a box are at the coordinates b. The area of \
    the box is A.";

/// Draws both trees and the box.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    flat((800, 450), xy(4.1, -1.55), 4.75, |sketch| {
        binary(sketch)?;
        wide(sketch)?;
        clip(sketch)
    })
}

fn binary(sketch: &Sketch) -> Drawn {
    let at = |i: usize| xy(NODES[i].0, NODES[i].1);
    for (i, (_, _, children)) in NODES.iter().enumerate() {
        for child in children.iter().flatten() {
            sketch.line(&[at(i), at(*child)], INK, 3)?;
        }
    }
    for (i, (_, _, children)) in NODES.iter().enumerate() {
        if children.is_some() {
            sketch.circled(at(i), RADIUS, &i.to_string(), BLUE)?;
        } else {
            leaf(sketch, at(i), &i.to_string())?;
        }
    }
    Ok(())
}

fn wide(sketch: &Sketch) -> Drawn {
    let place = |k: usize| WIDE + xy(0.48 * (k as f32 - 3.5), -1.2);
    let leaves = (0..NODES.len()).filter(|i| NODES[*i].2.is_none());
    let leaves: Vec<_> = leaves.collect();
    for k in 0..PLACES {
        if k < leaves.len() {
            sketch.line(&[WIDE, place(k)], INK, 3)?;
        } else {
            sketch.dashes(WIDE, place(k), FAINT, 3)?;
        }
    }
    sketch.circled(WIDE, RADIUS, "0", BLUE)?;
    for (k, i) in leaves.iter().enumerate() {
        leaf(sketch, place(k), &i.to_string())?;
    }
    let [a, b, c, d] = square(place(leaves.len()));
    sketch.area(&[a, b, c, d], WHITE, 1.0)?;
    for [from, to] in [[a, b], [b, c], [c, d], [d, a]] {
        sketch.dashes(from, to, FAINT, 3)?;
    }
    Ok(())
}

fn square(middle: Vec3) -> [Vec3; 4] {
    [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| middle + LEAF * xy(x, y))
}

fn leaf(sketch: &Sketch, middle: Vec3, name: &str) -> Drawn {
    let [a, b, c, d] = square(middle);
    sketch.area(&[a, b, c, d], WHITE, 1.0)?;
    sketch.area(&[a, b, c, d], ORANGE, 0.3)?;
    sketch.line(&[a, b, c, d, a], ORANGE, 4)?;
    sketch.label(middle, Vec2::ZERO, name, INK)
}

/// A ray along an axis, and the planes of a box.
fn clip(sketch: &Sketch) -> Drawn {
    let axis = |x: f32| xy(x, -3.0);
    let (start, near, far) = (0.5, 3.6, 5.7);
    let half = xy(0.0, 0.5);
    let corners = [
        axis(near) - half,
        axis(far) - half,
        axis(far) + half,
        axis(near) + half,
    ];
    let [a, b, c, d] = corners;
    sketch.area(&corners, GREEN, 0.15)?;
    sketch.line(&[a, b, c, d, a], GREEN, 5)?;
    sketch.label(
        axis(0.5 * (near + far)) - half,
        vec2(0.0, 32.0),
        "A: the box's area",
        GREEN,
    )?;
    sketch.arrow(axis(start), axis(7.9), VERMILION, 4)?;
    sketch.arrow(axis(start), axis(start + 0.9), VERMILION, 9)?;
    sketch.label(axis(start + 0.55), vec2(0.0, -38.0), "d", VERMILION)?;
    sketch.dot(axis(start), 11, INK)?;
    sketch.label(axis(start), vec2(0.0, 40.0), "o", INK)?;
    for (x, aside, words) in [(near, -1.0, "t of entry"), (far, 1.0, "t of leaving")] {
        sketch.dot(axis(x), 11, VERMILION)?;
        sketch.label(axis(x), vec2(aside * 120.0, 32.0), words, VERMILION)?;
        sketch.label(axis(x) + half, vec2(0.0, -28.0), "b", GREEN)?;
    }
    Ok(())
}

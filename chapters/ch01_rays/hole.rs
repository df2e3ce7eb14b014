//! The pin-hole camera from the side: the picture on its back wall, and on a wall in front of the hole.

use crate::kit::figure::Figure;
use crate::kit::palette::{BLUE, GREEN, INK, VERMILION};
use crate::kit::sketch::{Sketch, flat, xy};
use crate::kit::stage::Drawn;
use glam::{Vec3, vec2};
use plotters::prelude::RGBColor;

/// The hole.
const HOLE: Vec3 = Vec3::ZERO;

/// The distance of both walls from the hole.
const FOCAL_LENGTH: f32 = 1.4;

/// Foot and top of the tree.
const TREE: [Vec3; 2] = [xy(2.9, -0.75), xy(2.9, 0.95)];

/// Half of the height of the walls.
const HALF: f32 = 0.95;

/// Draws the box, the tree, and the two pictures of it, which the lines through the hole make.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    flat((720, 330), xy(0.75, 0.0), 2.5, |sketch| {
        let [back, front] = [-FOCAL_LENGTH, FOCAL_LENGTH];
        for p in TREE {
            sketch.line(&[p, on_wall(p, back)], VERMILION, 4)?;
        }
        let gap = xy(0.0, 0.05);
        let corner = |x: f32, side: f32| xy(x, side * HALF);
        for side in [-1.0, 1.0] {
            let wall = [
                corner(back, 0.0),
                corner(back, side),
                corner(0.0, side),
                HOLE + side * gap,
            ];
            sketch.line(&wall, INK, 7)?;
        }
        sketch.dashes(corner(front, -1.0), corner(front, 1.0), BLUE, 4)?;
        for x in [back, front] {
            tree(sketch, TREE.map(|p| on_wall(p, x)), 0.6)?;
        }
        tree(sketch, TREE, 1.0)?;

        let below = xy(0.0, -HALF - 0.12);
        sketch.measure(xy(back, 0.0) + below, below, INK)?;
        sketch.measure(below, xy(front, 0.0) + below, INK)?;
        for x in [back, front] {
            sketch.label(xy(0.5 * x, 0.0) + below, vec2(0.0, -2.0), "f", INK)?;
        }
        sketch.label(HOLE, vec2(64.0, -46.0), "hole", INK)?;
        sketch.label(
            corner(0.5 * back, 1.0),
            vec2(0.0, -40.0),
            "back wall: upside down",
            INK,
        )?;
        sketch.label(
            corner(front, 1.0),
            vec2(0.0, -40.0),
            "wall in front: upright",
            BLUE,
        )
    })
}

/// Where the line from a point through the hole meets the wall at this x.
fn on_wall(p: Vec3, x: f32) -> Vec3 {
    p * (x / p.x)
}

/// A tree from its foot to its top, in colours of this strength.
fn tree(sketch: &Sketch, [foot, top]: [Vec3; 2], strength: f64) -> Drawn {
    const TRUNK: RGBColor = RGBColor(120, 84, 40);
    let up = top - foot;
    let side = 0.24 * xy(-up.y, up.x);
    let crown = foot + 0.3 * up;
    sketch.line(&[foot, crown], TRUNK, 11)?;
    sketch.area(&[crown - side, top, crown + side], GREEN, strength)
}

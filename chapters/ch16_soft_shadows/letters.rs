//! The letters of the lesson: a light, a board below it, and its shadow on the floor.

use crate::kit::figure::{Figure, LEFT, RIGHT};
use crate::kit::palette::{BLUE, FAINT, INK, ORANGE, VERMILION};
use crate::kit::sketch::{flat, xy};
use glam::{Vec3, vec2};

/// Width and height of the light, and of the board.
const LIGHT: (f32, f32) = (0.9, 2.0);
const BOARD: (f32, f32) = (1.5, 1.0);

/// What the diagram shows.
pub(super) const CAPTION: &str = "The light has the width w and the height H above the floor. The board has the width b and the height h. On the \
    floor, x is counted from the middle. Dashed: the two lines that graze the right end of the board.";

/// Draws the lines past the ends of the board, and what they leave in the dark.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let ends = |(width, height): (f32, f32)| [-0.5, 0.5].map(|side| xy(side * width, height));
    let [light, board] = [ends(LIGHT), ends(BOARD)];
    // Where the line from a point of the light past an end of the board meets the floor.
    let floor = |from: Vec3, past: Vec3| from + (past - from) * (from.y / (from.y - past.y));
    let umbra = floor(light[1], board[1]);
    let penumbra = floor(light[0], board[1]);
    flat((760, 390), xy(0.05, 0.95), 2.75, |sketch| {
        sketch.line(&[xy(-2.3, 0.0), xy(2.4, 0.0)], INK, 4)?;
        sketch.line(&[Vec3::ZERO, umbra], INK, 16)?;
        sketch.line(&[umbra, penumbra], FAINT, 16)?;
        for (from, past) in [(light[1], board[0]), (light[0], board[0])] {
            sketch.line(&[from, floor(from, past)], FAINT, 2)?;
        }
        for (from, to) in [(light[1], umbra), (light[0], penumbra)] {
            sketch.dashes(from, to, VERMILION, 4)?;
        }
        sketch.line(&light, ORANGE, 14)?;
        sketch.line(&board, BLUE, 10)?;
        let above = xy(0.0, 0.14);
        sketch.measure(light[0] + above, light[1] + above, ORANGE)?;
        sketch.label(xy(0.0, LIGHT.1) + above, vec2(0.0, -26.0), "w", INK)?;
        sketch.measure(board[0] - above, board[1] - above, BLUE)?;
        sketch.label(xy(0.0, BOARD.1) - above, vec2(0.0, 30.0), "b", INK)?;
        let beside = |x: f32, high: f32, name: &str, colour, end, side: f32| {
            sketch.measure(xy(x, 0.0), xy(x, high), colour)?;
            sketch.words(xy(x, 0.55 * high), vec2(side * 16.0, 0.0), name, INK, end)
        };
        beside(2.2, LIGHT.1, "H", ORANGE, LEFT, 1.0)?;
        beside(-1.75, BOARD.1, "h", BLUE, RIGHT, -1.0)?;
        for (p, name) in [
            (Vec3::ZERO, "0"),
            (umbra, "x umbra"),
            (penumbra, "x penumbra"),
        ] {
            sketch.label(p, vec2(0.0, 40.0), name, INK)?;
        }
        sketch.label(umbra.midpoint(Vec3::ZERO), vec2(0.0, -34.0), "nothing", INK)?;
        sketch.label(umbra.midpoint(penumbra), vec2(0.0, -34.0), "a part", INK)
    })
}

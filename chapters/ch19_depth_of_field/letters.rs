//! The letters of the lesson: a thin lens from the side, a point in focus and one that is nearer.

use crate::kit::figure::Figure;
use crate::kit::palette::{BLUE, FAINT, GREEN, INK, SKY, VERMILION};
use crate::kit::sketch::{flat, xy};
use glam::vec2;
use raybook::camera::lens::Lens;

/// The focal length, the lens's opening, the distance that is in focus, and that of the nearer point.
const FOCAL_LENGTH: f32 = 0.95;
const OPENING: f32 = 1.4;
const FOCUS: f32 = 3.1;
const NEARER: f32 = 1.9;

/// How much thicker than a line the lens is drawn in its middle.
const THICK: f32 = 0.2;

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson. The lens has the opening A. The film is at the distance d behind the lens, and what \
    is at the distance s in front is sharp. The light of a point at another distance x makes a disc of diameter c on the film. The light of a \
    star would come together at the focal length f.";

/// Draws the light of both points through the lens, on the way to the film.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let at = |distance| Lens::new(FOCAL_LENGTH, FOCAL_LENGTH / OPENING, distance);
    let lens = at(FOCUS)?;
    let [film, behind] = [lens.film_distance(), at(NEARER)?.film_distance()];
    let edges = [0.5, -0.5].map(|side| xy(0.0, side * lens.aperture()));
    flat((760, 400), xy(0.7, -0.05), 3.1, |sketch| {
        sketch.dashes(xy(-2.2, 0.0), xy(3.6, 0.0), FAINT, 3)?;
        let bulge = xy(THICK, 0.0);
        let side = |s: f32| {
            (-10..=10)
                .map(move |i| i as f32 / 10.0)
                .map(move |t| xy(0.0, 0.5 * OPENING * t * s) + s * (1.0 - t * t) * bulge)
        };
        let outline: Vec<_> = side(1.0).chain(side(-1.0)).collect();
        sketch.area(&outline, SKY, 0.4)?;
        for edge in edges {
            for (colour, from, to) in [(BLUE, FOCUS, film), (VERMILION, NEARER, behind)] {
                sketch.line(&[xy(from, 0.0), edge, xy(-to, 0.0)], colour, 4)?;
            }
            sketch.line(&[edge, 1.35 * edge], INK, 9)?;
        }
        let high = 1.2 * xy(0.0, 0.5 * OPENING);
        sketch.line(&[xy(-film, 0.0) - high, xy(-film, 0.0) + high], INK, 6)?;
        sketch.dashes(xy(FOCUS, 0.0) - high, xy(FOCUS, 0.0) + high, BLUE, 4)?;
        sketch.label(xy(-film, 0.0) + high, vec2(0.0, -36.0), "film", INK)?;
        sketch.label(
            xy(FOCUS, 0.0) + high,
            vec2(-30.0, -36.0),
            "plane in focus",
            BLUE,
        )?;
        sketch.dot(xy(FOCUS, 0.0), 11, BLUE)?;
        sketch.dot(xy(NEARER, 0.0), 11, VERMILION)?;

        let blur = xy(0.0, 0.5 * lens.circle_of_confusion(NEARER));
        sketch.line(
            &[xy(-film, 0.0) - blur, xy(-film, 0.0) + blur],
            VERMILION,
            14,
        )?;
        sketch.label(xy(-film, 0.0) + blur, vec2(-36.0, -16.0), "c", VERMILION)?;
        let opening = xy(0.42, 0.0);
        sketch.measure(edges[1] + opening, edges[0] + opening, INK)?;
        sketch.label(opening, vec2(0.0, 0.0), "A", INK)?;
        for (from, to, y, name, colour) in [
            (-film, 0.0, -1.35, "d", INK),
            (0.0, FOCUS, -1.35, "s", BLUE),
            (0.0, NEARER, 1.2, "x", VERMILION),
            (-FOCAL_LENGTH, 0.0, -1.08, "f", GREEN),
        ] {
            sketch.measure(xy(from, y), xy(to, y), colour)?;
            sketch.label(xy(0.5 * (from + to), y), vec2(0.0, -2.0), name, colour)?;
        }
        sketch.dot(xy(-FOCAL_LENGTH, 0.0), 11, GREEN)
    })
}

//! The letters of the lesson: a direction around the camera, and its pixel.

use crate::kit::figure::Figure;
use crate::kit::palette::{FAINT, INK, VERMILION};
use crate::shared::directions::directions;
use glam::vec2;

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson. The place (u, v) of a pixel becomes the angle φ from forward towards the right and the angle \
    θ from straight up. They give the direction d in the axes of the camera: forward, right and up.";

/// Draws them.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    directions(["up", "forward", "right"], |page, at, place| {
        page.dashes(at(vec2(0.5, 0.0)), at(vec2(0.5, 1.0)), FAINT, 3)?;
        page.dashes(at(vec2(0.0, 0.5)), at(vec2(1.0, 0.5)), FAINT, 3)?;
        page.dashes(at(vec2(place.x, 0.0)), at(place), VERMILION, 3)?;
        page.dashes(at(vec2(0.0, place.y)), at(place), VERMILION, 3)?;
        page.dot(at(place), 13, VERMILION)?;
        page.label(at(place), vec2(28.0, 18.0), "d", VERMILION)?;
        for (u, name) in [(0.04, "behind"), (0.5, "ahead"), (0.96, "behind")] {
            page.label(at(vec2(u, 1.0)), vec2(0.0, 34.0), name, INK)?;
        }
        Ok(())
    })
}

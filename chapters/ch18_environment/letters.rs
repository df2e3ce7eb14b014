//! The letters of the lesson: the sphere of directions, and a pixel of the map.

use crate::kit::figure::{Figure, RIGHT};
use crate::kit::palette::{GREEN, INK, VERMILION};
use crate::shared::directions::directions;
use glam::{Vec2, vec2};

/// Rows and columns of the map that is drawn.
const ROWS: u32 = 6;

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson. A direction d has the angle θ from +y and the angle φ from −z towards +x. On the map, u goes \
    to the right and v goes down. A row lies between the angles θ₀ and θ₁. Each of its pixels covers the solid angle Ω.";

/// Draws them.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    directions(["+y", "−z", "+x"], |page, at, place| {
        let size = vec2(0.5, 1.0) / ROWS as f32;
        let texel = (place / size).floor() * size;
        let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
        let corners = corners.map(|(x, y)| at(texel + size * vec2(x, y)));
        page.area(&corners, VERMILION, 0.35)?;
        for (v, name) in [(texel.y, "θ₀"), (texel.y + size.y, "θ₁")] {
            page.line(&[at(vec2(0.0, v)), at(vec2(1.0, v))], GREEN, 4)?;
            page.words(at(vec2(1.0, v)), vec2(52.0, 0.0), name, GREEN, RIGHT)?;
        }
        page.label(at(texel + 0.5 * size), Vec2::ZERO, "Ω", INK)?;
        for (u, name) in [(0.25, "−x"), (0.5, "−z"), (0.75, "+x")] {
            page.label(at(vec2(u, 1.0)), vec2(0.0, 34.0), name, INK)?;
        }
        page.label(
            at(vec2(0.65, 0.0)),
            vec2(0.0, -36.0),
            "+y is the whole top edge",
            INK,
        )
    })
}

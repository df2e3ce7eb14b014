//! The letters of the walk: a row of cells, and a ray that crosses the planes between them.

use crate::kit::figure::Figure;
use crate::kit::palette::{BLUE, FAINT, INK, VERMILION};
use crate::kit::sketch::{flat, xy};
use glam::{Vec3, vec2};
use raybook::math::{dir3::Dir3, ray::Ray};

/// Cells of the row; each has the width 1.
const CELLS: u32 = 4;

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of the walk, for one axis. The planes of the grid are numbered by i from 0, which is at min, and are \
    one cell apart. A ray from o in the direction d crosses them at the distances tᵢ.";

/// Draws two rows of cells, and the ray.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let ray = Ray::new(xy(-0.6, 0.15), Dir3::new_or(xy(1.0, 0.27), Dir3::X));
    let crosses = |i: u32| ray.at((i as f32 - ray.origin.x) / ray.direction.x);
    let width = CELLS as f32;
    flat((760, 370), xy(1.8, 0.52), 2.75, |sketch| {
        for y in [0.0, 0.75, 1.5] {
            sketch.line(&[xy(0.0, y), xy(width, y)], FAINT, 3)?;
        }
        for i in 0..=CELLS {
            let x = i as f32;
            sketch.line(&[xy(x, 0.0), xy(x, 1.5)], BLUE, 5)?;
            let name = if i == 0 {
                "i = 0".to_owned()
            } else {
                i.to_string()
            };
            sketch.label(xy(x, 0.0), vec2(0.0, 34.0), &name, BLUE)?;
        }
        sketch.label(xy(0.0, 1.5), vec2(0.0, -32.0), "min", BLUE)?;
        sketch.arrow(ray.origin, ray.at(5.1), VERMILION, 4)?;
        sketch.arrow(ray.origin, ray.at(0.5), VERMILION, 9)?;
        sketch.label(ray.at(0.25), vec2(-6.0, -40.0), "d", VERMILION)?;
        sketch.dot(ray.origin, 11, INK)?;
        sketch.label(ray.origin, vec2(0.0, 40.0), "o", INK)?;
        for (i, name) in ["t₀", "t₁", "t₂", "t₃"].into_iter().enumerate() {
            let p = crosses(i as u32);
            sketch.dot(p, 11, VERMILION)?;
            sketch.label(p, vec2(34.0, 24.0), name, VERMILION)?;
        }
        let below = xy(0.0, -0.5);
        sketch.measure(below, below + Vec3::X, INK)?;
        sketch.label(below + 0.5 * Vec3::X, vec2(0.0, 0.0), "cell", INK)?;
        sketch.label(
            below + 2.6 * Vec3::X,
            vec2(0.0, 0.0),
            "tᵢ are equally far apart: cell/dₓ",
            VERMILION,
        )
    })
}

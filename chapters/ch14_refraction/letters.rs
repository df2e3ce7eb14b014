//! The letters of the lesson: a ray at a surface, and the two shares into which its light is parted.

use crate::kit::figure::{Figure, LEFT, RIGHT};
use crate::kit::palette::{BLUE, FAINT, INK, SKY, VERMILION};
use crate::kit::sketch::{flat, xy};
use glam::{Vec3, vec2};
use raybook::material::mirror::reflect;
use raybook::material::refract::refract;
use raybook::math::dir3::Dir3;

/// The angle θ₁ at which the ray arrives, in degrees.
const INCIDENCE: f32 = 45.0;

/// Half of the width and of the height of what is seen.
const HALF: [f32; 2] = [2.4, 1.15];

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson. The ray arrives in the direction i through the medium with the index of refraction η₁, at \
    the angle θ₁ to the normal n. It goes on in the direction t through the medium with the index η₂, at the angle θ₂. The share R of the light \
    is reflected.";

/// Draws a ray that goes from air into a medium of this index.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw(index: f32) -> Figure {
    let (sine, cosine) = INCIDENCE.to_radians().sin_cos();
    let n = Dir3::Y;
    let i = Dir3::new_or(xy(sine, -cosine), Dir3::X);
    let m = reflect(i, n);
    let t = refract(i, n, 1.0, index).map_or(*i, |t| *t);
    let [wide, high] = HALF;
    flat((760, 365), Vec3::ZERO, 2.0 * high, |sketch| {
        let [left, right] = [xy(-wide, 0.0), xy(wide, 0.0)];
        let down = xy(0.0, -high);
        sketch.area(&[left, right, right + down, left + down], SKY, 0.3)?;
        sketch.line(&[left, right], INK, 5)?;
        sketch.dashes(xy(0.0, high), down, FAINT, 3)?;
        sketch.angle(Vec3::ZERO, [*n, -*i], 0.42, "θ₁")?;
        sketch.angle(Vec3::ZERO, [-*n, t], 0.46, "θ₂")?;
        sketch.arrow(Vec3::ZERO, 0.75 * *n, INK, 5)?;
        sketch.words(0.75 * *n, vec2(20.0, 10.0), "n", INK, LEFT)?;
        sketch.arrow(-1.45 * *i, Vec3::ZERO, INK, 8)?;
        sketch.words(-0.95 * *i, vec2(-24.0, 14.0), "i", INK, RIGHT)?;
        sketch.arrow(Vec3::ZERO, 1.35 * *m, VERMILION, 4)?;
        sketch.words(
            0.9 * *m,
            vec2(24.0, 20.0),
            "the share R is reflected",
            VERMILION,
            LEFT,
        )?;
        sketch.arrow(Vec3::ZERO, 1.2 * t, BLUE, 8)?;
        sketch.words(0.95 * t, vec2(34.0, 0.0), "t", BLUE, LEFT)?;
        sketch.words(
            0.5 * t,
            vec2(30.0, 4.0),
            "the share 1 − R goes through",
            BLUE,
            LEFT,
        )?;
        sketch.words(left, vec2(30.0, -40.0), "η₁ (air)", INK, LEFT)?;
        sketch.words(left + down, vec2(30.0, -40.0), "η₂ (glass)", INK, LEFT)
    })
}

//! The letters of the lesson: the normal of a vertex, and the normal inside a triangle.

use crate::kit::figure::{Figure, RIGHT};
use crate::kit::palette::{BLUE, FAINT, INK, VERMILION};
use crate::kit::sketch::{Sketch, flat, xy};
use crate::kit::stage::Drawn;
use glam::{Vec3, vec2};
use raybook::math::dir3::Dir3;
use raybook::shape::attributes::{interpolate_normal, vertex_normals};

/// Two triangles from the side: their far corners, and the vertex in which they meet.
const SIDES: [Vec3; 3] = [xy(-3.3, 0.75), xy(-2.3, 1.7), xy(-0.75, 1.05)];

/// The corners of a triangle, as they appear on the page.
const CORNERS: [Vec3; 3] = [xy(0.3, 0.45), xy(2.9, 0.7), xy(1.35, 1.7)];

/// Where their normals point.
const NORMALS: [Vec3; 3] = [xy(-0.2, 1.0), xy(0.35, 1.0), xy(-0.05, 1.0)];

/// The barycentric coordinates b₁ and b₂ of the point inside.
const INSIDE: [f32; 2] = [0.45, 0.25];

/// The length of a normal on the page.
const LENGTH: f32 = 0.85;

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson. Left, two triangles from the side: the vertex normal n is closer to the normal \
    of the triangle with the larger area A. Right, a triangle: the point p has the barycentric weights b₀, b₁ and b₂, and its normal n is \
    blended from n₀, n₁ and n₂.";

/// Draws both.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    flat((720, 360), xy(-0.1, 1.25), 3.4, |sketch| {
        at_a_vertex(sketch)?;
        inside(sketch)
    })
}

/// Two triangles, as wide as deep, and the mean of their normals by area.
fn at_a_vertex(sketch: &Sketch) -> Drawn {
    let [a, v, b] = SIDES;
    // Seen from the side, each triangle is a line: its third corner is behind its first.
    let positions = [a, a + Vec3::NEG_Z, v, b, b + Vec3::NEG_Z];
    let triangles = [[0, 2, 1], [2, 3, 4]];
    sketch.line(&SIDES, INK, 7)?;
    for ends in [[a, v], [v, b]] {
        let middle = 0.5 * (ends[0] + ends[1]);
        let along = (ends[1] - ends[0]).normalize();
        sketch.arrow(middle, middle + 0.6 * xy(-along.y, along.x), BLUE, 4)?;
    }
    sketch.label(0.5 * (a + v), vec2(70.0, 40.0), "small A", INK)?;
    sketch.label(0.5 * (v + b), vec2(-30.0, 70.0), "large A", INK)?;
    let normals = vertex_normals(&positions, &triangles);
    let tip = v + LENGTH * *normals[2];
    sketch.arrow(v, tip, VERMILION, 8)?;
    sketch.label(tip, vec2(-30.0, 0.0), "n", VERMILION)?;
    sketch.dot(v, 11, INK)?;
    sketch.label(
        xy(-2.0, -0.15),
        vec2(0.0, 0.0),
        "at a vertex: mean by area",
        INK,
    )
}

/// A triangle, the normals of its corners, and the normal of a point between them.
fn inside(sketch: &Sketch) -> Drawn {
    let [p0, p1, p2] = CORNERS;
    sketch.area(&CORNERS, BLUE, 0.12)?;
    sketch.line(&[p0, p1, p2, p0], INK, 4)?;
    let [b1, b2] = INSIDE;
    let p = p0 + b1 * (p1 - p0) + b2 * (p2 - p0);
    for corner in CORNERS {
        sketch.dashes(p, corner, FAINT, 3)?;
    }
    let normals = NORMALS.map(|n| Dir3::new_or(n, Dir3::Y));
    let beside = [vec2(-6.0, 44.0), vec2(10.0, 44.0), vec2(-38.0, 4.0)];
    for (i, (corner, n)) in CORNERS.into_iter().zip(normals).enumerate() {
        let tip = corner + LENGTH * *n;
        sketch.arrow(corner, tip, BLUE, 5)?;
        let index = ["₀", "₁", "₂"][i];
        sketch.words(tip, vec2(-18.0, -10.0), &format!("n{index}"), BLUE, RIGHT)?;
        sketch.dot(corner, 9, INK)?;
        sketch.label(corner, beside[i], &format!("p{index}"), INK)?;
    }
    let tip = p + LENGTH * *interpolate_normal(normals, INSIDE.into());
    sketch.arrow(p, tip, VERMILION, 8)?;
    sketch.label(tip, vec2(30.0, 0.0), "n", VERMILION)?;
    sketch.dot(p, 11, INK)?;
    sketch.label(p, vec2(32.0, 18.0), "p", INK)?;
    sketch.label(
        xy(1.7, -0.15),
        vec2(0.0, 0.0),
        "inside: blend by b₀, b₁, b₂",
        INK,
    )
}

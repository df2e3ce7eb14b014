//! Chapter 7: `interpolate_normal`, `interpolate_texture`, `vertex_normals`, `mesh_hit`.

mod interpolate_normal;
mod interpolate_texture;
mod mesh_hit;
mod vertex_normals;

use crate::examine::Examiner;
use crate::sample;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch07_mesh::{
    InterpolateNormal, InterpolateTexture, MeshHit, VertexNormals,
};
use glam::{Vec2, vec2};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[
    &InterpolateNormal,
    &InterpolateTexture,
    &VertexNormals,
    &MeshHit,
];

/// Places in a triangle, by name: (b1, b2).
const PLACES: [(&str, Vec2); 6] = [
    ("at the first corner", vec2(0.0, 0.0)),
    ("at the second corner", vec2(1.0, 0.0)),
    ("at the third corner", vec2(0.0, 1.0)),
    ("in the middle of the first edge", vec2(0.5, 0.0)),
    ("in the middle of the long edge", vec2(0.5, 0.5)),
    ("off the middle", vec2(0.2, 0.5)),
];

fn place(rng: &mut Pcg) -> Vec2 {
    let b1 = sample::number(rng, 0.0, 1.0);
    vec2(b1, (1.0 - b1) * sample::number(rng, 0.0, 1.0))
}

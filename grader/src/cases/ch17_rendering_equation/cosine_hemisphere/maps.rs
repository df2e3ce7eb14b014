//! How two numbers make a direction, and by which axes beside the normal, as students write it.

use super::super::at_height;
use crate::cases::ch16_soft_shadows::crossed;
use crate::upon::changed;
use glam::{Vec2, Vec3, vec3};
use raybook::math::basis::Basis;
use raybook_workbook::exercises::ch17_rendering_equation::{CosineHemisphere, lattice};
use std::f32::consts::TAU;

/// How two uniform numbers make a direction, in coordinates whose z is the normal: the cosine of the angle to it, made of the first number, and
/// the angle around it, made of both.
#[derive(Clone, Copy)]
pub(super) struct How {
    pub(super) cosine: fn(f32) -> f32,
    pub(super) turn: fn(Vec2) -> f32,
}

/// The lattice's images, but for what is changed.
pub(super) fn chosen(q: &CosineHemisphere, change: impl FnOnce(&mut How)) -> Vec<Vec3> {
    let right = How {
        cosine: |u| (1.0 - u).sqrt(),
        turn: |u| TAU * u.y,
    };
    let How { cosine, turn } = changed(right, change);
    let basis = Basis::around(q.normal);
    let image = |u: Vec2| basis.to_world(at_height(cosine(u.x), turn(u)));
    lattice(q.n).map(image).collect()
}

/// The lattice's images by another map, given in coordinates whose z is the normal.
pub(super) fn around(q: &CosineHemisphere, warp: fn(Vec2) -> Vec3) -> Vec<Vec3> {
    let basis = Basis::around(q.normal);
    lattice(q.n).map(|u| basis.to_world(warp(u))).collect()
}

/// The direction to a point of the unit sphere whose middle is lifted to this height.
pub(super) fn lifted(height: f32, u: Vec2) -> Vec3 {
    let of_sphere = at_height(1.0 - 2.0 * u.x, TAU * u.y);
    (of_sphere + height * Vec3::Z).normalize_or_zero()
}

/// The lattice's images by these axes beside the normal.
pub(super) fn by_axes(q: &CosineHemisphere, x: Vec3, y: Vec3) -> Vec<Vec3> {
    let image = |u: Vec2| {
        let d = at_height((1.0 - u.x).sqrt(), TAU * u.y);
        d.x * x + d.y * y + d.z * *q.normal
    };
    lattice(q.n).map(image).collect()
}

/// The same, brought to length 1.
pub(super) fn beside(q: &CosineHemisphere, x: Vec3, y: Vec3) -> Vec<Vec3> {
    let images = by_axes(q, x, y).into_iter();
    images.map(Vec3::normalize_or_zero).collect()
}

/// The lattice's images, brought to length 1, by axes that are cross products with another vector, and not of length 1.
pub(super) fn squeezed(q: &CosineHemisphere, up: Vec3) -> Vec<Vec3> {
    let [x, y] = crossed(q.normal, up);
    beside(q, x, y)
}

/// The same, but the first of the axes is of length 1.
pub(super) fn half_squeezed(q: &CosineHemisphere, up: Vec3) -> Vec<Vec3> {
    let [x, y] = crossed(q.normal, up);
    beside(q, x.normalize_or_zero(), y)
}

/// The lattice's images, where one axis beside the normal is an axis of the world itself, and the other is perpendicular to both.
pub(super) fn leaning(q: &CosineHemisphere, up: Vec3) -> Vec<Vec3> {
    by_axes(q, q.normal.cross(up).normalize_or_zero(), up)
}

/// The lattice's images by axes that are cross products with another vector. Neither are of length 1.
pub(super) fn shrunk(q: &CosineHemisphere, up: Vec3) -> Vec<Vec3> {
    let [x, y] = crossed(q.normal, up);
    by_axes(q, x, y)
}

/// A point of the unit disc, lifted by 1 − r².
pub(super) fn over_disc(u: Vec2) -> Vec3 {
    let (r, phi) = (u.x.sqrt(), TAU * u.y);
    vec3(r * phi.cos(), r * phi.sin(), 1.0 - r * r)
}

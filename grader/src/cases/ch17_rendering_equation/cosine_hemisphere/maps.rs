//! How two numbers make a direction, and by which axes beside the normal, as students write it.

use crate::cases::ch16_soft_shadows::{crossed, unless_near};
use crate::upon::changed;
use glam::{DVec2, DVec3, Vec2, Vec3, dvec3};
use raybook::math::{basis::Basis, dir3::Dir3};
use raybook_workbook::exercises::ch17_rendering_equation::{CosineHemisphere, lattice};
use std::f64::consts::TAU;

/// How two uniform numbers make a direction; one field wrong is a mistake.
#[derive(Clone, Copy)]
pub(super) struct How {
    /// The distance of a point of the unit disc from its middle, made of the first number.
    pub(super) radius: fn(u: f64) -> f64,
    /// The height above the disc, made of the first number and of that distance.
    pub(super) height: fn(u: f64, r: f64) -> f64,
    /// The angle around the normal, made of both numbers.
    pub(super) turn: fn(u: DVec2) -> f64,
    /// What is taken for a direction in coordinates whose z is the normal.
    pub(super) taken: fn(d: DVec3) -> DVec3,
    /// The two axes beside the normal.
    pub(super) axes: fn(normal: Dir3) -> [Vec3; 2],
    /// Whether the direction is brought to length 1, which the right one has anyway.
    pub(super) is_normalised: bool,
}

/// As it should be.
const WELL: How = How {
    radius: f64::sqrt,
    height: |_, r| sine(r),
    turn: |u| TAU * u.y,
    taken: |d| d,
    axes: |normal| {
        let basis = Basis::around(normal);
        [*basis.x, *basis.y]
    },
    is_normalised: true,
};

/// The lattice's images, but for what is changed.
pub(super) fn chosen(q: &CosineHemisphere, change: impl FnOnce(&mut How)) -> Vec<Vec3> {
    images(q, &changed(WELL, change))
}

fn images(q: &CosineHemisphere, how: &How) -> Vec<Vec3> {
    let [x, y] = (how.axes)(q.normal);
    let image = |u: Vec2| {
        let u = u.as_dvec2();
        let (r, phi) = ((how.radius)(u.x), (how.turn)(u));
        let d = dvec3(r * phi.cos(), r * phi.sin(), (how.height)(u.x, r));
        let d = (how.taken)(d).as_vec3();
        let d = d.x * x + d.y * y + d.z * *q.normal;
        if how.is_normalised {
            d.normalize_or_zero()
        } else {
            d
        }
    };
    lattice(q.n).map(image).collect()
}

/// The same, but not brought to length 1.
pub(super) fn unscaled(q: &CosineHemisphere, change: impl FnOnce(&mut How)) -> Vec<Vec3> {
    chosen(q, |how| {
        how.is_normalised = false;
        change(how);
    })
}

/// The sine of the angle of this cosine, and the cosine of the angle of this sine.
pub(super) fn sine(cosine: f64) -> f64 {
    (1.0 - cosine * cosine).max(0.0).sqrt()
}

/// Takes a point of the unit sphere for that of the disc, at the height 1 − 2u, to which `height` may add that of the sphere's middle.
pub(super) fn take_sphere(how: &mut How, height: fn(u: f64, r: f64) -> f64) {
    how.radius = |u| sine(1.0 - 2.0 * u);
    how.height = height;
}

/// +x, or rather +y where the normal is nearly along it.
pub(super) fn rather_x(normal: Dir3) -> Vec3 {
    unless_near(normal, Vec3::X, Vec3::Y)
}

/// +y, or rather +x where the normal is nearly along it.
pub(super) fn rather_y(normal: Dir3) -> Vec3 {
    unless_near(normal, Vec3::Y, Vec3::X)
}

/// +z, or rather +x where the normal is nearly along it.
pub(super) fn rather_z(normal: Dir3) -> Vec3 {
    unless_near(normal, Vec3::Z, Vec3::X)
}

/// Axes that are cross products with another vector, of which only the first is brought to length 1.
pub(super) fn half_crossed(normal: Dir3, up: Vec3) -> [Vec3; 2] {
    let [x, y] = crossed(normal, up);
    [x.normalize_or_zero(), y]
}

/// An axis of the world itself, and before it the axis that is perpendicular to it and to the normal.
pub(super) fn leaning(normal: Dir3, up: Vec3) -> [Vec3; 2] {
    [up.cross(*normal).normalize_or_zero(), up]
}

/// The same, but the first axis points to the other side.
pub(super) fn leaning_back(normal: Dir3, up: Vec3) -> [Vec3; 2] {
    let [x, up] = leaning(normal, up);
    [-x, up]
}

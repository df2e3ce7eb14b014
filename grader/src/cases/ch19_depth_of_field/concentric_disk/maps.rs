//! Points in the disc as students make them: by another map, or of other points of the square.

use crate::upon::changed;
use glam::Vec2;
use raybook::sample::disk::concentric_disk;
use raybook_workbook::exercises::ch19_depth_of_field::ConcentricDisk;
use std::f32::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

/// The points of the square, and the map to the disc.
#[derive(Clone, Copy)]
pub(super) struct How {
    pub(super) points: fn(&ConcentricDisk) -> Vec<Vec2>,
    pub(super) map: fn(Vec2) -> Vec2,
}

/// The points in the disc, but for what is changed.
pub(super) fn in_disc(q: &ConcentricDisk, change: impl FnOnce(&mut How)) -> Vec<Vec2> {
    let right = How {
        points: |q| q.points().collect(),
        map: concentric_disk,
    };
    let How { points, map } = changed(right, change);
    points(q).into_iter().map(map).collect()
}

/// The points in the disc by another map.
pub(super) fn mapped(q: &ConcentricDisk, map: fn(Vec2) -> Vec2) -> Vec<Vec2> {
    in_disc(q, |how| how.map = map)
}

/// A map by radius and angle.
pub(super) fn by_angle(u: Vec2) -> Vec2 {
    u.x.max(0.0).sqrt() * Vec2::from_angle(TAU * u.y)
}

/// Half the length of the chord of the unit disc at this distance from its middle.
pub(super) fn half_chord(distance: f32) -> f32 {
    (1.0 - distance * distance).max(0.0).sqrt()
}

/// Radius and angle of the concentric map for (a, b) = 2u − 1.
pub(super) fn by_sides(a: f32, b: f32) -> (f32, f32) {
    if a.abs() > b.abs() {
        (a, FRAC_PI_4 * b / a)
    } else {
        (b, FRAC_PI_2 - FRAC_PI_4 * a / b)
    }
}

/// The concentric map, if the quotients b/a on the left and the right and a/b above and below are changed.
pub(super) fn by_quotients(u: Vec2, beside: fn(f32) -> f32, above: fn(f32) -> f32) -> Vec2 {
    let (a, b) = (2.0 * u - 1.0).into();
    if a.abs() > b.abs() {
        a * Vec2::from_angle(FRAC_PI_4 * beside(b / a))
    } else if b == 0.0 {
        Vec2::ZERO
    } else {
        b * Vec2::from_angle(FRAC_PI_2 - FRAC_PI_4 * above(a / b))
    }
}

/// The remainder of a division by 1, as C has it: with the sign of the number.
pub(super) fn remainder(moved: Vec2) -> Vec2 {
    moved % 1.0
}

/// The points of the square where some rule puts them, which is told where the shift moves them and where they should be.
pub(super) fn shifted(q: &ConcentricDisk, place: fn(Vec2, Vec2) -> Vec2) -> Vec<Vec2> {
    let lattice = ConcentricDisk {
        shift: Vec2::ZERO,
        ..q.clone()
    };
    let rows = lattice.points().zip(q.points());
    rows.map(|(u, right)| place(u + q.shift, right)).collect()
}

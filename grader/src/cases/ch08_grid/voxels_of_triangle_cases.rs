//! The questions of `voxels_of_triangle`.

use crate::{sample};
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch08_grid::VoxelsOfTriangle;
use glam::{uvec3, vec3};
use rand::RngExt;

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> VoxelsOfTriangle {
    let cell = vec3(1.0, 0.8, 1.1) * sample::number(rng, 0.5, 1.5);
    let min = sample::point(rng, 3.0);
    let n = uvec3(
        rng.random_range(2..6),
        rng.random_range(2..6),
        rng.random_range(2..5),
    );
    let extents = n.as_vec3() * cell;
    let center = min + 0.5 * extents;
    let half = 0.5 * sample::number(rng, 0.5, 1.1) * extents;
    let mut corner = || center + sample::point(rng, 1.0) * half;
    let (p0, p1, p2) = (corner(), corner(), corner());
    VoxelsOfTriangle {
        min,
        cell,
        nx: n.x,
        ny: n.y,
        nz: n.z,
        margin: sample::number(rng, 0.0, 0.15),
        p0,
        p1,
        p2,
    }
}

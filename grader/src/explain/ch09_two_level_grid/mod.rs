//! Chapter 9: a coarse cell cut into fine ones, and the walk through cells in cells.

mod refine;
mod walk;

use glam::UVec3;

/// All cells of a lattice, along x first, then y, then z.
fn cells(along: UVec3) -> impl Iterator<Item = UVec3> {
    let row = move |(z, y)| (0..along.x).map(move |x| UVec3::new(x, y, z));
    let rows = (0..along.z).flat_map(move |z| (0..along.y).map(move |y| (z, y)));
    rows.flat_map(row)
}

//! How many cells a grid has.

use glam::{UVec3, Vec3};

/// λ: cells per shape, if nobody says otherwise.
///
/// Measured on the Stanford bunny, with λ from 2.5 to 40: for rays from a camera 2.5 to 20 are alike; rays from the surface are
/// fastest at 10, and 5 costs them a seventh more; rays from everywhere to everywhere are fastest at 2.5, for more cells are
/// more memory to wait for, and 5 costs them a sixth more. So 5 is in between. The chapter draws such a measurement.
pub(crate) const DENSITY: f32 = 5.0;

// ANCHOR: grid_resolution
/// How many cells a grid has along each axis: about λ per shape in all, and each cell about a cube.
///
/// With N shapes in a box of extents e and volume V, a cube of volume V/(λN) is one cell, so axis i has
/// nᵢ = eᵢ·∛(λN/V) of them, rounded. An axis along which the box is thinner than such a cube has one cell and is left out:
/// the others then share λN cells between them, with the square root of an area, or with a length.
pub fn grid_resolution(extents: Vec3, shapes: usize, density: f32) -> UVec3 {
    let cells = density * shapes as f32;
    let mut thick: Vec<usize> = (0..3).filter(|&axis| extents[axis] > 0.0).collect();
    loop {
        // One root after the other, for a volume can be too large or too small for a number.
        let root = |x: f32| x.powf(1.0 / thick.len() as f32);
        let per_metre: f32 = thick
            .iter()
            .map(|&axis| 1.0 / root(extents[axis]))
            .product();
        // No axis has more cells than there are in all; a product of tiny extents may say ∞.
        let along = (extents * root(cells) * per_metre).min(Vec3::splat(cells.max(1.0)));
        let before = thick.len();
        thick.retain(|&axis| along[axis] >= 1.0);
        if thick.len() == before {
            let along = [0, 1, 2].map(|axis| {
                if thick.contains(&axis) {
                    along[axis]
                } else {
                    1.0
                }
            });
            return Vec3::from(along).round().max(Vec3::ONE).as_uvec3();
        }
    }
}
// ANCHOR_END: grid_resolution

//! The number of cells of a grid.

use glam::{UVec3, Vec3};

/// Default λ: cells per shape.
///
/// Measured on the Stanford bunny, with λ from 2.5 to 40. For rays from a camera, 2.5 to 20 make no difference. Rays from the
/// surface are fastest at 10, and take a seventh longer at 5. Rays from anywhere to anywhere are fastest at 2.5, because more
/// cells are more memory to wait for, and take a sixth longer at 5. So 5 is a compromise; chapter 8 draws such a measurement.
pub(crate) const DENSITY: f32 = 5.0;

// ANCHOR: grid_resolution
/// The number of cells of a grid along each axis: about λ = `density` cells per shape in all, and each cell about a cube.
///
/// With N shapes in a box of extents e (in metres) and volume V, a cell is a cube of volume V/(λN), so axis i has
/// nᵢ = eᵢ·∛(λN/V) cells, rounded (Wald, Ize, Kensler, Knoll and Parker 2006). An axis along which the box is thinner than such
/// a cube has one cell and is left out: the other axes then share λN cells, with the square root and the area of a rectangle,
/// or with a length.
pub fn grid_resolution(extents: Vec3, shapes: usize, density: f32) -> UVec3 {
    let cells = density * shapes as f32;
    let mut thick: Vec<usize> = (0..3).filter(|&axis| extents[axis] > 0.0).collect();
    loop {
        // The product of roots, not the root of the product: a volume can be too large or too small for an `f32`.
        let root = |x: f32| x.powf(1.0 / thick.len() as f32);
        let per_metre: f32 = thick
            .iter()
            .map(|&axis| 1.0 / root(extents[axis]))
            .product();
        // No axis has more cells than the whole grid; with tiny extents the product may be ∞.
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

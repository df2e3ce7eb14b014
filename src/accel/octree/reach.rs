//! Which of eight cells a shape reaches.
//!
//! ```
//! use glam::vec3;
//! use raybook::accel::octree::reach::{by_bounds, by_triangle};
//! use raybook::inside::octree::child_cell;
//! use raybook::math::aabb::Aabb;
//! use raybook::shape::mesh::Facet;
//!
//! let cell = Aabb::new(vec3(-1.0, -1.0, -1.0), vec3(1.0, 1.0, 1.0));
//! let cells = std::array::from_fn(|i| child_cell(&cell, i));
//! let corners = [vec3(-0.5, -0.5, 0.5), vec3(0.3, -0.5, 0.5), vec3(-0.5, 0.3, 0.5)];
//! let facet = Facet { corners, id: 0 };
//! assert_eq!(by_bounds(&facet, &cells).count_ones(), 4); // of the upper four cells, its box reaches all
//! assert_eq!(by_triangle(&facet, &cells).count_ones(), 3); // the triangle itself does not reach one
//! ```

use crate::accel::overlap::Separation;
use crate::math::aabb::Aabb;
use crate::shape::{Shape, mesh::Facet};
use glam::Vec3;

/// The cells that the shape's bounding box reaches or touches, one bit each.
pub fn by_bounds<S: Shape>(shape: &S, cells: &[Aabb; 8]) -> u8 {
    let Aabb { min, max } = shape.bounds();
    bits(0b1111_1111, |i| {
        min.cmple(cells[i].max).all() && cells[i].min.cmple(max).all()
    })
}

/// The cells that the triangle itself reaches or touches, up to rounding, one bit each.
pub fn by_triangle(facet: &Facet, cells: &[Aabb; 8]) -> u8 {
    let by_bounds = by_bounds(facet, cells);
    if by_bounds.is_power_of_two() {
        return by_bounds;
    }
    // The eight cells have one size, but for the rounding of their planes.
    let half = cells
        .iter()
        .fold(Vec3::ZERO, |half, cell| half.max(0.5 * cell.size()));
    let planes = cells[0].min.abs().max(cells[7].max.abs());
    let separation = Separation::new(&facet.corners, half + f32::EPSILON * planes);
    bits(by_bounds, |i| !separation.separates(cells[i].center()))
}

/// The bits `of` without those for which `keep` is false.
fn bits(of: u8, keep: impl Fn(usize) -> bool) -> u8 {
    (0..8)
        .filter(|&i| of >> i & 1 != 0 && keep(i))
        .fold(0, |bits, i| bits | 1 << i)
}

//! How far a cell looks beyond its planes, so that no hit is lost to rounding.

use crate::math::{aabb::Aabb, domain::SMALLEST, ray::Ray};

/// How far a cell must look beyond its planes, in metres, in a structure with these bounds.
///
/// To a hit test, a shape seems moved by a few roundings of its distance; to a walk, so do the planes. So a hit may lie just
/// outside the cell that holds the shape. Therefore a shape is put into all cells that are within this margin.
/// 2⁻¹³ of the extent is about a hundredth of a usual cell, and is enough for rays that start up to 200 extents away
/// ([`is_too_far`]); 2⁻²¹ of the coordinates is 4 steps from one `f32` to the next.
pub(super) fn margin(bounds: &Aabb) -> f32 {
    let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
    let extent = bounds.size().max_element();
    extent / 8192.0 + 4.0 * f32::EPSILON * largest + SMALLEST / 8192.0
}

/// Whether a ray starts so far away that rounding moves hits by more than the margin.
///
/// A hit test computes with p − o, which is rounded by 2⁻²⁴ of its size; so are about 8 results after it. If their sum is more
/// than the margin, a shape can be hit outside all cells that hold it: then every shape must be tested.
pub(super) fn is_too_far(ray: &Ray, bounds: &Aabb, margin: f32) -> bool {
    const ROUNDINGS: f32 = 8.0 * (f32::EPSILON / 2.0);
    let away = (ray.origin - bounds.center()).abs() + 0.5 * bounds.size();
    ROUNDINGS * away.max_element() > margin
}

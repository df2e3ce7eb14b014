//! How far a cell looks beyond its planes, so that no hit is lost to rounding.

use crate::math::{aabb::Aabb, domain::SMALLEST, ray::Ray};

/// What a cell must look beyond its planes, in metres, in a structure with these bounds.
///
/// A hit test sees a shape moved by a few roundings of its distance, and a walk sees planes moved likewise: a hit can be found,
/// by a hair, in the cell next to the one that holds the shape. So a shape is put into all cells that are this near to it.
/// 2⁻¹³ of the extent is a hundredth of a usual cell, and is enough for rays that start up to 200 extents away
/// ([`is_too_far`]); 2⁻²¹ of the coordinates is 4 steps from one `f32` to the next.
pub(super) fn margin(bounds: &Aabb) -> f32 {
    let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
    let extent = bounds.size().max_element();
    extent / 8192.0 + 4.0 * f32::EPSILON * largest + SMALLEST / 8192.0
}

/// Whether a ray starts so far away that rounding moves hits by more than the margin.
///
/// A hit test computes with p − o, which is rounded by 2⁻²⁴ of its size, and so are about 8 results after it. Once that is
/// more than the margin, a shape can be hit where it is in no cell: then only asking every shape is right.
pub(super) fn is_too_far(ray: &Ray, bounds: &Aabb, margin: f32) -> bool {
    const ROUNDINGS: f32 = 8.0 * (f32::EPSILON / 2.0);
    let away = (ray.origin - bounds.center()).abs() + 0.5 * bounds.size();
    ROUNDINGS * away.max_element() > margin
}

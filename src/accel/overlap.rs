//! Whether a triangle reaches into a box.

use crate::math::aabb::Aabb;
use glam::Vec3;

/// A triangle made ready to be tested against many boxes of one size.
///
/// Two convex bodies do not meet if and only if there is a direction along which one lies beyond the other, and for a
/// triangle and a box it suffices to try 13 (Akenine-Möller 2001): the normals of the box, which compare the box with
/// the triangle's bounds; the triangle's normal; and the 9 products of an edge of the one and an edge of the other.
/// This type has the last 10. Along a direction a, the triangle covers the interval from min a·pᵢ to max a·pᵢ, and a box
/// with centre c and half its extents h the interval a·c ± |a|·h.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Separation {
    /// p₀: all is measured from here, so that numbers are as small as the triangle.
    origin: Vec3,
    /// Directions a, and the least and the greatest a·(c − p₀) of a box that the triangle reaches.
    directions: [(Vec3, f32, f32); 10],
}

/// a·(c − p₀) has at most 5 roundings in a row, each of 2⁻²⁴ of a term; so has a·(pᵢ − p₀), and there is the sum |a|·h.
const SLACK: f32 = 16.0 * (f32::EPSILON / 2.0);

impl Separation {
    /// A triangle, and half the extents of the boxes.
    pub(crate) fn new(corners: &[Vec3; 3], half: Vec3) -> Self {
        let [p0, p1, p2] = *corners;
        // Scaled, so that no product of edges overflows or vanishes.
        let edges =
            [p1 - p0, p2 - p1, p0 - p2].map(|e| e / e.abs().max_element().max(f32::MIN_POSITIVE));
        let [x, y, z] = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| edges.map(|edge| axis.cross(edge)));
        let normal = edges[0].cross(edges[1]);
        let directions = [x[0], x[1], x[2], y[0], y[1], y[2], z[0], z[1], z[2], normal];
        let bounds = Aabb::of(corners.map(|p| p - p0));
        let reach = bounds.size() + half;
        Self {
            origin: p0,
            directions: directions.map(|a| {
                let [q0, q1, q2] = corners.map(|p| a.dot(p - p0));
                let radius = a.abs().dot(half) + SLACK * a.abs().dot(reach);
                let (least, greatest) = (q0.min(q1).min(q2), q0.max(q1).max(q2));
                (a, least - radius, greatest + radius)
            }),
        }
    }

    /// Whether one of the directions separates the triangle from the box around this centre.
    ///
    /// A yes is certain. A no means that they meet, or nearly do, if the box meets the bounds of the triangle.
    pub(crate) fn separates(&self, center: Vec3) -> bool {
        let c = center - self.origin;
        self.directions.iter().any(|&(a, least, greatest)| {
            let place = a.dot(c);
            // False for a NaN, which says nothing.
            place < least || place > greatest
        })
    }
}

/// Whether a triangle reaches into a box or touches it; by rounding, a yes may be wrong by a hair, a no never is.
pub fn triangle_meets_box(corners: &[Vec3; 3], bounds: &Aabb) -> bool {
    let around = Aabb::of(*corners);
    if bounds.max.cmplt(around.min).any() || bounds.min.cmpgt(around.max).any() {
        return false;
    }
    let center = bounds.center();
    let half = (bounds.max - center).max(center - bounds.min);
    !Separation::new(corners, half).separates(center)
}

//! The overlap of a triangle and a box, by separating axes.

use crate::math::aabb::Aabb;
use glam::Vec3;

/// A triangle, prepared for tests against many boxes of one size.
///
/// Two convex bodies do not meet if and only if there is a direction along which one is entirely beyond the other: a separating
/// axis. For a triangle and a box it suffices to try 13 (Akenine-Möller, "Fast 3D triangle-box overlap testing", 2001): the 3
/// normals of the box, which compare the box with the triangle's bounds; the triangle's normal; and the 9 cross products of an
/// edge of the box and an edge of the triangle. This type has the last 10. Along a direction a, the triangle covers the interval
/// from min a·pᵢ to max a·pᵢ, and a box with centre c and half extents h covers the interval a·c ± |a|·h.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Separation {
    /// p₀: all places are relative to this corner, so that numbers are as small as the triangle.
    origin: Vec3,
    /// Directions a, and the least and the greatest a·(c − p₀) of a box that the triangle reaches.
    directions: [(Vec3, f32, f32); 10],
}

/// The bound on rounding: a·(c − p₀) has at most 5 roundings in a row, each of 2⁻²⁴ of a term, a·(pᵢ − p₀) has as many, and the
/// sum |a|·h has a few.
const SLACK: f32 = 16.0 * (f32::EPSILON / 2.0);

impl Separation {
    /// Prepares a triangle, for boxes with the half extents `half`, in metres.
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

    /// Whether one of the 10 directions separates the triangle from the box around this centre.
    ///
    /// `true` is certain. `false` means: if the box meets the bounds of the triangle, the triangle meets the box, up to rounding.
    pub(crate) fn separates(&self, center: Vec3) -> bool {
        let c = center - self.origin;
        self.directions.iter().any(|&(a, least, greatest)| {
            let place = a.dot(c);
            // False for a NaN, which separates nothing.
            place < least || place > greatest
        })
    }
}

/// Whether a triangle reaches into a box or touches it. A `false` is certain; a `true` may be wrong by rounding errors.
pub fn triangle_meets_box(corners: &[Vec3; 3], bounds: &Aabb) -> bool {
    let around = Aabb::of(*corners);
    if bounds.max.cmplt(around.min).any() || bounds.min.cmpgt(around.max).any() {
        return false;
    }
    let center = bounds.center();
    let half = (bounds.max - center).max(center - bounds.min);
    !Separation::new(corners, half).separates(center)
}

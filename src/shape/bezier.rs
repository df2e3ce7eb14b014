//! The bicubic Bézier patch: a curved surface with sixteen control points.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::shape::bezier::Patch;
//!
//! // A flat patch with evenly spaced control points: u runs along z, v along x.
//! let rows = std::array::from_fn(|i| std::array::from_fn(|j| vec3(j as f32, 0.0, i as f32)));
//! let patch = Patch { rows };
//! assert_eq!(patch.point(0.0, 1.0), vec3(3.0, 0.0, 0.0)); // a corner is a control point
//! assert_eq!(patch.point(0.5, 0.5), vec3(1.5, 0.0, 1.5));
//! ```

use crate::math::dir3::Dir3;
use glam::Vec3;

/// A patch of the points p(u, v), u and v in [0, 1], from four rows of four control points.
///
/// The patch passes through the control points at its four corners. The other control points pull it towards them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Patch {
    /// The rows of control points: u runs from the first row to the last, v along each row.
    pub rows: [[Vec3; 4]; 4],
}

impl Patch {
    // ANCHOR: patch_point
    /// p(u, v): each row is a curve; the curves' points at v are the control points of a curve along u.
    pub fn point(&self, u: f32, v: f32) -> Vec3 {
        curve(self.rows.map(|row| curve(row, v)), u)
    }
    // ANCHOR_END: patch_point

    // ANCHOR: patch_normal
    /// The normal ∂p/∂v × ∂p/∂u, normalised.
    ///
    /// If all control points of the first or last row are the same point, a pole, ∂p/∂v is 0 there. Next to the pole, inside the
    /// patch, ∂p/∂v is parallel to ± ∂²p/∂u∂v, which is used instead. `None` if this gives no direction either.
    pub fn normal(&self, u: f32, v: f32) -> Option<Dir3> {
        let along_u = tangent(self.rows.map(|row| curve(row, v)), u);
        let along_v = curve(self.rows.map(|row| tangent(row, v)), u);
        let twist = tangent(self.rows.map(|row| tangent(row, v)), u);
        let inward = if u < 0.5 { 1.0 } else { -1.0 };
        Dir3::new(along_v.cross(along_u)).or_else(|| Dir3::new(inward * twist.cross(along_u)))
    }
    // ANCHOR_END: patch_normal
}

/// The cubic Bézier curve r³·p₀ + 3r²t·p₁ + 3rt²·p₂ + t³·p₃ with r = 1 − t.
///
/// The four weights add up to 1, so it suffices to weight the differences from the nearer end. The result is exact at both ends,
/// so that neighbouring patches fit without a gap, and exact if all points are the same.
fn curve([p0, p1, p2, p3]: [Vec3; 4], t: f32) -> Vec3 {
    if t > 0.5 {
        return curve([p3, p2, p1, p0], 1.0 - t);
    }
    let r = 1.0 - t;
    p0 + 3.0 * r * r * t * (p1 - p0) + 3.0 * r * t * t * (p2 - p0) + t * t * t * (p3 - p0)
}

/// The derivative of [`curve`], 3r²·(p₁ − p₀) + 6rt·(p₂ − p₁) + 3t²·(p₃ − p₂): exactly 0 if all points are the same.
fn tangent([p0, p1, p2, p3]: [Vec3; 4], t: f32) -> Vec3 {
    let r = 1.0 - t;
    3.0 * r * r * (p1 - p0) + 6.0 * r * t * (p2 - p1) + 3.0 * t * t * (p3 - p2)
}

//! The bicubic Bézier patch: a curved surface from sixteen points.

use crate::math::dir3::Dir3;
use glam::Vec3;

/// The points p(u, v) with u and v in [0, 1], from four rows of four control points.
///
/// It passes through the control points at its four corners; the others pull it towards them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Patch {
    /// The rows: u leads from the first to the last, v along each.
    pub rows: [[Vec3; 4]; 4],
}

impl Patch {
    // ANCHOR: patch_point
    /// p(u, v): each row is a curve, whose points at v are the control points of a curve along u.
    pub fn point(&self, u: f32, v: f32) -> Vec3 {
        curve(self.rows.map(|row| curve(row, v)), u)
    }
    // ANCHOR_END: patch_point

    // ANCHOR: patch_normal
    /// The normal ∂p/∂v × ∂p/∂u, normalised.
    ///
    /// Where all of a row is one point, a pole, ∂p/∂v is 0; next to it, inside the patch, ∂p/∂v points along ± ∂²p/∂u∂v.
    /// `None` where that does not help either.
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
/// The four weights add up to 1, so only differences from the nearer end are weighed. That is exact where it matters:
/// at both ends, so that neighbouring patches fit without a gap, and where all points are the same.
fn curve([p0, p1, p2, p3]: [Vec3; 4], t: f32) -> Vec3 {
    if t > 0.5 {
        return curve([p3, p2, p1, p0], 1.0 - t);
    }
    let r = 1.0 - t;
    p0 + 3.0 * r * r * t * (p1 - p0) + 3.0 * r * t * t * (p2 - p0) + t * t * t * (p3 - p0)
}

/// Its derivative, 3r²·(p₁ − p₀) + 6rt·(p₂ − p₁) + 3t²·(p₃ − p₂): exactly 0 if all points are the same.
fn tangent([p0, p1, p2, p3]: [Vec3; 4], t: f32) -> Vec3 {
    let r = 1.0 - t;
    3.0 * r * r * (p1 - p0) + 6.0 * r * t * (p2 - p1) + 3.0 * t * t * (p3 - p2)
}

//! A plane in space, in which a drawing shows what happens.

use glam::{DVec2, DVec3, dvec2};

/// A plane by a point in it and two perpendicular unit vectors: `u` to the drawing's right, `v` upwards.
#[derive(Clone, Copy, Debug)]
pub struct Section {
    /// The point that becomes (0, 0).
    pub origin: DVec3,
    /// To the right.
    pub u: DVec3,
    /// Upwards.
    pub v: DVec3,
}

impl Section {
    /// The plane through a point along `right`, with the direction `toward` in its upper half.
    pub fn spanned(origin: DVec3, right: DVec3, toward: DVec3) -> Self {
        let u = right.normalize_or(DVec3::X);
        let across = toward - toward.dot(u) * u;
        let is_parallel = across.length() <= 1e-9 * toward.length();
        // Any plane shows two parallels.
        let v = if is_parallel {
            u.any_orthonormal_vector()
        } else {
            across.normalize()
        };
        Self { origin, u, v }
    }

    /// Where a point of space is, seen along the plane's normal.
    pub fn at(&self, p: DVec3) -> DVec2 {
        self.along(p - self.origin)
    }

    /// A direction, seen along the plane's normal.
    pub fn along(&self, d: DVec3) -> DVec2 {
        dvec2(d.dot(self.u), d.dot(self.v))
    }
}

//! Two directions perpendicular to a given one.
//!
//! ```
//! use raybook::math::{basis::Basis, dir3::Dir3};
//!
//! let basis = Basis::around(Dir3::Y);
//! assert_eq!(basis.x.cross(*basis.y), *Dir3::Y); // right-handed: x × y = z
//! ```

use crate::math::dir3::Dir3;
use glam::{Vec3, vec3};

/// Three perpendicular directions with x × y = z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Basis {
    /// The first tangent.
    pub x: Dir3,
    /// The second tangent.
    pub y: Dir3,
    /// The direction the basis was built around.
    pub z: Dir3,
}

impl Basis {
    /// A basis whose z is the given direction, computed without a branch, for every direction
    /// (Duff et al., "Building an orthonormal basis, revisited", 2017).
    #[inline]
    pub fn around(z: Dir3) -> Self {
        let sign = 1.0_f32.copysign(z.z);
        let a = -1.0 / (sign + z.z);
        let b = z.x * z.y * a;
        let x = vec3(1.0 + sign * z.x * z.x * a, sign * b, -sign * z.x);
        let y = vec3(b, sign + z.y * z.y * a, -z.y);
        Self {
            x: Dir3::of_length_1(x),
            y: Dir3::of_length_1(y),
            z,
        }
    }

    /// The vector in world coordinates for the coordinates v in this basis: x·v.x + y·v.y + z·v.z.
    #[inline]
    pub fn to_world(&self, v: Vec3) -> Vec3 {
        v.x * *self.x + v.y * *self.y + v.z * *self.z
    }
}

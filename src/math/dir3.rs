//! A direction: a vector that has length 1 by construction.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let toward = Dir3::new(vec3(3.0, 4.0, 0.0)).expect("longer than 0");
//! assert!((toward.x - 0.6).abs() < 1e-6 && (toward.length() - 1.0).abs() < 1e-6);
//! assert!(Dir3::new(Vec3::ZERO).is_none()); // 0 has no direction
//! ```

use glam::Vec3;
use std::ops::{Deref, Neg};

/// A direction: a [`Vec3`] of length 1.
///
/// Code that gets a `Dir3` need not check that it is normalised. Therefore a ray's parameter is a distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dir3(Vec3);

impl Dir3 {
    /// The world's x axis.
    pub const X: Self = Self(Vec3::X);
    /// The world's y axis, which points up.
    pub const Y: Self = Self(Vec3::Y);
    /// The world's z axis. The world is right-handed: if x points to the right and y up, z points towards the viewer.
    pub const Z: Self = Self(Vec3::Z);

    // ANCHOR: direction
    /// v/|v|, or `None` where v has no direction: zero, infinite or NaN.
    ///
    /// v is first divided by its largest component, so that no square overflows or vanishes:
    /// a vector of length 1e-30 has a direction too, though its square is 0 in `f32`.
    #[inline]
    pub fn new(v: Vec3) -> Option<Self> {
        let largest = v.abs().max_element();
        let usable = largest > 0.0 && v.is_finite();
        usable.then(|| Self((v / largest).normalize()))
    }
    // ANCHOR_END: direction

    /// v as a direction, where a formula has given it length 1, up to rounding.
    #[inline]
    pub(crate) fn of_length_1(v: Vec3) -> Self {
        debug_assert!((v.length_squared() - 1.0).abs() < 1e-5, "{v} has length 1");
        Self(v)
    }

    /// v/|v|, or `otherwise` where v has no direction.
    #[inline]
    pub fn new_or(v: Vec3, otherwise: Self) -> Self {
        Self::new(v).unwrap_or(otherwise)
    }
}

impl Deref for Dir3 {
    type Target = Vec3;

    #[inline]
    fn deref(&self) -> &Vec3 {
        &self.0
    }
}

impl Neg for Dir3 {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

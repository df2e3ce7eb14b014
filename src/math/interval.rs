//! The interval of distances along a ray in which a hit counts.
//!
//! ```
//! use raybook::prelude::*;
//!
//! assert!(!Interval::AHEAD.contains(0.0)); // a ray does not hit the surface on which it starts
//! let nearer = Interval::AHEAD.before(3.0); // after a hit at 3 m, only nearer hits count
//! assert!(nearer.contains(2.0) && !nearer.contains(3.0));
//! ```

/// An open interval of distances along a ray: min < t < max, in metres.
///
/// It is open at both ends: a ray that starts on a surface does not hit the surface at t = 0,
/// and of two hits at the same distance the one that was found first is kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Hits at or before this distance do not count.
    pub min: f32,
    /// Hits at or beyond this distance do not count.
    pub max: f32,
}

impl Interval {
    /// Everything ahead of the ray's origin: 0 < t < ∞.
    pub const AHEAD: Self = Self::new(0.0, f32::INFINITY);

    /// The distances min < t < max.
    pub const fn new(min: f32, max: f32) -> Self {
        Self { min, max }
    }

    /// Whether min < t < max; `false` for NaN.
    #[inline]
    pub fn contains(&self, t: f32) -> bool {
        self.min < t && t < self.max
    }

    /// The same interval, but ending at t: what is left after a hit at t.
    #[must_use]
    #[inline]
    pub fn before(&self, t: f32) -> Self {
        Self { max: t, ..*self }
    }
}

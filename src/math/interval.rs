//! The stretch of a ray on which an answer counts.

/// An open interval of distances along a ray: min < t < max, in metres.
///
/// Open at both ends: a ray that starts on a surface does not hit it at t = 0,
/// and of two hits at the same distance the one found first stays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Nothing at or before this distance counts.
    pub min: f32,
    /// Nothing at or beyond this distance counts.
    pub max: f32,
}

impl Interval {
    /// Everything ahead of the ray's origin: 0 < t < ∞.
    pub const AHEAD: Self = Self::new(0.0, f32::INFINITY);

    /// The distances min < t < max.
    pub const fn new(min: f32, max: f32) -> Self {
        Self { min, max }
    }

    /// Whether t counts; never for NaN.
    #[inline]
    pub fn contains(&self, t: f32) -> bool {
        self.min < t && t < self.max
    }

    /// The same interval, ending at t: what is left once something was hit there.
    #[must_use]
    #[inline]
    pub fn before(&self, t: f32) -> Self {
        Self { max: t, ..*self }
    }
}

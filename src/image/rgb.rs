//! A colour with a physical meaning: radiance in three channels.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let light = Rgb::new(1.0, 0.5, 0.0);
//! assert_eq!(light * Rgb::new(0.5, 0.5, 0.5), Rgb::new(0.5, 0.25, 0.0)); // an albedo is applied channel by channel
//! assert!(Rgb::new(0.0, 1.0, 0.0).luminance() > 9.0 * Rgb::new(0.0, 0.0, 1.0).luminance()); // green is bright
//! ```

use std::iter::Sum;
use std::ops::{Add, AddAssign, Div, Mul};

/// Radiance (W·m⁻²·sr⁻¹) in the red, green and blue of the sRGB primaries; linear and without an upper limit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rgb {
    /// Red.
    pub r: f32,
    /// Green.
    pub g: f32,
    /// Blue.
    pub b: f32,
}

impl Rgb {
    /// No light.
    pub const BLACK: Self = Self::gray(0.0);
    /// One in every channel: the brightest colour that a display can show.
    pub const WHITE: Self = Self::gray(1.0);

    /// A colour from its channels.
    pub const fn new(r: f32, g: f32, b: f32) -> Self {
        Self { r, g, b }
    }

    /// The same radiance in every channel.
    pub const fn gray(v: f32) -> Self {
        Self::new(v, v, v)
    }

    /// The channels in order: red, green, blue.
    pub const fn channels(self) -> [f32; 3] {
        [self.r, self.g, self.b]
    }

    /// The colour with f applied to each channel.
    #[must_use]
    #[inline]
    pub fn map(self, f: impl Fn(f32) -> f32) -> Self {
        Self::new(f(self.r), f(self.g), f(self.b))
    }

    /// The luminance, the brightness for the eye: Y = 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709).
    #[inline]
    pub fn luminance(self) -> f32 {
        0.2126 * self.r + 0.7152 * self.g + 0.0722 * self.b
    }

    /// The largest channel.
    pub fn max_channel(self) -> f32 {
        self.r.max(self.g).max(self.b)
    }

    /// The colour a fraction x of the way from self to other: (1 − x)·self + x·other.
    #[must_use]
    #[inline]
    pub fn lerp(self, other: Self, x: f32) -> Self {
        self * (1.0 - x) + other * x
    }
}

impl Add for Rgb {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.r + other.r, self.g + other.g, self.b + other.b)
    }
}

impl AddAssign for Rgb {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Mul for Rgb {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::new(self.r * other.r, self.g * other.g, self.b * other.b)
    }
}

impl Mul<f32> for Rgb {
    type Output = Self;
    #[inline]
    fn mul(self, scale: f32) -> Self {
        self.map(|v| v * scale)
    }
}

impl Div<f32> for Rgb {
    type Output = Self;
    #[inline]
    fn div(self, divisor: f32) -> Self {
        self.map(|v| v / divisor)
    }
}

impl Sum for Rgb {
    fn sum<I: Iterator<Item = Self>>(colours: I) -> Self {
        colours.fold(Self::BLACK, Add::add)
    }
}

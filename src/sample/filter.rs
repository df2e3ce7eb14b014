//! Reconstruction filters: the weight of a sample for a pixel, by the sample's place.
//!
//! ```
//! use glam::vec2;
//! use raybook::sample::filter::Filter;
//!
//! assert_eq!(Filter::TENT.weight(vec2(0.5, 0.0)), 0.5);
//! assert_eq!(Filter::BOX.weight(vec2(0.6, 0.0)), 0.0); // outside the pixel
//! assert!(Filter::MITCHELL.weight(vec2(1.5, 0.0)) < 0.0); // sharpens
//! ```

use crate::image::rgb::Rgb;
use glam::Vec2;

/// A separable filter w(x, y) = f(x/r)·f(y/r), with x and y in pixels from the pixel's centre; 0 beyond the radius r along either
/// axis.
#[derive(Clone, Copy, Debug)]
pub struct Filter {
    /// The filter's name, for figures.
    pub name: &'static str,
    /// r, in pixels.
    pub radius: f32,
    /// f, on [−1, 1); `None` for 1. A constant factor does not matter, because weights are divided by their sum.
    pub profile: Option<fn(f32) -> f32>,
}

impl Filter {
    /// The box filter: all samples in the pixel count equally, and no others.
    pub const BOX: Self = Self {
        name: "box",
        radius: 0.5,
        profile: None,
    };
    /// The tent filter, 1 − |t|: the weight falls linearly.
    pub const TENT: Self = Self {
        name: "tent",
        radius: 1.0,
        profile: Some(|t| 1.0 - t.abs()),
    };
    /// A Gaussian bell of standard deviation r/3 = ½ pixel, lowered to end at 0.
    pub const GAUSSIAN: Self = Self {
        name: "Gaussian",
        radius: 1.5,
        profile: Some(|t| (-4.5 * t * t).exp() - (-4.5_f32).exp()),
    };
    /// Mitchell's cubic: sharper than a Gaussian, because weights beyond the next pixel's centre are negative.
    pub const MITCHELL: Self = Self {
        name: "Mitchell",
        radius: 2.0,
        profile: Some(|t| mitchell(2.0 * t)),
    };
    /// All four filters.
    pub const ALL: [Self; 4] = [Self::BOX, Self::TENT, Self::GAUSSIAN, Self::MITCHELL];

    /// Number of pixels on each side of a pixel whose samples also count: 0 if the filter is no wider than a pixel.
    pub fn reach(&self) -> usize {
        (self.radius - 0.5).ceil().max(0.0) as usize
    }

    /// Whether the samples of a pixel count for it alike, and for no other.
    pub fn is_box(&self) -> bool {
        self.radius == 0.5 && self.profile.is_none()
    }

    /// The weight w of a sample at `offset` from the pixel's centre, in pixels.
    pub fn weight(&self, offset: Vec2) -> f32 {
        let t = offset / self.radius;
        // Half open, so that a sample on the edge between two pixels belongs to one of them.
        let inside = |t: f32| (-1.0..1.0).contains(&t);
        if inside(t.x) && inside(t.y) {
            self.profile.map_or(1.0, |f| f(t.x) * f(t.y))
        } else {
            0.0
        }
    }
}

/// The cubic filter with B = C = ⅓ (Mitchell and Netravali, "Reconstruction filters in computer graphics", 1988).
fn mitchell(x: f32) -> f32 {
    let x = x.abs();
    if x < 1.0 {
        ((7.0 * x - 12.0) * x * x + 16.0 / 3.0) / 6.0
    } else {
        (((-7.0 / 3.0 * x + 12.0) * x - 20.0) * x + 32.0 / 3.0) / 6.0
    }
}

/// A sample: the radiance, and the place relative to a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// The place relative to the pixel's centre, in pixels.
    pub offset: Vec2,
    /// The radiance, in W·m⁻²·sr⁻¹.
    pub radiance: Rgb,
}

// ANCHOR: pixel_average
/// The pixel's radiance, Σ w L/Σ w: the average of the samples, weighted by the filter.
///
/// Black if the sum of the weights is 0.
pub fn pixel_average(filter: &Filter, samples: &[Sample]) -> Rgb {
    let (mut light, mut weights) = (Rgb::BLACK, 0.0);
    for sample in samples {
        let weight = filter.weight(sample.offset);
        light += sample.radiance * weight;
        weights += weight;
    }
    if weights == 0.0 {
        Rgb::BLACK
    } else {
        light / weights
    }
}
// ANCHOR_END: pixel_average

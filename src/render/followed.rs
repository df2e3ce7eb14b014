//! The radiance along a ray, and the number of rays that were followed for it, which measures a ray tracer's work.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::render::followed::Followed;
//!
//! let samples = [1.0, 3.0].map(|v| Followed { radiance: Rgb::gray(v), rays: 5 });
//! let pixel = samples.into_iter().sum::<Followed>().mean_of(2);
//! assert_eq!((pixel.radiance, pixel.rays), (Rgb::gray(2.0), 10)); // the mean, but all rays
//! ```

use crate::image::rgb::Rgb;
use std::iter::Sum;

/// Radiance, and the number of rays that it took.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Followed {
    /// The radiance, in W·m⁻²·sr⁻¹.
    pub radiance: Rgb,
    /// Number of rays that were followed for it, to surfaces and to lights.
    pub rays: u64,
}

impl Followed {
    /// The mean radiance of n samples of which this is the sum, and the rays of all n.
    #[must_use]
    pub fn mean_of(self, n: usize) -> Self {
        Self {
            radiance: self.radiance / n as f32,
            ..self
        }
    }
}

/// Radiance whose rays were not counted.
impl From<Rgb> for Followed {
    fn from(radiance: Rgb) -> Self {
        Self { radiance, rays: 0 }
    }
}

impl Sum for Followed {
    fn sum<I: Iterator<Item = Self>>(all: I) -> Self {
        all.fold(Self::default(), |sum, one| Self {
            radiance: sum.radiance + one.radiance,
            rays: sum.rays + one.rays,
        })
    }
}

//! What is seen along a ray, and the rays that were followed for it: the unit in which a ray tracer's work is told.

use crate::image::rgb::Rgb;
use std::iter::Sum;

/// Radiance, and its price.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Followed {
    /// What is seen, in W·m⁻²·sr⁻¹.
    pub radiance: Rgb,
    /// The rays that were followed for it: to surfaces, and to lights.
    pub rays: u64,
}

impl Followed {
    /// The mean of n of which this is the sum, and the rays of all of them.
    #[must_use]
    pub fn mean_of(self, n: usize) -> Self {
        Self {
            radiance: self.radiance / n as f32,
            ..self
        }
    }
}

/// Radiance whose rays nobody counted.
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

//! Whether a pixel has enough samples.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::render::needs_more::StoppingRule;
//!
//! let gray = |values: [f32; 3]| values.map(Rgb::gray);
//! assert!(!StoppingRule::BY_CONTRAST.needs_more(&gray([0.5, 0.5, 0.6])));
//! assert!(StoppingRule::BY_CONTRAST.needs_more(&gray([0.5, 0.5, 1.0]))); // (1 − 0.5)/(1 + 0.5) > 0.3
//! ```

use crate::image::rgb::Rgb;

/// When a pixel has enough samples: when both limits are kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StoppingRule {
    /// Maximum contrast per channel; ∞ for no limit.
    pub contrast: Rgb,
    /// Maximum standard error of the mean luminance, in W·m⁻²·sr⁻¹; ∞ for no limit.
    pub error: f32,
}

impl StoppingRule {
    /// By contrast alone, with the limits that suit the eye: it is most sensitive to green and least to blue (Mitchell,
    /// "Generating antialiased images at low sampling densities", 1987).
    pub const BY_CONTRAST: Self = Self {
        contrast: Rgb::new(0.4, 0.3, 0.6),
        error: f32::INFINITY,
    };

    /// By variance alone (Lee, Redner and Uselton, "Statistically optimized sampling for distributed ray tracing", 1985).
    pub const fn by_variance(error: f32) -> Self {
        Self {
            contrast: Rgb::gray(f32::INFINITY),
            error,
        }
    }

    // ANCHOR: needs_more
    /// Whether the samples differ so much that the pixel needs more of them.
    ///
    /// The contrast of a channel is (max − min)/(max + min), 0 if all are black. The standard error of the mean is s/√n, where
    /// s² = Σ (Y − mean)²/(n − 1) is the variance of the samples' luminance. Fewer than two samples always need more, because
    /// they show no difference.
    pub fn needs_more(&self, samples: &[Rgb]) -> bool {
        let n = samples.len() as f32;
        if samples.len() < 2 {
            return true;
        }
        let contrast = |channel: usize| {
            let values = samples.iter().map(|s| s.channels()[channel]);
            let (min, max) = values.fold((f32::INFINITY, 0.0_f32), |(min, max), v| {
                (min.min(v), max.max(v))
            });
            if max > 0.0 {
                (max - min) / (max + min)
            } else {
                0.0
            }
        };
        let limits = self.contrast.channels();
        if (0..3).any(|channel| contrast(channel) > limits[channel]) {
            return true;
        }
        let mean = samples.iter().map(|s| s.luminance()).sum::<f32>() / n;
        let squares: f32 = samples.iter().map(|s| (s.luminance() - mean).powi(2)).sum();
        (squares / (n - 1.0) / n).sqrt() > self.error
    }
    // ANCHOR_END: needs_more
}

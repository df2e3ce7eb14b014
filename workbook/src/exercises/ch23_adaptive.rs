//! Chapter 23: `needs_more`, `spend_budget`.

use crate::exercise::exercises;
use raybook::image::rgb::Rgb;
use raybook::render::{budget, needs_more::StoppingRule};

exercises! { ($) ch23_adaptive
    /// Return whether a pixel needs more samples: if there are fewer than two, if a channel's contrast (max − min)/(max
    /// + min) is above its limit, or if s/√n is above the error. Here s² = Σ (Y − mean)²/(n − 1) is the variance of the
    /// luminance Y = 0.2126 R + 0.7152 G + 0.0722 B.
    ///
    /// In Rust: true or false.
    NeedsMore: needs_more(
        /// The maximum contrast of each channel, without a unit; inf for no limit. The contrast of a channel that is
        /// black in all samples is 0.
        contrast: Rgb,
        /// The maximum standard error of the mean luminance, in the unit of the samples; inf for no limit.
        error: f32,
        /// The pixel's samples: radiance in W·m⁻²·sr⁻¹.
        samples: Vec<Rgb>,
    ) -> (
        /// 1 if the samples are not enough, else 0.
        more: u32,
    ) |q| {
        u32::from(q.enough().needs_more(&q.samples))
    }

    /// Return how many samples each pixel gets: all pixels together exactly the budget, and each pixel at least the
    /// minimum. The sum of σ²/n over the pixels is to be as small as it can be, where σ is a pixel's standard deviation
    /// and n its number of samples. A sum that is at most 3 % larger will do.
    SpendBudget: spend_budget(
        /// σ: the standard deviation of each pixel's samples, in any unit.
        deviations: Vec<f32>,
        /// The minimum number of samples for each pixel,
        least: u32 [1 or more],
        /// The number of samples for all pixels together, at least enough for the minimum.
        budget: u32,
    ) -> (
        /// The number of samples for each pixel, in their order.
        count: Vec<u32>,
    ) {
        budget::spend_budget(&deviations, least, budget)
    }
}

impl NeedsMore {
    /// The limits.
    pub fn enough(&self) -> StoppingRule {
        StoppingRule {
            contrast: self.contrast,
            error: self.error,
        }
    }
}

//! Chapter 23: `needs_more`, `spend_budget`.

use raybook::image::rgb::Rgb;
use raybook::render::{budget, needs_more::Enough};
use crate::exercise::{Asked, Exercise};
use crate::row::row;

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[&NeedsMore, &SpendBudget];

/// See [`Exercise::TASK`].
pub struct NeedsMore;

row! {
    /// A pixel's samples, and when they are enough.
    pub struct NeedsMoreQuestion {
        /// The largest contrast in each channel; inf for no limit.
        pub contrast: Rgb,
        /// The largest standard error of the mean luminance; inf for no limit.
        pub error: f32,
        /// The samples.
        pub samples: Vec<Rgb>,
    }
}

impl NeedsMoreQuestion {
    /// The limits.
    pub fn enough(&self) -> Enough {
        Enough {
            contrast: self.contrast,
            error: self.error,
        }
    }
}

impl Exercise for NeedsMore {
    type Question = NeedsMoreQuestion;
    type Answer = u32;
    const NAME: &'static str = "needs_more";
    const ANSWER: &'static str = "more";
    const TASK: &'static str = "Return whether a pixel's samples are not enough yet: true (a 1 in the answer) if there are fewer than two; or if in any channel (max − min)/(max + min), or 0 where all are black, is above that channel's contrast; or if s/√n is above the error, where s² = Σ (Y − mean)²/(n − 1) is the variance of the luminance Y = 0.2126 R + 0.7152 G + 0.0722 B; else false (a 0).";

    fn answer(q: &Self::Question) -> Self::Answer {
        u32::from(q.enough().needs_more(&q.samples))
    }
}

/// See [`Exercise::TASK`].
pub struct SpendBudget;

row! {
    /// How restless each pixel is, and how many samples there are.
    pub struct SpendBudgetQuestion {
        /// The standard deviation of each pixel's samples.
        pub deviations: Vec<f32>,
        /// At least so many samples for each pixel, 1 or more.
        pub least: u32,
        /// So many samples for all pixels together; at least enough for the least.
        pub budget: u32,
    }
}

impl Exercise for SpendBudget {
    type Question = SpendBudgetQuestion;
    type Answer = Vec<u32>;
    const NAME: &'static str = "spend_budget";
    const ANSWER: &'static str = "count";
    const TASK: &'static str = "Return how many samples each pixel gets, all of the budget together and at least the least for each, such that the sum over the pixels of σ²/n is as small as it can be, where σ is a pixel's deviation and n its number of samples; a sum that is at most 3 % larger will do.";

    fn answer(q: &Self::Question) -> Self::Answer {
        budget::spend_budget(&q.deviations, q.least, q.budget)
    }
}

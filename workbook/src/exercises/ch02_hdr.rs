//! Chapter 2: `expose`, `tone_map`, `encode_srgb`.

use raybook::image::{rgb::Rgb, tone};
use crate::exercise::{Asked, Exercise};
use crate::row::row;

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[&Expose, &ToneMap, &EncodeSrgb];

/// See [`Exercise::TASK`].
pub struct Expose;

row! {
    /// A radiance and an exposure.
    pub struct ExposeQuestion {
        /// The radiance.
        pub radiance: Rgb,
        /// How many stops; negative for less light.
        pub stops: f32,
    }
}

impl Exercise for Expose {
    type Question = ExposeQuestion;
    type Answer = Rgb;
    const NAME: &'static str = "expose";
    const ANSWER: &'static str = "exposed";
    const TASK: &'static str =
        "Return the radiance after an exposure of so many stops: one stop more is twice the light.";

    fn answer(q: &Self::Question) -> Self::Answer {
        tone::expose(q.radiance, q.stops)
    }
}

/// See [`Exercise::TASK`].
pub struct ToneMap;

row! {
    /// A radiance.
    pub struct ToneMapQuestion {
        /// The radiance.
        pub radiance: Rgb,
    }
}

impl Exercise for ToneMap {
    type Question = ToneMapQuestion;
    type Answer = Rgb;
    const NAME: &'static str = "tone_map";
    const ANSWER: &'static str = "mapped";
    const TASK: &'static str = "Return Reinhard's tone mapping: scale the colour so that its luminance L becomes L/(1 + L).";

    fn answer(q: &Self::Question) -> Self::Answer {
        tone::reinhard(q.radiance)
    }
}

/// See [`Exercise::TASK`].
pub struct EncodeSrgb;

row! {
    /// A linear value.
    pub struct EncodeSrgbQuestion {
        /// The linear value.
        pub v: f32,
    }
}

impl Exercise for EncodeSrgb {
    type Question = EncodeSrgbQuestion;
    type Answer = f32;
    const NAME: &'static str = "encode_srgb";
    const ANSWER: &'static str = "code";
    const TASK: &'static str = "Return the sRGB code value, from 0 to 1, of a linear value: 12.92 v up to 0.0031308, then 1.055 v^(1/2.4) − 0.055; values outside 0 to 1 are clamped.";

    fn answer(q: &Self::Question) -> Self::Answer {
        tone::encode_srgb(q.v)
    }
}

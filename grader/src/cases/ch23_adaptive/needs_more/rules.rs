//! Rules as students write them: with the contrast of something else, or with another error.

use crate::Graded;
use crate::cases::ch23_adaptive::measures::{decide, range, ratio, standard_error, too_contrasty};
use raybook::image::rgb::Rgb;
use raybook_workbook::exercises::ch23_adaptive::NeedsMore;

/// Whether the contrast of the luminance is above a limit, and the answer by that and the right error.
pub(super) fn of_luminance(q: &NeedsMore, limit: f32) -> u32 {
    let values = || q.samples.iter().map(|sample| sample.luminance());
    let (max, min) = (
        values().fold(0.0, f32::max),
        values().fold(f32::INFINITY, f32::min),
    );
    decide(q, ratio([max, min]) > limit, standard_error(q))
}

/// The samples of the least and of the greatest luminance, the first of several.
pub(super) fn darkest_and_brightest(q: &NeedsMore) -> Option<[&Rgb; 2]> {
    let by_luminance = |one: &&Rgb, other: &&Rgb| one.luminance().total_cmp(&other.luminance());
    let darkest = q.samples.iter().min_by(by_luminance)?;
    let brightest = q.samples.iter().rev().max_by(by_luminance)?;
    Some([darkest, brightest])
}

/// Whether a channel's contrast is above its limit in any two samples of those pairs.
pub(super) fn of_pairs(q: &NeedsMore, pairs: &[[&Rgb; 2]]) -> bool {
    let limits = q.contrast.channels();
    (0..3).any(|channel| {
        let is_above = |pair: &[&Rgb; 2]| {
            let [one, other] = pair.map(|s| s.channels()[channel]);
            ratio([one.max(other), one.min(other)]) > limits[channel]
        };
        pairs.iter().any(is_above)
    })
}

/// The standard error of one channel.
pub(super) fn error_of(q: &NeedsMore, channel: usize) -> f32 {
    let gray = |s: &Rgb| Rgb::gray(s.channels()[channel]);
    standard_error(&NeedsMore {
        samples: q.samples.iter().map(gray).collect(),
        ..q.clone()
    })
}

/// The answer by one limit for the contrast of all channels.
pub(super) fn by_one_limit(q: &NeedsMore, limit: f32) -> u32 {
    NeedsMore::misread(q, |q| q.contrast = Rgb::gray(limit))
}

/// The answer by another contrast of a channel, made of its largest value and its least, of the mean of its values, and of their standard
/// deviation; 0 for black.
pub(super) fn by_mean(q: &NeedsMore, contrast: impl Fn([f32; 2], f32, f32) -> f32) -> u32 {
    let samples = q.samples.len() as f32;
    let limits = q.contrast.channels();
    let is_above = |channel: usize| {
        let values = || q.samples.iter().map(|s| s.channels()[channel]);
        let mean = values().sum::<f32>() / samples;
        let squares: f32 = values().map(|v| (v - mean).powi(2)).sum();
        let deviation = (squares / (samples - 1.0)).sqrt();
        mean > 0.0 && contrast(range(q, channel), mean, deviation) > limits[channel]
    };
    decide(q, (0..3).any(is_above), standard_error(q))
}

/// The answer by another luminance.
pub(super) fn by_weights(q: &NeedsMore, [r, g, b]: [f32; 3]) -> u32 {
    let luminance = |s: &Rgb| Rgb::gray(r * s.r + g * s.g + b * s.b);
    let gray = NeedsMore {
        samples: q.samples.iter().map(luminance).collect(),
        ..q.clone()
    };
    decide(q, too_contrasty(q, ratio), standard_error(&gray))
}

/// The answer by a running variance, which adds something for each luminance from number `first` on, by its differences from the mean of those before
/// and from the mean with it. Right is their product (Welford 1962).
pub(super) fn running(q: &NeedsMore, first: usize, adds: fn(f32, f32) -> f32) -> u32 {
    let (mut mean, mut squares) = (0.0, 0.0);
    for (i, sample) in q.samples.iter().enumerate() {
        let luminance = sample.luminance();
        let before = luminance - mean;
        mean += before / (i + 1) as f32;
        if i >= first {
            squares += adds(before, luminance - mean);
        }
    }
    let n = q.samples.len() as f32;
    decide(q, too_contrasty(q, ratio), (squares / (n - 1.0) / n).sqrt())
}

//! The rule as it should be, by settings that students get wrong.

use crate::cases::ch23_adaptive::measures::{range, squares};
use crate::upon::changed;
use raybook::image::rgb::Rgb;
use raybook_workbook::exercises::ch23_adaptive::NeedsMore;

/// How it is decided whether a pixel needs more samples; one field wrong is a mistake.
#[derive(Clone, Copy)]
pub(super) struct How {
    /// Fewer samples than these always need more.
    pub(super) fewest: usize,
    /// The luminance of a sample.
    pub(super) luminance: Luminance,
    /// The groups of samples that are compared with each other.
    pub(super) groups: fn(samples: &[Rgb], luminance: Luminance) -> Vec<Vec<Rgb>>,
    /// What is compared of a group of samples, for the contrast of channel `i`.
    pub(super) values: fn(samples: &[Rgb], i: usize, luminance: Luminance) -> Vec<f32>,
    /// The largest and the least of the values.
    pub(super) range: fn(values: &[f32]) -> [f32; 2],
    /// The contrast of values that are not all black.
    pub(super) contrast: fn(of: Values) -> f32,
    /// The limits of the channels' contrasts, made of those of the question.
    pub(super) limits: fn(limits: [f32; 3]) -> [f32; 3],
    /// How many channels are looked at.
    pub(super) channels: usize,
    /// Whether a channel has too much contrast.
    pub(super) is_above: IsAbove,
    /// Whether the channels say that the samples are enough, before anything else is asked.
    pub(super) is_content: fn(channels: &[Channel], is_above: IsAbove) -> bool,
    /// Whether the channels say that more samples are needed.
    pub(super) is_contrasty: fn(channels: &[Channel], is_above: IsAbove) -> bool,
    /// By what the squares of the differences of `n` values from their mean are divided.
    pub(super) divisor: fn(n: f32) -> f32,
    /// The variance of some values.
    pub(super) variance: fn(values: &[f32], divisor: f32) -> f32,
    /// The standard error of the mean of `n` values.
    pub(super) error: fn(variance: f32, n: f32) -> f32,
    /// The standard error of the pixel; `error` is that of some values.
    pub(super) noise: fn(samples: &[Rgb], luminance: Luminance, error: ErrorOf<'_>) -> f32,
    /// The limit of the error, made of that of the question, where the samples have this `mean` luminance.
    pub(super) error_limit: fn(limit: f32, mean: f32) -> f32,
    /// Whether the error says that more samples are needed.
    pub(super) is_uncertain: fn(error: f32, limit: f32) -> bool,
    /// Whether more samples are needed, by what contrast and error say.
    pub(super) decide: fn(is_contrasty: bool, is_uncertain: bool) -> bool,
}

/// The standard error of the mean of some values.
type ErrorOf<'a> = &'a dyn Fn(&[f32]) -> f32;

/// How a sample's luminance is found.
pub(super) type Luminance = fn(sample: Rgb) -> f32;

/// How it is found whether a channel has too much contrast.
pub(super) type IsAbove = fn(channel: &Channel) -> bool;

/// What a contrast is made of.
pub(super) struct Values {
    pub(super) max: f32,
    pub(super) min: f32,
    pub(super) mean: f32,
    /// The standard deviation.
    pub(super) deviation: f32,
}

/// A channel of the samples, and what is allowed to it.
pub(super) struct Channel {
    pub(super) is_black: bool,
    pub(super) contrast: f32,
    pub(super) limit: f32,
}

/// As it should be.
const WELL: How = How {
    fewest: 2,
    luminance: Rgb::luminance,
    groups: |samples, _| vec![samples.to_vec()],
    values: channel,
    range,
    contrast: |of| (of.max - of.min) / (of.max + of.min),
    limits: |limits| limits,
    channels: 3,
    is_above: |channel| channel.contrast > channel.limit,
    is_content: |_, _| false,
    is_contrasty: |channels, is_above| channels.iter().any(is_above),
    divisor: |n| n - 1.0,
    variance: |values, divisor| squares(values) / divisor,
    error: |variance, n| (variance / n).sqrt(),
    noise: |samples, luminance, error| error(&luminances(samples, 0, luminance)),
    error_limit: |limit, _| limit,
    is_uncertain: |error, limit| error > limit,
    decide: |is_contrasty, is_uncertain| is_contrasty || is_uncertain,
};

/// The answer, decided rightly but for what is changed.
pub(super) fn decided(q: &NeedsMore, change: fn(&mut How)) -> u32 {
    let how = changed(WELL, change);
    if q.samples.len() < how.fewest {
        return 1;
    }
    let variance = |values: &[f32]| (how.variance)(values, (how.divisor)(values.len() as f32));
    let groups = (how.groups)(&q.samples, how.luminance);
    let limits = (how.limits)(q.contrast.channels()).into_iter();
    let channels = limits.enumerate().take(how.channels).map(|(i, limit)| {
        let of_group = |group: &Vec<Rgb>| {
            let values = (how.values)(group, i, how.luminance);
            let [max, min] = (how.range)(&values);
            let of = Values {
                max,
                min,
                mean: mean(&values),
                deviation: variance(&values).sqrt(),
            };
            (max > 0.0).then(|| (how.contrast)(of))
        };
        let contrasts: Vec<_> = groups.iter().map(of_group).collect();
        Channel {
            is_black: contrasts.iter().all(Option::is_none),
            contrast: contrasts.into_iter().flatten().fold(0.0, f32::max),
            limit,
        }
    });
    let channels: Vec<_> = channels.collect();
    if (how.is_content)(&channels, how.is_above) {
        return 0;
    }
    let error = |values: &[f32]| (how.error)(variance(values), values.len() as f32);
    let noise = (how.noise)(&q.samples, how.luminance, &error);
    let limit = (how.error_limit)(q.error, mean(&luminances(&q.samples, 0, how.luminance)));
    u32::from((how.decide)(
        (how.is_contrasty)(&channels, how.is_above),
        (how.is_uncertain)(noise, limit),
    ))
}

fn mean(values: &[f32]) -> f32 {
    values.iter().sum::<f32>() / values.len() as f32
}

/// The values of channel `i`.
pub(super) fn channel(samples: &[Rgb], i: usize, _: Luminance) -> Vec<f32> {
    samples.iter().map(|sample| sample.channels()[i]).collect()
}

/// The luminances, whatever the channel.
pub(super) fn luminances(samples: &[Rgb], _: usize, luminance: Luminance) -> Vec<f32> {
    samples.iter().copied().map(luminance).collect()
}

/// The values of all three channels.
pub(super) fn all_channels(samples: &[Rgb]) -> Vec<f32> {
    samples.iter().flat_map(|s| s.channels()).collect()
}

/// All channels as one, which is never black: the sum of the contrasts, and that of the limits.
pub(super) fn sum(channels: &[Channel]) -> Channel {
    Channel {
        is_black: false,
        contrast: channels.iter().map(|channel| channel.contrast).sum(),
        limit: channels.iter().map(|channel| channel.limit).sum(),
    }
}

/// Whether the first channel that is not black has too much contrast.
pub(super) fn first_decides(channels: &[Channel], is_above: IsAbove) -> bool {
    let first = channels.iter().find(|channel| !channel.is_black);
    first.is_some_and(is_above)
}

/// A group of the samples of the least and of the greatest luminance, the first of several.
pub(super) fn darkest_and_brightest(samples: &[Rgb], luminance: Luminance) -> Vec<Vec<Rgb>> {
    let by_luminance = |one: &&Rgb, other: &&Rgb| luminance(**one).total_cmp(&luminance(**other));
    let darkest = samples.iter().min_by(by_luminance);
    let brightest = samples.iter().rev().max_by(by_luminance);
    vec![darkest.into_iter().chain(brightest).copied().collect()]
}

/// A running sum, to which something is added for each value from number `first` on, by its differences from the mean of those before and from the
/// mean with it. Right is their product (Welford 1962).
pub(super) fn running(
    values: &[f32],
    first: usize,
    adds: fn(before: f32, after: f32) -> f32,
) -> f32 {
    let (mut mean, mut squares) = (0.0, 0.0);
    for (i, value) in values.iter().enumerate() {
        let before = value - mean;
        mean += before / (i + 1) as f32;
        if i >= first {
            squares += adds(before, value - mean);
        }
    }
    squares
}

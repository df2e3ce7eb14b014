//! `pixel_average`: random questions, judge and mistakes.

use crate::upon::changed;
use crate::{Graded, Mistake, Verdict, judge, sample};
use glam::{Vec2, vec2};
use rand::RngExt;
use raybook::image::rgb::Rgb;
use raybook::image::tone;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch22_antialiasing::{PixelAverage, Seen};

fn tent(q: &PixelAverage, offset: Vec2) -> f32 {
    let along = 1.0 - offset.abs() / q.radius;
    along.max(Vec2::ZERO).element_product()
}

/// How samples are weighed, and by what their sum is divided: the sum of the weights, if it is right.
#[derive(Clone, Copy)]
struct How {
    weight: Weight,
    divisor: fn(&PixelAverage, f32) -> f32,
}

/// A sample's weight.
type Weight = fn(&PixelAverage, &Seen) -> f32;

/// Σ w L/Σ w, but for what is changed.
fn changed_average(q: &PixelAverage, change: impl FnOnce(&mut How)) -> Rgb {
    let right = How {
        weight: |q, s| tent(q, s.offset),
        divisor: |_, weights| weights,
    };
    let How { weight, divisor } = changed(right, change);
    let weights: f32 = q.samples.iter().map(|s| weight(q, s)).sum();
    let divisor = divisor(q, weights);
    if divisor == 0.0 {
        return Rgb::BLACK;
    }
    let light: Rgb = q.samples.iter().map(|s| s.radiance * weight(q, s)).sum();
    light / divisor
}

/// The same with other weights.
fn average(q: &PixelAverage, weight: Weight) -> Rgb {
    changed_average(q, |how| how.weight = weight)
}

/// The same, divided by something else.
fn divided(q: &PixelAverage, divisor: fn(&PixelAverage, f32) -> f32) -> Rgb {
    changed_average(q, |how| how.divisor = divisor)
}

/// A running average: each sample moves it by a share of the way to that sample. `share(weight, count)` is made of the sample's weight and of
/// `count`, the number of samples so far, this one included.
fn running(q: &PixelAverage, share: fn(f32, f32) -> f32) -> Rgb {
    let toward = |average: Rgb, (i, s): (usize, &Seen)| {
        let share = share(tent(q, s.offset), (i + 1) as f32);
        average * (1.0 - share) + s.radiance * share
    };
    q.samples.iter().enumerate().fold(Rgb::BLACK, toward)
}

/// The average of samples of which no channel is above a limit.
fn cut_off(q: &PixelAverage, limit: f32) -> Rgb {
    PixelAverage::misread(q, |q| {
        for s in &mut q.samples {
            s.radiance = s.radiance.map(|v| v.min(limit));
        }
    })
}

/// A cone's weight.
fn cone(q: &PixelAverage, offset: Vec2) -> f32 {
    (1.0 - offset.length() / q.radius).max(0.0)
}

impl Graded for PixelAverage {
    fn random(rng: &mut Pcg) -> PixelAverage {
        let radius = sample::number(rng, 0.6, 2.0);
        let mut number = |min, max| sample::number(rng, min, max);
        let mut seen = || Seen {
            offset: vec2(number(-1.2, 1.2), number(-1.2, 1.2)) * radius,
            radiance: Rgb::new(number(0.0, 1.0), number(0.0, 1.0), number(0.0, 2.0)),
        };
        let mut samples: Vec<_> = (0..6).map(|_| seen()).collect();
        // One in the middle, so that there always is something.
        samples[0].offset *= 0.25;
        samples.truncate(rng.random_range(3..=6));
        // Of one pixel in four, all samples are near the filter's edge: their weights have a small sum.
        if rng.random_bool(0.25) {
            let margin = sample::number(rng, 0.1, 0.6);
            for Seen { offset, .. } in &mut samples {
                let edge = Vec2::splat(radius).copysign(*offset);
                *offset = edge.lerp(*offset, margin);
            }
        }
        PixelAverage { radius, samples }
    }

    fn judge(_q: &PixelAverage, golden: &Rgb, got: &Rgb) -> Verdict {
        let channels = golden.channels().into_iter().zip(got.channels());
        for (name, (golden, got)) in ["red", "green", "blue"].into_iter().zip(channels) {
            let tolerance = judge::RELATIVE * golden.max(0.01);
            judge::number_within(name, "W·m⁻²·sr⁻¹", golden, got, tolerance)?;
        }
        Ok(())
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "counts all samples alike",
            hint: "Does a sample at the filter's edge count as much as one in the pixel's centre?",
            answer: |q| average(q, |_, _| 1.0),
        },
        Mistake {
            name: "counts all samples alike that are within the radius",
            hint: "Does a sample at the filter's edge count as much as one in the pixel's centre?",
            answer: |q| average(q, |q, s| f32::from(tent(q, s.offset) > 0.0)),
        },
        Mistake {
            name: "divides by the number of samples",
            hint: "All samples see the same white wall: what does your pixel show?",
            answer: |q| divided(q, |q, _| q.samples.len() as f32),
        },
        Mistake {
            name: "does not divide by the sum of the weights",
            hint: "Take every sample twice: does the pixel become brighter?",
            answer: |q| divided(q, |_, _| 1.0),
        },
        Mistake {
            name: "lets the weights go below 0",
            hint: "What is the weight of a sample that is two radii away?",
            answer: |q| {
                average(q, |q, s| {
                    (1.0 - s.offset.abs() / q.radius).element_product()
                })
            },
        },
        Mistake {
            name: "lets the weights go below 0, and returns black where their sum does",
            hint: "What is the weight of a sample that is two radii away?",
            answer: |q| {
                changed_average(q, |how| {
                    how.weight = |q, s| (1.0 - s.offset.abs() / q.radius).element_product();
                    how.divisor = |_, weights| weights.max(0.0);
                })
            },
        },
        Mistake {
            name: "takes the tent of |x| + |y| in the place of the product of two",
            hint: "Halfway to the edge along both x and y, how large is each of the two factors, and how large is w?",
            answer: |q| {
                average(q, |q, s| {
                    (1.0 - s.offset.abs().element_sum() / q.radius).max(0.0)
                })
            },
        },
        Mistake {
            name: "makes a cone instead of a tent",
            hint: "The tent's edges are straight: what is its weight at a corner of its square, and half way to the corner?",
            answer: |q| average(q, |q, s| cone(q, s.offset)),
        },
        Mistake {
            name: "makes a cone instead of a tent, and does not divide by the sum of the weights",
            hint: "Take every sample twice: does the pixel become brighter? And how does a tent's edge differ from a cone's?",
            answer: |q| {
                changed_average(q, |how| {
                    how.weight = |q, s| cone(q, s.offset);
                    how.divisor = |_, _| 1.0;
                })
            },
        },
        Mistake {
            name: "forgets the radius",
            hint: "How far from the centre does your weight fall to 0?",
            answer: |q| Self::misread(q, |q| q.radius = 1.0),
        },
        Mistake {
            name: "takes x for |x| and y for |y|, so that weights stay 1 on one side",
            hint: "Is a sample to the left of the centre worth as much as one equally far to its right?",
            answer: |q| {
                average(q, |q, s| {
                    (1.0 - s.offset / q.radius)
                        .clamp(Vec2::ZERO, Vec2::ONE)
                        .element_product()
                })
            },
        },
        Mistake {
            name: "averages sRGB code values instead of radiance",
            hint: "Light adds up; do the numbers that go to a display? When is the picture encoded?",
            answer: |q| {
                let encoded = Self::misread(q, |q| {
                    for s in &mut q.samples {
                        s.radiance = s.radiance.map(tone::encode_srgb);
                    }
                });
                encoded.map(tone::decode_srgb)
            },
        },
        Mistake {
            name: "gives samples more weight the farther they are",
            hint: "Which sample tells most about the pixel: one in its middle, or one at the edge of the filter?",
            answer: |q| average(q, |q, s| (s.offset.abs() / q.radius).element_product()),
        },
        Mistake {
            name: "adds the factors along x and along y instead of multiplying them",
            hint: "A sample that is too far away along x: what does it count for, whatever y is?",
            answer: |q| {
                average(q, |q, s| {
                    (1.0 - s.offset.abs() / q.radius)
                        .max(Vec2::ZERO)
                        .element_sum()
                })
            },
        },
        Mistake {
            name: "takes x for |x| and y for |y|, so that weights grow above 1 on one side",
            hint: "Is a sample to the left of the centre worth as much as one equally far to its right?",
            answer: |q| {
                average(q, |q, s| {
                    (1.0 - s.offset / q.radius)
                        .max(Vec2::ZERO)
                        .element_product()
                })
            },
        },
        Mistake {
            name: "squares the weights",
            hint: "How much counts a sample half way to the edge: a half, or a quarter?",
            answer: |q| average(q, |q, s| tent(q, s.offset).powi(2)),
        },
        Mistake {
            name: "weighs by x only",
            hint: "A sample far above the pixel: does it count?",
            answer: |q| average(q, |q, s| (1.0 - s.offset.x.abs() / q.radius).max(0.0)),
        },
        Mistake {
            name: "divides by the largest weight",
            hint: "All samples see the same white wall: what does your pixel show?",
            answer: |q| {
                divided(q, |q, _| {
                    let weights = q.samples.iter().map(|s| tent(q, s.offset));
                    weights.fold(0.0, f32::max)
                })
            },
        },
        Mistake {
            name: "takes the smaller of the factors along x and along y instead of multiplying them",
            hint: "Half way to the edge along x and along y: is the weight a half, or a quarter?",
            answer: |q| {
                average(q, |q, s| {
                    (1.0 - s.offset.abs() / q.radius)
                        .max(Vec2::ZERO)
                        .min_element()
                })
            },
        },
        Mistake {
            name: "leaves out the last sample, but not its weight",
            hint: "Where does each of your loops over the samples end?",
            answer: |q| {
                let weights: f32 = q.samples.iter().map(|s| tent(q, s.offset)).sum();
                let mut all = q.samples.iter();
                all.next_back();
                let light: Rgb = all.map(|s| s.radiance * tent(q, s.offset)).sum();
                if weights > 0.0 {
                    light / weights
                } else {
                    Rgb::BLACK
                }
            },
        },
        Mistake {
            name: "leaves out the last sample",
            hint: "Where does your loop over the samples end?",
            answer: |q| {
                Self::misread(q, |q| {
                    q.samples.pop();
                })
            },
        },
        Mistake {
            name: "leaves out the first sample",
            hint: "Where does your loop over the samples begin?",
            answer: |q| {
                Self::misread(q, |q| {
                    q.samples = q.samples.split_off(1.min(q.samples.len()));
                })
            },
        },
        Mistake {
            name: "takes the larger of the factors along x and along y instead of multiplying them",
            hint: "A sample that is too far away along x: what does it count for, whatever y is?",
            answer: |q| {
                average(q, |q, s| {
                    (1.0 - s.offset.abs() / q.radius)
                        .max(Vec2::ZERO)
                        .max_element()
                })
            },
        },
        Mistake {
            name: "squares the shares of the radius, so that the tent's sides are round",
            hint: "Half way to the edge the weight is a half: what is yours?",
            answer: |q| {
                average(q, |q, s| {
                    let along = s.offset / q.radius;
                    (1.0 - along * along).max(Vec2::ZERO).element_product()
                })
            },
        },
        Mistake {
            name: "leaves black samples out",
            hint: "Half of your samples see black: is the pixel as bright as if they were not there?",
            answer: |q| {
                Self::misread(q, |q| {
                    q.samples.retain(|sample| sample.radiance != Rgb::BLACK);
                })
            },
        },
        Mistake {
            name: "keeps the product from falling below 0, but not each factor",
            hint: "A sample that is too far away along x and along y: what is the product of two negative factors?",
            answer: |q| {
                average(q, |q, s| {
                    let factors = 1.0 - s.offset.abs() / q.radius;
                    factors.element_product().max(0.0)
                })
            },
        },
        Mistake {
            name: "returns the plain mean of the samples where all weights are 0",
            hint: "No sample is within the radius: what does the task say of a pixel like this?",
            answer: |q| {
                if q.samples.iter().any(|s| tent(q, s.offset) > 0.0) {
                    Self::right(q)
                } else {
                    average(q, |_, _| 1.0)
                }
            },
        },
        Mistake {
            name: "divides by the number of samples that are within reach",
            hint: "All samples see the same white wall: what does your pixel show?",
            answer: |q| {
                divided(q, |q, _| {
                    let within = q.samples.iter().filter(|s| tent(q, s.offset) > 0.0);
                    within.count() as f32
                })
            },
        },
        Mistake {
            name: "divides by the filter's integral, radius²",
            hint: "All samples see the same white wall: what does your pixel show?",
            answer: |q| divided(q, |q, _| q.radius * q.radius),
        },
        Mistake {
            name: "takes the radius for the filter's whole width",
            hint: "Where is the tent's foot: one radius from the centre, or half of it?",
            answer: |q| Self::misread(q, |q| q.radius *= 0.5),
        },
        Mistake {
            name: "takes a bell curve for the filter, with half of the radius for its standard deviation",
            hint: "Does a sample in the pixel's centre count twice as much as one half way to the filter's edge? From where is the weight 0?",
            answer: |q| {
                average(q, |q, s| {
                    (-2.0 * s.offset.length_squared() / (q.radius * q.radius)).exp()
                })
            },
        },
        Mistake {
            name: "takes 1 − (x² + y²)/radius² for the weight",
            hint: "Does a sample in the pixel's centre count twice as much as one half way to the filter's edge? From where is the weight 0?",
            answer: |q| {
                average(q, |q, s| {
                    (1.0 - s.offset.length_squared() / (q.radius * q.radius)).max(0.0)
                })
            },
        },
        Mistake {
            name: "clamps radiance to 1 before it takes the average",
            hint: "Radiance has no upper limit: what does a lamp add to its pixel?",
            answer: |q| {
                Self::misread(q, |q| {
                    for s in &mut q.samples {
                        s.radiance = tone::clamp(s.radiance);
                    }
                })
            },
        },
        Mistake {
            name: "returns NaN where all weights are 0",
            hint: "What do you divide by if no sample is within reach?",
            answer: |q| {
                if q.samples.iter().all(|s| tent(q, s.offset) == 0.0) {
                    Rgb::gray(f32::NAN)
                } else {
                    Self::right(q)
                }
            },
        },
        Mistake {
            name: "counts only samples in the pixel itself, at most half a pixel away",
            hint: "How far does the filter reach: to the pixel's edge, or to its own radius?",
            answer: |q| {
                average(q, |q, s| {
                    let is_inside = s.offset.abs().max_element() <= 0.5;
                    if is_inside { tent(q, s.offset) } else { 0.0 }
                })
            },
        },
        Mistake {
            name: "takes the absolute value of each factor",
            hint: "What is the weight of a sample that is two radii away?",
            answer: |q| {
                average(q, |q, s| {
                    (1.0 - s.offset.abs() / q.radius).abs().element_product()
                })
            },
        },
        Mistake {
            name: "takes the nearest sample only",
            hint: "Where two samples have a weight, is the pixel the average of both?",
            answer: |q| {
                let within = q.samples.iter().filter(|s| tent(q, s.offset) > 0.0);
                let away = |s: &&Seen| s.offset.length_squared();
                let nearest = within.min_by(|one, other| away(one).total_cmp(&away(other)));
                nearest.map_or(Rgb::BLACK, |s| s.radiance)
            },
        },
        Mistake {
            name: "moves a running average by each sample's whole weight, not by its share of all weights so far",
            hint: "Two samples in the same place: by which part does the second move the average of the first?",
            answer: |q| running(q, |weight, _| weight),
        },
        Mistake {
            name: "moves a running average by each sample's weight over the number of samples, not over all weights so far",
            hint: "Two samples in the same place: by which part does the second move the average of the first?",
            answer: |q| running(q, |weight, count| weight / count),
        },
        Mistake {
            name: "cuts the radiance of each sample off at 10 before it takes the average",
            hint: "Radiance has no upper limit: what does a lamp add to its pixel?",
            answer: |q| cut_off(q, 10.0),
        },
        Mistake {
            name: "cuts the radiance of each sample off at 100 before it takes the average",
            hint: "Radiance has no upper limit: what does a lamp add to its pixel?",
            answer: |q| cut_off(q, 100.0),
        },
    ];
}

//! `needs_more`: random questions, judge and mistakes.

mod rules;

use super::measures::{range, standard_error, verdict};
use crate::{Graded, Mistake, Verdict, sample};
use rand::RngExt;
use raybook::image::rgb::Rgb;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch23_adaptive::NeedsMore;
use rules::{
    all_channels, channel, darkest_and_brightest, decided, first_decides, luminances, running, sum,
};

impl Graded for NeedsMore {
    fn random(rng: &mut Pcg) -> NeedsMore {
        // Where no contrast is too much, the error alone decides: a little, and of few samples, whose noise has a colour.
        let alone = rng.random_bool(0.4);
        let n = rng.random_range(2..=if alone { 4 } else { 8 });
        let base = 10.0_f32.powf(sample::number(rng, -1.5, 1.5));
        let spread = sample::number(rng, 0.05, 0.7);
        let mut channel = [(); 3].map(|()| spread * sample::number(rng, 0.1, 1.0));
        if alone {
            let noisy = rng.random_range(0..3);
            (0..3)
                .filter(|i| *i != noisy)
                .for_each(|i| channel[i] *= 0.1);
        }
        let samples: Vec<_> = (0..n)
            .map(|_| {
                let [r, g, b] = channel.map(|s| base * (1.0 + s * sample::number(rng, -1.0, 1.0)));
                Rgb::new(r, g, b)
            })
            .collect();
        let mut q = NeedsMore {
            contrast: Rgb::new(
                sample::number(rng, 0.2, 0.7),
                sample::number(rng, 0.2, 0.7),
                sample::number(rng, 0.2, 0.7),
            ),
            error: 0.0,
            samples,
        };
        // An error that is decided by a factor of up to three, this way or that.
        let mut power = sample::number(rng, -0.5, 1.0);
        if alone {
            q.contrast = Rgb::gray(f32::INFINITY);
            power *= 0.4;
        }
        q.error = standard_error(&q) * 3.0_f32.powf(power);
        q
    }

    fn judge(q: &NeedsMore, golden: &u32, got: &u32) -> Verdict {
        verdict(q, *golden, *got)
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "takes the difference for the contrast",
            hint: "In a dark corner all differences are small: does the eye see them?",
            answer: |q| decided(q, |how| how.contrast = |of| of.max - of.min),
        },
        Mistake {
            name: "divides the difference by the largest only",
            hint: "What is below the line: the largest, or the sum of the largest and the least?",
            answer: |q| decided(q, |how| how.contrast = |of| (of.max - of.min) / of.max),
        },
        Mistake {
            name: "looks at the contrast only",
            hint: "Samples can differ little in contrast, and their mean can still be too uncertain: what is the second rule?",
            answer: |q| decided(q, |how| how.decide = |is_contrasty, _| is_contrasty),
        },
        Mistake {
            name: "looks at the error only",
            hint: "A pixel with a small error may still have too much contrast: what is the first rule?",
            answer: |q| decided(q, |how| how.decide = |_, is_uncertain| is_uncertain),
        },
        Mistake {
            name: "takes the deviation of the samples for the error of their mean",
            hint: "Take more samples of the same wall: does your error ever get smaller?",
            answer: |q| decided(q, |how| how.error = |variance, _| variance.sqrt()),
        },
        Mistake {
            name: "takes the variance without a root",
            hint: "What is the unit of a variance, and of an error?",
            answer: |q| decided(q, |how| how.error = |variance, n| variance / n),
        },
        Mistake {
            name: "wants all channels to be too contrasty",
            hint: "Red letters on a black wall: does green or blue differ at all?",
            answer: |q| {
                decided(q, |how| {
                    how.is_contrasty = |channels, is_above| channels.iter().all(is_above);
                })
            },
        },
        Mistake {
            name: "looks at the contrast of red only",
            hint: "Blue letters on a black wall: does red differ at all?",
            answer: |q| decided(q, |how| how.channels = 1),
        },
        Mistake {
            name: "takes red's limit for the contrast of all channels",
            hint: "The eye sees a step of green sooner than one of blue: which limit belongs to which channel?",
            answer: |q| decided(q, |how| how.limits = |limits| [limits[0]; 3]),
        },
        Mistake {
            name: "leaves out the contrast of blue",
            hint: "Each of the three channels has a limit of its own: which of them does your loop come to?",
            answer: |q| decided(q, |how| how.channels = 2),
        },
        Mistake {
            name: "looks at the contrast of the luminance only",
            hint: "Red letters on a green wall that is just as bright: does the luminance differ at all?",
            answer: |q| decided(q, |how| how.values = luminances),
        },
        Mistake {
            name: "divides the deviation by the number of samples instead of its root",
            hint: "Four times the samples: does the error of their mean become a quarter, or a half?",
            answer: |q| decided(q, |how| how.error = |variance, n| variance.sqrt() / n),
        },
        Mistake {
            name: "divides the squares by n instead of n − 1",
            hint: "Two samples: by what do you divide the sum of the squares, and by what does the task?",
            answer: |q| decided(q, |how| how.divisor = |n| n),
        },
        Mistake {
            name: "is content with fewer than two samples",
            hint: "What is known of a pixel after one sample?",
            answer: |q| decided(q, |how| how.fewest = 0),
        },
        Mistake {
            name: "wants both rules to be broken at once",
            hint: "Is one of the two rules enough to ask for more samples?",
            answer: |q| {
                decided(q, |how| {
                    how.decide = |is_contrasty, is_uncertain| is_contrasty && is_uncertain;
                })
            },
        },
        Mistake {
            name: "is content as soon as the contrast of one channel is allowed",
            hint: "Red is within its limit: what do you know of green, of blue, and of the error?",
            answer: |q| {
                decided(q, |how| {
                    how.is_content = |channels, is_above| !channels.iter().all(is_above);
                    how.is_contrasty = |_, _| false;
                })
            },
        },
        Mistake {
            name: "turns the rule of the error round",
            hint: "Is a pixel with a large error the one that needs more samples, or the one with a small error?",
            answer: |q| decided(q, |how| how.is_uncertain = |error, limit| error <= limit),
        },
        Mistake {
            name: "says the opposite",
            hint: "Samples that are all equal: do they need more?",
            answer: |q| 1 - Self::right(q),
        },
        Mistake {
            name: "takes the mean of R, G and B for the luminance",
            hint: "Green looks brighter than blue: with which weights does the luminance count them?",
            answer: |q| decided(q, |how| how.luminance = |s| (s.r + s.g + s.b) / 3.0),
        },
        Mistake {
            name: "takes the weights 0.299, 0.587 and 0.114 for the luminance, those of old television",
            hint: "With which weights does the luminance count red, green and blue here?",
            answer: |q| {
                decided(q, |how| {
                    how.luminance = |s| 0.299 * s.r + 0.587 * s.g + 0.114 * s.b;
                })
            },
        },
        Mistake {
            name: "wants more samples where a contrast is just what is allowed",
            hint: "The contrast must be above its limit: what if it is the limit itself?",
            answer: |q| {
                decided(q, |how| {
                    how.is_above = |channel| channel.contrast >= channel.limit;
                })
            },
        },
        Mistake {
            name: "takes half of the range of the luminance for its deviation",
            hint: "One bright sample among seven dark ones: what is their variance?",
            answer: |q| {
                decided(q, |how| {
                    how.variance = |values, _| {
                        let [max, min] = range(values);
                        (0.5 * (max - min)).powi(2)
                    };
                })
            },
        },
        Mistake {
            name: "divides the difference by the least only",
            hint: "White is 1, and black is 0: how large is the contrast of both at most?",
            answer: |q| {
                decided(q, |how| {
                    how.contrast = |of| (of.max - of.min) / of.min.max(1e-9);
                })
            },
        },
        Mistake {
            name: "wants more samples as long as there are fewer than three",
            hint: "How many samples are too few, whatever they are?",
            answer: |q| decided(q, |how| how.fewest = 3),
        },
        Mistake {
            name: "divides the difference by the mean",
            hint: "The sum of the largest and the least is twice what is between them: which of the two does the task divide by?",
            answer: |q| decided(q, |how| how.contrast = |of| (of.max - of.min) / of.mean),
        },
        Mistake {
            name: "adds the channels' deviations as if they were a colour, not that of the luminance",
            hint: "One channel is brighter where another is darker: is the luminance noisy then, and what do your deviations add up to?",
            answer: |q| {
                decided(q, |how| {
                    how.noise = |samples, luminance, error| {
                        let [r, g, b] = [0, 1, 2].map(|i| error(&channel(samples, i, luminance)));
                        luminance(Rgb::new(r, g, b))
                    };
                })
            },
        },
        Mistake {
            name: "looks at the contrast of the luminance only, by the luminance of the limits",
            hint: "Red letters on a green wall that is just as bright: does the luminance differ at all?",
            answer: |q| {
                decided(q, |how| {
                    how.values = luminances;
                    how.limits = |[r, g, b]| [Rgb::new(r, g, b).luminance(); 3];
                })
            },
        },
        Mistake {
            name: "looks at the contrast of the luminance only, by green's limit",
            hint: "Red letters on a green wall that is just as bright: does the luminance differ at all?",
            answer: |q| {
                decided(q, |how| {
                    how.values = luminances;
                    how.limits = |limits| [limits[1]; 3];
                })
            },
        },
        Mistake {
            name: "divides the difference by half of the sum",
            hint: "White is 1, and black is 0: how large is the contrast of both?",
            answer: |q| {
                decided(q, |how| {
                    how.contrast = |of| 2.0 * (of.max - of.min) / (of.max + of.min);
                })
            },
        },
        Mistake {
            name: "takes the largest and the least of all three channels together",
            hint: "All samples are of the same pure red: do they differ at all?",
            answer: |q| decided(q, |how| how.values = |samples, _, _| all_channels(samples)),
        },
        Mistake {
            name: "compares the error with its limit times the mean luminance",
            hint: "In which unit is the limit of the error: is it a share of the mean?",
            answer: |q| decided(q, |how| how.error_limit = |limit, mean| limit * mean),
        },
        Mistake {
            name: "divides the deviation by the root of n − 1, not by the root of n",
            hint: "Of the two divisions, which one is by n − 1, and which by the root of n?",
            answer: |q| {
                decided(q, |how| {
                    how.error = |variance, n| (variance / (n - 1.0)).sqrt();
                })
            },
        },
        Mistake {
            name: "asks the error of each channel, not that of the luminance",
            hint: "Blue is noisy, and counts little for the luminance: how noisy is that?",
            answer: |q| {
                decided(q, |how| {
                    how.noise = |samples, luminance, error| {
                        let errors = (0..3).map(|i| error(&channel(samples, i, luminance)));
                        errors.fold(0.0, f32::max)
                    };
                })
            },
        },
        Mistake {
            name: "lets the least begin at 0, so that it is never larger",
            hint: "Samples that are all the same: what is their least value?",
            answer: |q| decided(q, |how| how.range = |values| [range(values)[0], 0.0]),
        },
        Mistake {
            name: "wants more samples where a channel is black",
            hint: "A channel that is black in all samples: does it differ at all?",
            answer: |q| {
                decided(q, |how| {
                    how.is_above = |channel| channel.is_black || channel.contrast > channel.limit;
                })
            },
        },
        Mistake {
            name: "compares each sample with the next one only",
            hint: "Three samples, each a little brighter than the one before: how much brighter is the last than the first?",
            answer: |q| {
                decided(q, |how| {
                    how.groups = |samples, _| samples.windows(2).map(<[Rgb]>::to_vec).collect();
                })
            },
        },
        Mistake {
            name: "compares the first sample with the last one only",
            hint: "One bright sample among dark ones: does it count wherever it comes?",
            answer: |q| {
                decided(q, |how| {
                    how.groups = |samples, _| {
                        let ends = samples.first().into_iter().chain(samples.last());
                        vec![ends.copied().collect()]
                    };
                })
            },
        },
        Mistake {
            name: "subtracts the square of the mean from the sum of the squares, and not n times it",
            hint: "Samples that are all the same: what is the sum of their squares, and what do you subtract?",
            answer: |q| {
                decided(q, |how| {
                    how.variance = |values, divisor| {
                        let mean = values.iter().sum::<f32>() / values.len() as f32;
                        let squares: f32 = values.iter().map(|y| y * y).sum();
                        (squares - mean * mean).max(0.0) / divisor
                    };
                })
            },
        },
        Mistake {
            name: "wants more samples where the error is just what is allowed",
            hint: "The error must be above its limit: what if it is the limit itself?",
            answer: |q| decided(q, |how| how.is_uncertain = |error, limit| error >= limit),
        },
        Mistake {
            name: "compares the sum of the three contrasts with the sum of the limits",
            hint: "Red letters on a black wall: may the other two channels make up for them?",
            answer: |q| {
                decided(q, |how| {
                    how.is_contrasty = |channels, is_above| is_above(&sum(channels));
                })
            },
        },
        Mistake {
            name: "takes the largest limit for the contrast of all channels",
            hint: "The eye sees a step of green sooner than one of blue: which limit belongs to which channel?",
            answer: |q| {
                decided(q, |how| {
                    how.limits = |limits| [limits.into_iter().fold(0.0, f32::max); 3];
                })
            },
        },
        Mistake {
            name: "takes the smallest limit for the contrast of all channels",
            hint: "The eye sees a step of green sooner than one of blue: which limit belongs to which channel?",
            answer: |q| {
                decided(q, |how| {
                    how.limits = |limits| [limits.into_iter().fold(f32::INFINITY, f32::min); 3];
                })
            },
        },
        Mistake {
            name: "takes the mean of the limits for the contrast of all channels",
            hint: "The eye sees a step of green sooner than one of blue: which limit belongs to which channel?",
            answer: |q| {
                decided(q, |how| {
                    how.limits = |limits| [limits.iter().sum::<f32>() / 3.0; 3];
                })
            },
        },
        Mistake {
            name: "takes the three channels of each sample for three samples of the luminance",
            hint: "A sample of pure red, twice: do two samples of one colour tell any noise?",
            answer: |q| {
                decided(q, |how| {
                    how.noise = |samples, _, error| error(&all_channels(samples));
                })
            },
        },
        Mistake {
            name: "returns 0 at the first channel that is black",
            hint: "One channel is black in all samples: may another one differ, or the luminance be noisy?",
            answer: |q| {
                decided(q, |how| {
                    how.is_content = |channels, is_above| {
                        let decisive = channels.iter().find(|one| one.is_black || is_above(one));
                        decisive.is_some_and(|one| one.is_black)
                    };
                })
            },
        },
        Mistake {
            name: "asks only the first channel that is not black whether it has too much contrast",
            hint: "Red is within its limit: when does your loop over the channels end, and which of them does it still come to?",
            answer: |q| decided(q, |how| how.is_contrasty = first_decides),
        },
        Mistake {
            name: "returns at the first channel that is not black whether its contrast is too much",
            hint: "Red is within its limit: what do you know of green, of blue, and of the error? When does your loop return?",
            answer: |q| {
                decided(q, |how| {
                    how.is_content = |channels, is_above| {
                        let is_lit = channels.iter().any(|channel| !channel.is_black);
                        is_lit && !first_decides(channels, is_above)
                    };
                    how.is_contrasty = first_decides;
                })
            },
        },
        Mistake {
            name: "squares the difference from the mean before in a running variance, and does not multiply it by that from the mean after",
            hint: "Two samples, 0 and 1: what is their variance, and what does your recurrence make of it?",
            answer: |q| {
                decided(q, |how| {
                    how.variance =
                        |values, divisor| running(values, 1, |before, _| before * before) / divisor;
                })
            },
        },
        Mistake {
            name: "squares the difference from the mean before in a running variance, and that of the first sample from 0 too",
            hint: "Two samples that are the same: what is their variance, and what does your recurrence make of the first of them?",
            answer: |q| {
                decided(q, |how| {
                    how.variance =
                        |values, divisor| running(values, 0, |before, _| before * before) / divisor;
                })
            },
        },
        Mistake {
            name: "squares the difference from the mean after in a running variance, not multiplied by that from the mean before",
            hint: "Two samples, 0 and 1: what is their variance, and what does your recurrence make of it?",
            answer: |q| {
                decided(q, |how| {
                    how.variance =
                        |values, divisor| running(values, 0, |_, after| after * after) / divisor;
                })
            },
        },
        Mistake {
            name: "takes each channel's contrast between the samples of least and of greatest luminance",
            hint: "One sample may be the darkest in blue and another one in green: whose values are max and min of a channel?",
            answer: |q| decided(q, |how| how.groups = darkest_and_brightest),
        },
        Mistake {
            name: "subtracts the sample of least luminance from that of greatest luminance, channel by channel, for the contrast",
            hint: "May a channel be darker in the brighter one of two samples? Whose values are max and min of a channel?",
            answer: |q| {
                decided(q, |how| {
                    how.groups = darkest_and_brightest;
                    how.range =
                        |values| [values.last(), values.first()].map(|v| v.copied().unwrap_or(0.0));
                })
            },
        },
        Mistake {
            name: "divides the difference by twice the mean of all samples",
            hint: "One bright sample among many dark ones: is the mean half of the sum of the largest and the least?",
            answer: |q| {
                decided(q, |how| {
                    how.contrast = |of| (of.max - of.min) / (2.0 * of.mean);
                })
            },
        },
        Mistake {
            name: "divides the standard deviation by the mean for the contrast",
            hint: "Which two values of a channel does the contrast compare: is a deviation one of them?",
            answer: |q| decided(q, |how| how.contrast = |of| of.deviation / of.mean),
        },
    ];
}

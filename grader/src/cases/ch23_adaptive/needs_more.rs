//! `needs_more`: random questions, judge and mistakes.

mod rules;

use super::measures::{decide, range, ratio, squares, standard_error, too_contrasty, verdict};
use crate::{Graded, Mistake, Verdict, sample};
use rand::RngExt;
use raybook::image::rgb::Rgb;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch23_adaptive::NeedsMore;
use rules::{
    by_mean, by_one_limit, by_weights, darkest_and_brightest, error_of, of_luminance, of_pairs,
    running,
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
            answer: |q| {
                decide(
                    q,
                    too_contrasty(q, |[max, min]| max - min),
                    standard_error(q),
                )
            },
        },
        Mistake {
            name: "divides the difference by the largest only",
            hint: "What is below the line: the largest, or the sum of the largest and the least?",
            answer: |q| {
                decide(
                    q,
                    too_contrasty(
                        q,
                        |[max, min]| if max > 0.0 { (max - min) / max } else { 0.0 },
                    ),
                    standard_error(q),
                )
            },
        },
        Mistake {
            name: "looks at the contrast only",
            hint: "Samples can differ little in contrast, and their mean can still be too uncertain: what is the second rule?",
            answer: |q| decide(q, too_contrasty(q, ratio), 0.0),
        },
        Mistake {
            name: "looks at the error only",
            hint: "A pixel with a small error may still have too much contrast: what is the first rule?",
            answer: |q| decide(q, false, standard_error(q)),
        },
        Mistake {
            name: "takes the deviation of the samples for the error of their mean",
            hint: "Take more samples of the same wall: does your error ever get smaller?",
            answer: |q| {
                decide(
                    q,
                    too_contrasty(q, ratio),
                    (squares(q) / (q.samples.len() as f32 - 1.0)).sqrt(),
                )
            },
        },
        Mistake {
            name: "takes the variance without a root",
            hint: "What is the unit of a variance, and of an error?",
            answer: |q| {
                decide(
                    q,
                    too_contrasty(q, ratio),
                    squares(q) / (q.samples.len() as f32 - 1.0) / q.samples.len() as f32,
                )
            },
        },
        Mistake {
            name: "wants all channels to be too contrasty",
            hint: "Red letters on a black wall: does green or blue differ at all?",
            answer: |q| {
                let limits = q.contrast.channels();
                let all = (0..3).all(|channel| ratio(range(q, channel)) > limits[channel]);
                decide(q, all, standard_error(q))
            },
        },
        Mistake {
            name: "looks at the contrast of red only",
            hint: "Blue letters on a black wall: does red differ at all?",
            answer: |q| {
                let red = ratio(range(q, 0)) > q.contrast.r;
                decide(q, red, standard_error(q))
            },
        },
        Mistake {
            name: "takes red's limit for the contrast of all channels",
            hint: "The eye sees a step of green sooner than one of blue: which limit belongs to which channel?",
            answer: |q| {
                let contrast = (0..3).any(|channel| ratio(range(q, channel)) > q.contrast.r);
                decide(q, contrast, standard_error(q))
            },
        },
        Mistake {
            name: "leaves out the contrast of blue",
            hint: "Each of the three channels has a limit of its own: which of them does your loop come to?",
            answer: |q| Self::misread(q, |q| q.contrast.b = f32::INFINITY),
        },
        Mistake {
            name: "looks at the contrast of the luminance only",
            hint: "Red letters on a green wall that is just as bright: does the luminance differ at all?",
            answer: |q| {
                let values = || q.samples.iter().map(|sample| sample.luminance());
                let (max, min) = (
                    values().fold(0.0, f32::max),
                    values().fold(f32::INFINITY, f32::min),
                );
                let limits = q.contrast.channels();
                let contrast = limits.iter().any(|limit| ratio([max, min]) > *limit);
                decide(q, contrast, standard_error(q))
            },
        },
        Mistake {
            name: "divides the deviation by the number of samples instead of its root",
            hint: "Four times the samples: does the error of their mean become a quarter, or a half?",
            answer: |q| {
                let n = q.samples.len() as f32;
                let error = standard_error(q) / n.sqrt();
                decide(q, too_contrasty(q, ratio), error)
            },
        },
        Mistake {
            name: "divides the squares by n instead of n − 1",
            hint: "Two samples: by what do you divide the sum of the squares, and by what does the task?",
            answer: |q| {
                let n = q.samples.len() as f32;
                decide(
                    q,
                    too_contrasty(q, ratio),
                    standard_error(q) * ((n - 1.0) / n).sqrt(),
                )
            },
        },
        Mistake {
            name: "is content with fewer than two samples",
            hint: "What is known of a pixel after one sample?",
            answer: |q| {
                if q.samples.len() < 2 {
                    return 0;
                }
                NeedsMore::right(q)
            },
        },
        Mistake {
            name: "wants both rules to be broken at once",
            hint: "Is one of the two rules enough to ask for more samples?",
            answer: |q| {
                let both = too_contrasty(q, ratio) && standard_error(q) > q.error;
                decide(q, both, 0.0)
            },
        },
        Mistake {
            name: "is content as soon as the contrast of one channel is allowed",
            hint: "Red is within its limit: what do you know of green, of blue, and of the error?",
            answer: |q| {
                let limits = q.contrast.channels();
                let allowed = (0..3).any(|channel| ratio(range(q, channel)) <= limits[channel]);
                if q.samples.len() >= 2 && allowed {
                    return 0;
                }
                decide(q, false, standard_error(q))
            },
        },
        Mistake {
            name: "turns the rule of the error round",
            hint: "Is a pixel with a large error the one that needs more samples, or the one with a small error?",
            answer: |q| {
                let small = standard_error(q) <= q.error;
                decide(q, too_contrasty(q, ratio) || small, 0.0)
            },
        },
        Mistake {
            name: "says the opposite",
            hint: "Samples that are all equal: do they need more?",
            answer: |q| 1 - decide(q, too_contrasty(q, ratio), standard_error(q)),
        },
        Mistake {
            name: "takes the mean of R, G and B for the luminance",
            hint: "Green looks brighter than blue: with which weights does the luminance count them?",
            answer: |q| by_weights(q, [1.0 / 3.0; 3]),
        },
        Mistake {
            name: "takes the weights 0.299, 0.587 and 0.114 for the luminance, those of old television",
            hint: "With which weights does the luminance count red, green and blue here?",
            answer: |q| by_weights(q, [0.299, 0.587, 0.114]),
        },
        Mistake {
            name: "wants more samples where a contrast is just what is allowed",
            hint: "The contrast must be above its limit: what if it is the limit itself?",
            answer: |q| {
                let limits = q.contrast.channels();
                let reaches = (0..3).any(|channel| ratio(range(q, channel)) >= limits[channel]);
                decide(q, reaches, standard_error(q))
            },
        },
        Mistake {
            name: "takes half of the range of the luminance for its deviation",
            hint: "One bright sample among seven dark ones: what is their variance?",
            answer: |q| {
                let values = || q.samples.iter().map(|s| s.luminance());
                let range = values().fold(0.0, f32::max) - values().fold(f32::INFINITY, f32::min);
                let error = 0.5 * range / (q.samples.len() as f32).sqrt();
                decide(q, too_contrasty(q, ratio), error)
            },
        },
        Mistake {
            name: "divides the difference by the least only",
            hint: "White is 1, and black is 0: how large is the contrast of both at most?",
            answer: |q| {
                decide(
                    q,
                    too_contrasty(q, |[max, min]| (max - min) / min.max(1e-9)),
                    standard_error(q),
                )
            },
        },
        Mistake {
            name: "wants more samples as long as there are fewer than three",
            hint: "How many samples are too few, whatever they are?",
            answer: |q| {
                if q.samples.len() < 3 {
                    1
                } else {
                    Self::right(q)
                }
            },
        },
        Mistake {
            name: "divides the difference by the mean",
            hint: "The sum of the largest and the least is twice what is between them: which of the two does the task divide by?",
            answer: |q| by_mean(q, |[max, min], mean, _| (max - min) / mean),
        },
        Mistake {
            name: "adds the channels' deviations as if they were a colour, not that of the luminance",
            hint: "One channel is brighter where another is darker: is the luminance noisy then, and what do your deviations add up to?",
            answer: |q| {
                let n = q.samples.len() as f32;
                let mean = q.samples.iter().copied().sum::<Rgb>() / n;
                let apart = q.samples.iter().map(|s| (*s + mean * -1.0).map(|v| v * v));
                let variance = apart.sum::<Rgb>() / (n - 1.0);
                let error = (variance / n).map(f32::sqrt).luminance();
                decide(q, too_contrasty(q, ratio), error)
            },
        },
        Mistake {
            name: "looks at the contrast of the luminance only, by the luminance of the limits",
            hint: "Red letters on a green wall that is just as bright: does the luminance differ at all?",
            answer: |q| of_luminance(q, q.contrast.luminance()),
        },
        Mistake {
            name: "looks at the contrast of the luminance only, by green's limit",
            hint: "Red letters on a green wall that is just as bright: does the luminance differ at all?",
            answer: |q| of_luminance(q, q.contrast.g),
        },
        Mistake {
            name: "divides the difference by half of the sum",
            hint: "White is 1, and black is 0: how large is the contrast of both?",
            answer: |q| {
                let contrast = too_contrasty(q, |range| 2.0 * ratio(range));
                decide(q, contrast, standard_error(q))
            },
        },
        Mistake {
            name: "takes the largest and the least of all three channels together",
            hint: "All samples are of the same pure red: do they differ at all?",
            answer: |q| {
                let [max, min] = (0..3)
                    .map(|channel| range(q, channel))
                    .fold([0.0, f32::INFINITY], |[max, min], of_channel| {
                        [of_channel[0].max(max), of_channel[1].min(min)]
                    });
                let contrast = too_contrasty(q, |_| ratio([max, min]));
                decide(q, contrast, standard_error(q))
            },
        },
        Mistake {
            name: "compares the error with its limit times the mean luminance",
            hint: "In which unit is the limit of the error: is it a share of the mean?",
            answer: |q| {
                let n = q.samples.len() as f32;
                let mean = q.samples.iter().map(|s| s.luminance()).sum::<f32>() / n;
                let error = if mean > 0.0 {
                    standard_error(q) / mean
                } else {
                    0.0
                };
                decide(q, too_contrasty(q, ratio), error)
            },
        },
        Mistake {
            name: "divides the deviation by the root of n − 1, not by the root of n",
            hint: "Of the two divisions, which one is by n − 1, and which by the root of n?",
            answer: |q| {
                let n = q.samples.len() as f32;
                let error = standard_error(q) * (n / (n - 1.0)).sqrt();
                decide(q, too_contrasty(q, ratio), error)
            },
        },
        Mistake {
            name: "asks the error of each channel, not that of the luminance",
            hint: "Blue is noisy, and counts little for the luminance: how noisy is that?",
            answer: |q| {
                let most = (0..3)
                    .map(|channel| error_of(q, channel))
                    .fold(0.0, f32::max);
                decide(q, too_contrasty(q, ratio), most)
            },
        },
        Mistake {
            name: "lets the least begin at 0, so that it is never larger",
            hint: "Samples that are all the same: what is their least value?",
            answer: |q| {
                let contrast = too_contrasty(q, |[max, _]| ratio([max, 0.0]));
                decide(q, contrast, standard_error(q))
            },
        },
        Mistake {
            name: "wants more samples where a channel is black",
            hint: "A channel that is black in all samples: does it differ at all?",
            answer: |q| {
                let is_black = (0..3).any(|channel| range(q, channel)[0] == 0.0);
                decide(q, is_black || too_contrasty(q, ratio), standard_error(q))
            },
        },
        Mistake {
            name: "compares each sample with the next one only",
            hint: "Three samples, each a little brighter than the one before: how much brighter is the last than the first?",
            answer: |q| {
                let neighbours = q.samples.windows(2).map(|pair| [&pair[0], &pair[1]]);
                let neighbours: Vec<_> = neighbours.collect();
                decide(q, of_pairs(q, &neighbours), standard_error(q))
            },
        },
        Mistake {
            name: "compares the first sample with the last one only",
            hint: "One bright sample among dark ones: does it count wherever it comes?",
            answer: |q| {
                let ends = q.samples.first().zip(q.samples.last());
                let ends: Vec<_> = ends
                    .into_iter()
                    .map(|(first, last)| [first, last])
                    .collect();
                decide(q, of_pairs(q, &ends), standard_error(q))
            },
        },
        Mistake {
            name: "subtracts the square of the mean from the sum of the squares, and not n times it",
            hint: "Samples that are all the same: what is the sum of their squares, and what do you subtract?",
            answer: |q| {
                let n = q.samples.len() as f32;
                let values = || q.samples.iter().map(|s| s.luminance());
                let mean = values().sum::<f32>() / n;
                let squares = values().map(|y| y * y).sum::<f32>() - mean * mean;
                let error = (squares.max(0.0) / (n - 1.0) / n).sqrt();
                decide(q, too_contrasty(q, ratio), error)
            },
        },
        Mistake {
            name: "wants more samples where the error is just what is allowed",
            hint: "The error must be above its limit: what if it is the limit itself?",
            answer: |q| {
                let error = standard_error(q);
                decide(q, too_contrasty(q, ratio) || error >= q.error, error)
            },
        },
        Mistake {
            name: "compares the sum of the three contrasts with the sum of the limits",
            hint: "Red letters on a black wall: may the other two channels make up for them?",
            answer: |q| {
                let sum: f32 = (0..3).map(|channel| ratio(range(q, channel))).sum();
                let limit: f32 = q.contrast.channels().iter().sum();
                decide(q, sum > limit, standard_error(q))
            },
        },
        Mistake {
            name: "takes the largest limit for the contrast of all channels",
            hint: "The eye sees a step of green sooner than one of blue: which limit belongs to which channel?",
            answer: |q| by_one_limit(q, q.contrast.channels().into_iter().fold(0.0, f32::max)),
        },
        Mistake {
            name: "takes the smallest limit for the contrast of all channels",
            hint: "The eye sees a step of green sooner than one of blue: which limit belongs to which channel?",
            answer: |q| {
                by_one_limit(
                    q,
                    q.contrast
                        .channels()
                        .into_iter()
                        .fold(f32::INFINITY, f32::min),
                )
            },
        },
        Mistake {
            name: "takes the mean of the limits for the contrast of all channels",
            hint: "The eye sees a step of green sooner than one of blue: which limit belongs to which channel?",
            answer: |q| by_one_limit(q, q.contrast.channels().iter().sum::<f32>() / 3.0),
        },
        Mistake {
            name: "takes the three channels of each sample for three samples of the luminance",
            hint: "A sample of pure red, twice: do two samples of one colour tell any noise?",
            answer: |q| {
                let gray = |s: &Rgb| s.channels().map(Rgb::gray);
                let error = standard_error(&NeedsMore {
                    samples: q.samples.iter().flat_map(gray).collect(),
                    ..q.clone()
                });
                decide(q, too_contrasty(q, ratio), error)
            },
        },
        Mistake {
            name: "returns 0 at the first channel that is black",
            hint: "One channel is black in all samples: may another one differ, or the luminance be noisy?",
            answer: |q| {
                let is_lit = |channel: &usize| range(q, *channel)[0] > 0.0;
                let limits = q.contrast.channels();
                let mut before = (0..3).take_while(is_lit);
                let contrast = before.any(|channel| ratio(range(q, channel)) > limits[channel]);
                if !contrast && !(0..3).all(|channel| is_lit(&channel)) {
                    return 0;
                }
                decide(q, contrast, standard_error(q))
            },
        },
        Mistake {
            name: "squares the difference from the mean before in a running variance, and does not multiply it by that from the mean after",
            hint: "Two samples, 0 and 1: what is their variance, and what does your recurrence make of it?",
            answer: |q| running(q, 1, |before, _| before * before),
        },
        Mistake {
            name: "squares the difference from the mean before in a running variance, and that of the first sample from 0 too",
            hint: "Two samples that are the same: what is their variance, and what does your recurrence make of the first of them?",
            answer: |q| running(q, 0, |before, _| before * before),
        },
        Mistake {
            name: "squares the difference from the mean after in a running variance, not multiplied by that from the mean before",
            hint: "Two samples, 0 and 1: what is their variance, and what does your recurrence make of it?",
            answer: |q| running(q, 0, |_, after| after * after),
        },
        Mistake {
            name: "takes each channel's contrast between the samples of least and of greatest luminance",
            hint: "One sample may be the darkest in blue and another one in green: whose values are max and min of a channel?",
            answer: |q| {
                let ends: Vec<_> = darkest_and_brightest(q).into_iter().collect();
                decide(q, of_pairs(q, &ends), standard_error(q))
            },
        },
        Mistake {
            name: "subtracts the sample of least luminance from that of greatest luminance, channel by channel, for the contrast",
            hint: "May a channel be darker in the brighter one of two samples? Whose values are max and min of a channel?",
            answer: |q| {
                let limits = q.contrast.channels();
                let contrast = darkest_and_brightest(q).is_some_and(|ends| {
                    let [dark, bright] = ends.map(|sample| sample.channels());
                    let is_above = |i: usize| {
                        let sum = bright[i] + dark[i];
                        sum > 0.0 && (bright[i] - dark[i]) / sum > limits[i]
                    };
                    (0..3).any(is_above)
                });
                decide(q, contrast, standard_error(q))
            },
        },
        Mistake {
            name: "divides the difference by twice the mean of all samples",
            hint: "One bright sample among many dark ones: is the mean half of the sum of the largest and the least?",
            answer: |q| by_mean(q, |[max, min], mean, _| (max - min) / (2.0 * mean)),
        },
        Mistake {
            name: "divides the standard deviation by the mean for the contrast",
            hint: "Which two values of a channel does the contrast compare: is a deviation one of them?",
            answer: |q| by_mean(q, |_, mean, deviation| deviation / mean),
        },
    ];
}

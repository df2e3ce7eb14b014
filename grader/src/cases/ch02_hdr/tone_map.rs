//! `tone_map`: random questions, judge and mistakes.

use super::{channels, colour};
use crate::upon::changed;
use crate::{Graded, Mistake, Picture, Verdict};
use raybook::image::rgb::Rgb;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch02_hdr::ToneMap;

impl Graded for ToneMap {
    fn random(rng: &mut Pcg) -> ToneMap {
        ToneMap {
            radiance: colour(rng, 8.0),
        }
    }

    fn judge(_q: &ToneMap, golden: &Rgb, got: &Rgb) -> Verdict {
        channels(*golden, *got)
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "maps each channel by itself",
            hint: "Tone map the orange (4, 2, 0): is there still twice as much red as green?",
            answer: |q| mapped(q, |how| how.apply = each_alone),
        },
        Mistake {
            name: "takes the mean of the channels for the luminance",
            hint: "Which of red, green and blue looks brightest to the eye?",
            answer: |q| mapped(q, |how| how.luminance = |Rgb { r, g, b }| (r + g + b) / 3.0),
        },
        Mistake {
            name: "takes the length of the colour as a vector for the luminance",
            hint: "White is (1, 1, 1), and its luminance is 1: what is the length of this vector?",
            answer: |q| {
                mapped(q, |how| {
                    how.luminance = |Rgb { r, g, b }| (r * r + g * g + b * b).sqrt();
                })
            },
        },
        Mistake {
            name: "takes the green channel for the luminance",
            hint: "Green looks brightest to the eye: how bright is a pure red?",
            answer: |q| mapped(q, |how| how.luminance = |colour| colour.g),
        },
        Mistake {
            name: "returns gray",
            hint: "L/(1 + L) is the new luminance; what becomes of the colour?",
            answer: |q| mapped(q, |how| how.apply = |_, l, share| Rgb::gray(l * share(l))),
        },
        Mistake {
            name: "divides by the luminance alone",
            hint: "A dark colour should stay dark: does yours?",
            answer: |q| mapped(q, |how| how.share = |l| 1.0 / l),
        },
        Mistake {
            name: "divides by the luminance, which is 0 for black",
            hint: "What is 0/0, and which colour should black become?",
            answer: |q| mapped(q, |how| how.share = |l| l / (1.0 + l) / l),
        },
        Mistake {
            name: "multiplies by the new luminance",
            hint: "The luminance L must become L/(1 + L): by which factor must the colour be scaled?",
            answer: |q| mapped(q, |how| how.share = |l| l / (1.0 + l)),
        },
        Mistake {
            name: "clamps each channel to the range from 0 to 1",
            hint: "Two bright colours, one twice as bright: can they still be told apart?",
            answer: |q| q.radiance.map(|v| v.clamp(0.0, 1.0)),
        },
        Mistake {
            name: "takes the weights of Rec. 601 for the luminance",
            hint: "0.299, 0.587 and 0.114 are the weights of old television: which weights belong to the primaries of sRGB?",
            answer: |q| {
                mapped(q, |how| {
                    how.luminance = |colour| weighted(colour, [0.299, 0.587, 0.114]);
                })
            },
        },
        Mistake {
            name: "takes the largest channel for the luminance",
            hint: "Does blue count as much as green?",
            answer: |q| mapped(q, |how| how.luminance = Rgb::max_channel),
        },
        Mistake {
            name: "takes 1 − e^(−v) of each channel",
            hint: "That is another curve, a film's: which curve does the task name?",
            answer: |q| mapped(q, |how| (how.share, how.apply) = (films, each_alone)),
        },
        Mistake {
            name: "takes the sum of the channels for the luminance",
            hint: "White, (1, 1, 1), has the luminance 1: what do your weights add up to?",
            answer: |q| mapped(q, |how| how.luminance = |Rgb { r, g, b }| r + g + b),
        },
        Mistake {
            name: "maps the luminance to 1 − e^(−L)",
            hint: "That is another curve, a film's: what does Reinhard's make of L = 1?",
            answer: |q| mapped(q, |how| how.share = films),
        },
        Mistake {
            name: "uses Reinhard's formula with a white point of 4",
            hint: "A luminance L becomes L/(1 + L): where does another constant in your formula come from?",
            answer: |q| mapped(q, |how| how.share = |l| (1.0 + l / 16.0) / (1.0 + l)),
        },
        Mistake {
            name: "uses Reinhard's formula with a white point of 2",
            hint: "A luminance L becomes L/(1 + L): where does another constant in your formula come from?",
            answer: |q| mapped(q, |how| how.share = |l| (1.0 + l / 4.0) / (1.0 + l)),
        },
        Mistake {
            name: "takes the weights of Rec. 2020 for the luminance",
            hint: "0.2627, 0.678 and 0.0593 belong to the primaries of television in ultra-high definition: which weights belong to those of sRGB?",
            answer: |q| {
                mapped(q, |how| {
                    how.luminance = |colour| weighted(colour, [0.2627, 0.678, 0.0593]);
                })
            },
        },
        Mistake {
            name: "exchanges the weights of red and blue in the luminance",
            hint: "Which looks brighter to the eye: a pure red, or a pure blue?",
            answer: |q| {
                mapped(q, |how| {
                    how.luminance = |colour| weighted(colour, [0.0722, 0.7152, 0.2126]);
                })
            },
        },
        Mistake {
            name: "takes the mean of the largest and the smallest channel for the luminance",
            hint: "Does blue count as much as green, and does the channel in the middle not count?",
            answer: |q| {
                mapped(q, |how| {
                    how.luminance = |colour| {
                        let least = colour.channels().into_iter().fold(f32::INFINITY, f32::min);
                        0.5 * (colour.max_channel() + least)
                    };
                })
            },
        },
        Mistake {
            name: "clamps the mapped channels to 1",
            hint: "It is the luminance that stays below 1: may a single channel exceed it, and what becomes of the colour if you cut it off?",
            answer: |q| ToneMap::right(q).map(|v| v.min(1.0)),
        },
        Mistake {
            name: "uses a film's curve, that of ACES, for each channel",
            hint: "2.51, 2.43 and 0.59: where do these numbers come from, and which curve does the task name?",
            answer: |q| {
                q.radiance
                    .map(|v| v * (2.51 * v + 0.03) / (v * (2.43 * v + 0.59) + 0.14))
            },
        },
        Mistake {
            name: "multiplies by a key of 0.18 first",
            hint: "In Reinhard's paper the key makes the picture brighter or darker before it is mapped: does the task ask for that?",
            answer: |q| Self::misread(q, |q| q.radiance = q.radiance * 0.18),
        },
        Mistake {
            name: "leaves colours alone whose luminance is at most 1",
            hint: "A luminance of 1 becomes ½: what does a luminance of ½ become?",
            answer: |q| {
                mapped(q, |how| {
                    // White has the luminance 1 but for rounding.
                    how.share = |l| if l < 1.0001 { 1.0 } else { 1.0 / (1.0 + l) };
                })
            },
        },
        Mistake {
            name: "adds the same number to each channel, in the place of scaling all of them",
            hint: "The orange (4, 2, 0) has no blue: has yours, and is there still twice as much red as green?",
            answer: |q| {
                mapped(q, |how| {
                    how.apply = |colour, l, share| colour.map(|v| v + l * share(l) - l);
                })
            },
        },
        Mistake {
            name: "mixes the mapping of the luminance with that of each channel",
            hint: "Tone map the orange (4, 2, 0): is there still twice as much red as green?",
            answer: |q| {
                mapped(q, |how| {
                    how.apply = |colour, l, share| {
                        colour.map(|v| {
                            let alone = v * share(v);
                            (1.0 - alone) * v * share(l) + alone * alone
                        })
                    };
                })
            },
        },
    ];

    const PICTURES: &'static [Picture<Self>] = &[Picture {
        name: "tone_map",
        width: 96,
        height: 54,
        alt: "Colours from left to right by hue, upwards ever brighter",
        question: |x, y| {
            let hue = x as f32 / 96.0 * 6.0;
            let wave = |shift: f32| {
                (0.5 + 0.5 * ((hue - shift) * std::f32::consts::FRAC_PI_3).cos()).max(0.02)
            };
            let brightness = ((53 - y) as f32 / 53.0 * 6.0 - 3.0).exp2();
            ToneMap {
                radiance: Rgb::new(wave(0.0), wave(2.0), wave(4.0)) * brightness,
            }
        },
        colour: |_, mapped| *mapped,
    }];
}

/// What a luminance becomes, as a share of what it was.
type Share = fn(f32) -> f32;

/// How a colour is mapped; one field wrong is a mistake.
#[derive(Clone, Copy)]
struct How {
    /// The luminance of a colour.
    luminance: fn(Rgb) -> f32,
    share: Share,
    /// What becomes of a colour of the luminance `l`.
    apply: fn(colour: Rgb, l: f32, share: Share) -> Rgb,
}

/// As it should be.
const WELL: How = How {
    luminance: |colour| colour.luminance(),
    share: |l| 1.0 / (1.0 + l),
    apply: |colour, l, share| colour * share(l),
};

/// The colour, mapped rightly but for what is changed.
fn mapped(q: &ToneMap, change: fn(&mut How)) -> Rgb {
    let how = changed(WELL, change);
    (how.apply)(q.radiance, (how.luminance)(q.radiance), how.share)
}

/// Each channel is mapped as if it were the luminance.
fn each_alone(colour: Rgb, _: f32, share: Share) -> Rgb {
    colour.map(|v| v * share(v))
}

/// Of a luminance that becomes 1 − e^(−L), as on a film.
fn films(l: f32) -> f32 {
    if l > 0.0 { (1.0 - (-l).exp()) / l } else { 1.0 }
}

/// A luminance with other weights of red, green and blue.
fn weighted(Rgb { r, g, b }: Rgb, [red, green, blue]: [f32; 3]) -> f32 {
    red * r + green * g + blue * b
}

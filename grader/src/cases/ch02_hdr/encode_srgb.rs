//! `encode_srgb`: random questions, judge and mistakes.

use crate::upon::changed;
use crate::{Graded, Mistake, Picture, Verdict, judge, sample};
use rand::RngExt;
use raybook::image::rgb::Rgb;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch02_hdr::EncodeSrgb;

impl Graded for EncodeSrgb {
    fn random(rng: &mut Pcg) -> EncodeSrgb {
        let v = sample::number(rng, 0.0, 1.0).powi(2); // more of them near black
        // One value in six is above 1, and one in six is below 0: more of them near these ends.
        let v = match rng.random_range(0..6) {
            0 => 1.0 + v,
            1 => -0.5 * v,
            _ => v,
        };
        EncodeSrgb { v }
    }

    fn judge(_q: &EncodeSrgb, golden: &f32, got: &f32) -> Verdict {
        // A twentieth of the step of a byte: finer than anyone sees, coarser than any pow.
        judge::number_within("the code value", "", *golden, *got, 2e-4)
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "uses a pure power, a gamma of 2.2, in place of sRGB's curve",
            hint: "sRGB is not a pure power: what is it near black?",
            answer: |q| {
                encoded(q, |how| {
                    how.bend = f32::NEG_INFINITY;
                    how.curve = |v, _| v.powf(1.0 / 2.2);
                })
            },
        },
        Mistake {
            name: "decodes instead of encoding",
            hint: "Half the light looks more than half as bright: is the code value larger or smaller than v?",
            answer: |q| {
                encoded(q, |how| {
                    how.bend = f32::NEG_INFINITY;
                    how.curve = |v, _| raybook::image::tone::decode_srgb(v);
                })
            },
        },
        Mistake {
            name: "forgets the straight piece near black",
            hint: "Try v = 0: is the code value 0?",
            answer: |q| encoded(q, |how| how.bend = f32::NEG_INFINITY),
        },
        Mistake {
            name: "takes 2.4 for the exponent, not its inverse",
            hint: "Does the curve rise above v or sag below it?",
            answer: |q| encoded(q, |how| how.exponent = 2.4),
        },
        Mistake {
            name: "does not clamp",
            hint: "A display has no code value above 1 or below 0.",
            answer: |q| encoded(q, |how| how.range = [f32::NEG_INFINITY, f32::INFINITY]),
        },
        Mistake {
            name: "leaves v as it is",
            hint: "Does half of the light look half as bright to the eye?",
            answer: |q| encoded(q, |how| (how.bend, how.slope) = (f32::INFINITY, 1.0)),
        },
        Mistake {
            name: "forgets the 0.055 at the end",
            hint: "Try v = 1: is the code value 1?",
            answer: |q| encoded(q, |how| how.curve = |v, exponent| 1.055 * v.powf(exponent)),
        },
        Mistake {
            name: "takes the threshold of the inverse curve",
            hint: "The standard has two thresholds, one for encoding and one for decoding: is yours a linear value or a code value?",
            answer: |q| encoded(q, |how| how.bend = 0.040_45),
        },
        Mistake {
            name: "takes ten times the threshold",
            hint: "Count the zeros of your threshold: below which linear value is the curve a straight line?",
            answer: |q| encoded(q, |how| how.bend = 0.031_308),
        },
        Mistake {
            name: "takes 1/2.2 for the exponent of the curve",
            hint: "Which exponent stands in the formula, and which in your program?",
            answer: |q| encoded(q, |how| how.exponent = 1.0 / 2.2),
        },
        Mistake {
            name: "takes the factor 1.055 into the power",
            hint: "Which comes first: the power of v, or the product with 1.055?",
            answer: |q| {
                encoded(q, |how| {
                    how.curve = |v, exponent| (1.055 * v).powf(exponent) - 0.055;
                })
            },
        },
        Mistake {
            name: "divides by 12.92 near black",
            hint: "The straight piece rises above v: which of 12.92 v and v/12.92 does?",
            answer: |q| encoded(q, |how| how.slope = 1.0 / 12.92),
        },
        Mistake {
            name: "takes a pure power, a gamma of 2.2, above the straight piece",
            hint: "What stands beside the power of v in the formula, and which exponent has it?",
            answer: |q| encoded(q, |how| how.curve = |v, _| v.powf(1.0 / 2.2)),
        },
        Mistake {
            name: "returns a whole number from 0 to 255",
            hint: "The code value of white: which number does the task call it?",
            answer: |q| (255.0 * EncodeSrgb::right(q)).round(),
        },
        Mistake {
            name: "takes the 0.055 and the 1.055 into the power, as in the inverse curve",
            hint: "Try v = 1 and v = 0.5 with both curves: in which of them is the power of v alone?",
            answer: |q| {
                encoded(q, |how| {
                    how.curve = |v, exponent| ((v + 0.055) / 1.055).powf(exponent);
                })
            },
        },
        Mistake {
            name: "compares the code value with the threshold, and not v",
            hint: "The threshold is a linear value: which of the two numbers of your comparison is one?",
            answer: |q| encoded(q, |how| how.bend = 0.003_130_8 / 12.92),
        },
        Mistake {
            name: "uses the curve of Rec. 709, television's, in place of sRGB's",
            hint: "4.5, 1.099 and 0.45 belong to another standard with the same primaries: which numbers does the task name?",
            answer: |q| {
                encoded(q, |how| {
                    how.bend = 0.018;
                    how.slope = 4.5;
                    how.curve = |v, _| 1.099 * v.powf(0.45) - 0.099;
                })
            },
        },
        Mistake {
            name: "uses a pure power, a gamma of 2.4, in place of sRGB's curve",
            hint: "The exponent is that of the formula; what else stands in it, and what is the curve near black?",
            answer: |q| {
                encoded(q, |how| {
                    how.bend = f32::NEG_INFINITY;
                    how.curve = |v, _| v.powf(1.0 / 2.4);
                })
            },
        },
        Mistake {
            name: "takes the square root, a gamma of 2, in place of sRGB's curve",
            hint: "The root comes close, and is not the standard: which two pieces has sRGB's curve?",
            answer: |q| {
                encoded(q, |how| {
                    how.bend = f32::NEG_INFINITY;
                    how.curve = |v, _| v.sqrt();
                })
            },
        },
        Mistake {
            name: "does not clamp values above 1",
            hint: "What is the code value of something brighter than white?",
            answer: |q| encoded(q, |how| how.range[1] = f32::INFINITY),
        },
        Mistake {
            name: "does not clamp values below 0",
            hint: "What is the code value of something below black?",
            answer: |q| encoded(q, |how| how.range[0] = f32::NEG_INFINITY),
        },
        Mistake {
            name: "takes 1/2.2 for the exponent of the curve, and does not clamp values above 1",
            hint: "Which exponent stands in the formula, and which in your program? And what is the code value of something brighter than white?",
            answer: |q| {
                encoded(q, |how| {
                    how.exponent = 1.0 / 2.2;
                    how.range[1] = f32::INFINITY;
                })
            },
        },
        Mistake {
            name: "takes 1/2.2 for the exponent of the curve, and does not clamp",
            hint: "Which exponent stands in the formula, and which in your program? And what are the least and the greatest code values of a display?",
            answer: |q| {
                encoded(q, |how| {
                    how.exponent = 1.0 / 2.2;
                    how.range = [f32::NEG_INFINITY, f32::INFINITY];
                })
            },
        },
        Mistake {
            name: "uses a pure power, a gamma of 2.2, in place of sRGB's curve, and does not clamp values above 1",
            hint: "sRGB is not a pure power: what is it near black? And what is the code value of something brighter than white?",
            answer: |q| {
                encoded(q, |how| {
                    how.bend = f32::NEG_INFINITY;
                    how.curve = |v, _| v.powf(1.0 / 2.2);
                    how.range[1] = f32::INFINITY;
                })
            },
        },
        Mistake {
            name: "forgets the straight piece near black, and does not clamp values above 1",
            hint: "Try v = 0: is the code value 0? And what is the code value of something brighter than white?",
            answer: |q| {
                encoded(q, |how| {
                    how.bend = f32::NEG_INFINITY;
                    how.range[1] = f32::INFINITY;
                })
            },
        },
        Mistake {
            name: "divides v by 2.4, as v^1/2.4 does without brackets",
            hint: "What does your language calculate first in v^1/2.4: the power or the quotient?",
            answer: |q| {
                encoded(q, |how| {
                    how.curve = |v, exponent| 1.055 * v * exponent - 0.055;
                })
            },
        },
        Mistake {
            name: "subtracts the 0.055 from the exponent",
            hint: "How far does the exponent go: where do its brackets end?",
            answer: |q| {
                encoded(q, |how| {
                    how.curve = |v, exponent| 1.055 * v.powf(exponent - 0.055);
                })
            },
        },
    ];

    const PICTURES: &'static [Picture<Self>] = &[Picture {
        name: "encode_srgb",
        width: 96,
        height: 8,
        alt: "A gray ramp by code value, from black to white",
        question: |x, _| EncodeSrgb { v: x as f32 / 95.0 },
        colour: |_, code| Rgb::gray(*code),
    }];
}

/// How a value is encoded; one field wrong is a mistake.
#[derive(Clone, Copy)]
struct How {
    /// The least value and the greatest, to which others are clamped.
    range: [f32; 2],
    /// The value up to which the curve is a straight line.
    bend: f32,
    /// The slope of this line.
    slope: f32,
    /// The curve above it.
    curve: fn(v: f32, exponent: f32) -> f32,
    exponent: f32,
}

/// As it should be.
const WELL: How = How {
    range: [0.0, 1.0],
    bend: 0.003_130_8,
    slope: 12.92,
    curve: |v, exponent| 1.055 * v.powf(exponent) - 0.055,
    exponent: 1.0 / 2.4,
};

/// The code value, rightly but for what is changed.
fn encoded(q: &EncodeSrgb, change: fn(&mut How)) -> f32 {
    let how = changed(WELL, change);
    let [least, greatest] = how.range;
    let v = q.v.clamp(least, greatest);
    if v <= how.bend {
        how.slope * v
    } else {
        (how.curve)(v, how.exponent)
    }
}

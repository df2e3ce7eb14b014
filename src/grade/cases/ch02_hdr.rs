//! Chapter 2: `expose`, `tone_map`, `encode_srgb`.

use crate::grade::examine::Examiner;
use crate::grade::{Edge, Graded, Mistake, Picture, Verdict, judge, sample};
use crate::image::rgb::Rgb;
use crate::math::pcg::Pcg;
use crate::workbook::exercise::Exercise;
use crate::workbook::exercises::ch02_hdr::{
    EncodeSrgb, EncodeSrgbQuestion, Expose, ExposeQuestion, ToneMap, ToneMapQuestion,
};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&Expose, &ToneMap, &EncodeSrgb];

impl Graded for Expose {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "multiplies by the number of stops",
            hint: "What should an exposure of 0 stops do?",
            answer: |q| q.radiance * q.stops,
        },
        Mistake {
            name: "has the direction of a stop wrong",
            hint: "One stop more: twice the light, or half of it?",
            answer: |q| q.radiance * (-q.stops).exp2(),
        },
        Mistake {
            name: "takes e for the base",
            hint: "By what factor does one stop change the light?",
            answer: |q| q.radiance * q.stops.exp(),
        },
        Mistake {
            name: "clamps to 1",
            hint: "Radiance has no upper limit; where does the limit belong?",
            answer: |q| Expose::answer(q).map(|v| v.clamp(0.0, 1.0)),
        },
        Mistake {
            name: "adds the stops",
            hint: "Expose black: how bright is it afterwards?",
            answer: |q| q.radiance.map(|v| v + q.stops),
        },
        Mistake {
            name: "doubles once for any number of stops",
            hint: "Two stops more: how many times the light?",
            answer: |q| q.radiance * if q.stops > 0.0 { 2.0 } else { 0.5 },
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, r, g, b, stops| {
            Edge::new(
                name,
                ExposeQuestion {
                    radiance: Rgb::new(r, g, b),
                    stops,
                },
            )
        };
        vec![
            edge("no change", 0.2, 0.5, 0.8, 0.0),
            edge("one stop more", 0.1, 0.2, 0.3, 1.0),
            edge("one stop less", 0.1, 0.2, 0.3, -1.0),
            edge("half a stop", 1.0, 1.0, 1.0, 0.5),
            edge("black stays black", 0.0, 0.0, 0.0, 10.0),
            edge("the sun, ten stops down", 60000.0, 50000.0, 40000.0, -10.0),
            edge("beyond white", 0.5, 1.5, 20.0, 3.0),
        ]
    }

    fn random(rng: &mut Pcg) -> ExposeQuestion {
        ExposeQuestion {
            radiance: colour(rng, 4.0),
            stops: sample::number(rng, -6.0, 6.0),
        }
    }

    fn judge(_q: &ExposeQuestion, golden: &Rgb, got: &Rgb) -> Verdict {
        channels(*golden, *got)
    }
}

impl Graded for ToneMap {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "maps each channel by itself",
            hint: "Tone map a pure red and look at its hue: is it scaled by its luminance, or by its channel?",
            answer: |q| q.radiance.map(|v| v / (1.0 + v)),
        },
        Mistake {
            name: "takes the mean of the channels for the luminance",
            hint: "Which of red, green and blue looks brightest to the eye?",
            answer: |q| q.radiance / (1.0 + (q.radiance.r + q.radiance.g + q.radiance.b) / 3.0),
        },
        Mistake {
            name: "returns gray",
            hint: "L/(1 + L) is the new luminance; what becomes of the colour?",
            answer: |q| Rgb::gray(q.radiance.luminance() / (1.0 + q.radiance.luminance())),
        },
        Mistake {
            name: "divides by the luminance alone",
            hint: "What should become of something dark?",
            answer: |q| q.radiance / q.radiance.luminance(),
        },
        Mistake {
            name: "multiplies by the new luminance",
            hint: "You want the luminance to become L/(1 + L): by which factor must it be scaled?",
            answer: |q| q.radiance * (q.radiance.luminance() / (1.0 + q.radiance.luminance())),
        },
        Mistake {
            name: "clamps",
            hint: "Two bright colours, one twice as bright: can they still be told apart?",
            answer: |q| q.radiance.map(|v| v.clamp(0.0, 1.0)),
        },
    ];

    const PICTURE: Option<Picture<Self>> = Some(Picture {
        width: 96,
        height: 54,
        alt: "Colours from left to right by hue, upwards ever brighter",
        question: |x, y| {
            let hue = x as f32 / 96.0 * 6.0;
            let wave = |shift: f32| {
                (0.5 + 0.5 * ((hue - shift) * std::f32::consts::FRAC_PI_3).cos()).max(0.02)
            };
            let brightness = ((53 - y) as f32 / 53.0 * 6.0 - 3.0).exp2();
            ToneMapQuestion {
                radiance: Rgb::new(wave(0.0), wave(2.0), wave(4.0)) * brightness,
            }
        },
        colour: |_, mapped| *mapped,
    });

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, r, g, b| {
            Edge::new(
                name,
                ToneMapQuestion {
                    radiance: Rgb::new(r, g, b),
                },
            )
        };
        vec![
            edge("gray 1 becomes 1/2", 1.0, 1.0, 1.0),
            edge("gray 3 becomes 3/4", 3.0, 3.0, 3.0),
            edge("dark stays nearly as it is", 0.001, 0.002, 0.001),
            edge("pure red", 4.0, 0.0, 0.0),
            edge("pure green", 0.0, 4.0, 0.0),
            edge("pure blue, which may exceed 1", 0.0, 0.0, 40.0),
            edge("the sun", 60000.0, 50000.0, 40000.0),
        ]
    }

    fn random(rng: &mut Pcg) -> ToneMapQuestion {
        ToneMapQuestion {
            radiance: colour(rng, 8.0),
        }
    }

    fn judge(_q: &ToneMapQuestion, golden: &Rgb, got: &Rgb) -> Verdict {
        channels(*golden, *got)
    }
}

impl Graded for EncodeSrgb {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "takes sRGB for a gamma of 2.2",
            hint: "sRGB is not a pure power: what is it near black?",
            answer: |q| q.v.clamp(0.0, 1.0).powf(1.0 / 2.2),
        },
        Mistake {
            name: "decodes instead of encoding",
            hint: "Half the light looks more than half as bright: is the code value larger or smaller than v?",
            answer: |q| crate::image::tone::decode_srgb(q.v.clamp(0.0, 1.0)),
        },
        Mistake {
            name: "forgets the straight piece near black",
            hint: "Try v = 0: is the code value 0?",
            answer: |q| 1.055 * q.v.clamp(0.0, 1.0).powf(1.0 / 2.4) - 0.055,
        },
        Mistake {
            name: "takes 2.4 for the exponent, not its inverse",
            hint: "Does the curve rise above v or sag below it?",
            answer: |q| {
                let v = q.v.clamp(0.0, 1.0);
                if v <= 0.003_130_8 {
                    12.92 * v
                } else {
                    1.055 * v.powf(2.4) - 0.055
                }
            },
        },
        Mistake {
            name: "does not clamp",
            hint: "A display has no code value above 1 or below 0.",
            answer: |q| {
                if q.v <= 0.003_130_8 {
                    12.92 * q.v
                } else {
                    1.055 * q.v.powf(1.0 / 2.4) - 0.055
                }
            },
        },
        Mistake {
            name: "leaves v as it is",
            hint: "Is 0.5 half as bright to the eye?",
            answer: |q| q.v.clamp(0.0, 1.0),
        },
        Mistake {
            name: "forgets the 0.055 at the end",
            hint: "Try v = 1: is the code value 1?",
            answer: |q| {
                let v = q.v.clamp(0.0, 1.0);
                if v <= 0.003_130_8 {
                    12.92 * v
                } else {
                    1.055 * v.powf(1.0 / 2.4)
                }
            },
        },
    ];

    const PICTURE: Option<Picture<Self>> = Some(Picture {
        width: 96,
        height: 8,
        alt: "A gray ramp by code value, from black to white",
        question: |x, _| EncodeSrgbQuestion { v: x as f32 / 95.0 },
        colour: |_, code| Rgb::gray(*code),
    });

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, v| Edge::new(name, EncodeSrgbQuestion { v });
        vec![
            edge("black", 0.0),
            edge("white", 1.0),
            edge("middle gray", 0.18),
            edge("half the light", 0.5),
            edge("on the straight piece", 0.002),
            edge("where the pieces meet", 0.003_130_8),
            edge("brighter than white", 7.5),
            edge("below black", -0.25),
        ]
    }

    fn random(rng: &mut Pcg) -> EncodeSrgbQuestion {
        let v = sample::number(rng, 0.0, 1.0);
        EncodeSrgbQuestion { v: v * v } // more of them near black
    }

    fn judge(_q: &EncodeSrgbQuestion, golden: &f32, got: &f32) -> Verdict {
        // A twentieth of the step of a byte: finer than anyone sees, coarser than any pow.
        judge::number_within("the code value", "", *golden, *got, 2e-4)
    }
}

/// A colour whose channels are up to so much.
fn colour(rng: &mut Pcg, most: f32) -> Rgb {
    Rgb::new(
        sample::number(rng, 0.05, most),
        sample::number(rng, 0.05, most),
        sample::number(rng, 0.05, most),
    )
}

fn channels(golden: Rgb, got: Rgb) -> Verdict {
    for (name, golden, got) in [
        ("red", golden.r, got.r),
        ("green", golden.g, got.g),
        ("blue", golden.b, got.b),
    ] {
        judge::number_within(
            name,
            "",
            golden,
            got,
            judge::RELATIVE * golden.abs().max(0.01),
        )?;
    }
    Ok(())
}

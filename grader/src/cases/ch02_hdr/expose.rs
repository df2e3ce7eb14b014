//! `expose`: random questions, judge and mistakes.

use super::{channels, colour};
use crate::upon::changed;
use crate::{Graded, Mistake, Verdict, sample};
use raybook::image::rgb::Rgb;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch02_hdr::Expose;

impl Graded for Expose {
    fn random(rng: &mut Pcg) -> Expose {
        Expose {
            radiance: colour(rng, 4.0),
            stops: sample::number(rng, -6.0, 6.0),
        }
    }

    fn judge(_q: &Expose, golden: &Rgb, got: &Rgb) -> Verdict {
        channels(*golden, *got)
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "multiplies by the number of stops",
            hint: "What should an exposure of 0 stops do?",
            answer: |q| exposed(q, |how| how.factor = |stops| stops),
        },
        Mistake {
            name: "has the direction of a stop wrong",
            hint: "One stop more: twice the light, or half of it?",
            answer: |q| exposed(q, |how| how.factor = |stops| (-stops).exp2()),
        },
        Mistake {
            name: "takes e for the base of the power",
            hint: "By what factor does one stop change the light?",
            answer: |q| exposed(q, |how| how.factor = f32::exp),
        },
        Mistake {
            name: "clamps to 1",
            hint: "Radiance has no upper limit; where does the limit belong?",
            answer: |q| Expose::right(q).map(|v| v.clamp(0.0, 1.0)),
        },
        Mistake {
            name: "multiplies by 1 plus the number of stops",
            hint: "Two stops more: how many times as bright is the picture? And one stop less?",
            answer: |q| exposed(q, |how| how.factor = |stops| 1.0 + stops),
        },
        Mistake {
            name: "adds the stops",
            hint: "Expose black: how bright is it afterwards?",
            answer: |q| exposed(q, |how| (how.factor, how.apply) = (|stops| stops, added)),
        },
        Mistake {
            name: "doubles or halves once, whatever the number of stops",
            hint: "Two stops more: how many times the light?",
            answer: |q| {
                exposed(q, |how| {
                    how.factor = |stops| if stops > 0.0 { 2.0 } else { 0.5 }
                })
            },
        },
        Mistake {
            name: "takes 10 for the base of the power",
            hint: "By what factor does one stop change the light?",
            answer: |q| exposed(q, |how| how.factor = |stops| 10_f32.powf(stops)),
        },
        Mistake {
            name: "squares the number of stops in the exponent",
            hint: "Two stops more: how many times the light? And two stops less?",
            answer: |q| exposed(q, |how| how.factor = |stops| (stops * stops).exp2()),
        },
        Mistake {
            name: "multiplies by the square of the number of stops, not by a power of 2",
            hint: "Three stops: is that 3², or 2³?",
            answer: |q| exposed(q, |how| how.factor = |stops| stops * stops),
        },
        Mistake {
            name: "adds 2^stops instead of multiplying by it",
            hint: "Twice the light is twice the radiance of every channel: what becomes of black?",
            answer: |q| exposed(q, |how| how.apply = added),
        },
        Mistake {
            name: "takes √2 for the base of the power, as for f-numbers",
            hint: "One stop more is twice the light; it is the aperture's diameter that grows by √2: by what factor does one stop change the light?",
            answer: |q| exposed(q, |how| how.factor = |stops| (0.5 * stops).exp2()),
        },
        Mistake {
            name: "returns 1 − e^(−v) of each exposed channel v, which is a tone mapping",
            hint: "One stop more is twice the light, however bright it is: where does a curve come in?",
            answer: |q| {
                exposed(q, |how| {
                    how.apply = |colour, factor| colour.map(|v| 1.0 - (-v * factor).exp());
                })
            },
        },
        Mistake {
            name: "multiplies by 1 plus the number of stops, and for less light divides by it",
            hint: "Two stops more: how many times as bright is the picture? And three?",
            answer: |q| {
                exposed(q, |how| {
                    how.factor = |stops| {
                        if stops >= 0.0 {
                            1.0 + stops
                        } else {
                            1.0 / (1.0 - stops)
                        }
                    };
                })
            },
        },
        Mistake {
            name: "takes powers of 2 for whole stops only, and interpolates linearly between two of them",
            hint: "Half a stop twice is a whole stop, which is twice the light: by which factor is half a stop?",
            answer: |q| {
                exposed(q, |how| {
                    how.factor = |stops| between_whole(stops, stops.floor());
                })
            },
        },
        Mistake {
            name: "cuts off the number of stops behind the decimal point for the power of 2, and multiplies by 1 plus the rest",
            hint: "Half a stop twice is a whole stop, which is twice the light: by which factor is half a stop?",
            answer: |q| {
                exposed(q, |how| {
                    how.factor = |stops| between_whole(stops, stops.trunc());
                })
            },
        },
        Mistake {
            name: "rounds the number of stops to a whole number",
            hint: "Half a stop: is the picture as bright as before, twice as bright, or something between?",
            answer: |q| exposed(q, |how| how.factor = |stops| stops.round_ties_even().exp2()),
        },
        Mistake {
            name: "doubles once for each whole stop, and never halves",
            hint: "A negative number of stops: how often does your loop go round? And half a stop?",
            answer: |q| exposed(q, |how| how.factor = |stops| stops.max(0.0).floor().exp2()),
        },
        Mistake {
            name: "multiplies by twice the number of stops, and for less light divides by it",
            hint: "Three stops more: is that 2 · 3, or 2 · 2 · 2?",
            answer: |q| {
                exposed(q, |how| {
                    how.factor = |stops| {
                        if stops > 0.0 {
                            2.0 * stops
                        } else if stops < 0.0 {
                            -0.5 / stops
                        } else {
                            1.0
                        }
                    };
                })
            },
        },
        Mistake {
            name: "multiplies by twice the number of stops",
            hint: "What should an exposure of 0 stops do? And is three stops more 2 · 3, or 2 · 2 · 2?",
            answer: |q| exposed(q, |how| how.factor = |stops| 2.0 * stops),
        },
        Mistake {
            name: "takes 10^(0.3 · stops) for 2^stops, as with decibels",
            hint: "Is 10^0.3 exactly 2? By what factor do ten stops change the light, and by what factor does your formula?",
            answer: |q| exposed(q, |how| how.factor = |stops| 10_f32.powf(0.3 * stops)),
        },
        Mistake {
            name: "takes e^(0.7 · stops) for 2^stops",
            hint: "Is e^0.7 exactly 2? By what factor do ten stops change the light, and by what factor does your formula?",
            answer: |q| exposed(q, |how| how.factor = |stops| (0.7 * stops).exp()),
        },
        Mistake {
            name: "takes e^(0.69 · stops) for 2^stops",
            hint: "Is e^0.69 exactly 2? By what factor do ten stops change the light, and by what factor does your formula?",
            answer: |q| exposed(q, |how| how.factor = |stops| (0.69 * stops).exp()),
        },
        Mistake {
            name: "cuts off the number of stops behind the decimal point",
            hint: "Half a stop: is the picture as bright as before, twice as bright, or something between?",
            answer: |q| exposed(q, |how| how.factor = |stops| stops.trunc().exp2()),
        },
        Mistake {
            name: "rounds the number of stops down to a whole number",
            hint: "Half a stop: is the picture as bright as before, twice as bright, or something between?",
            answer: |q| exposed(q, |how| how.factor = |stops| stops.floor().exp2()),
        },
        Mistake {
            name: "takes stops for decibels, ten of which make the light ten times as bright",
            hint: "By what factor does one stop change the light?",
            answer: |q| exposed(q, |how| how.factor = |stops| 10_f32.powf(0.1 * stops)),
        },
    ];
}

/// How a colour is exposed; one field wrong is a mistake.
#[derive(Clone, Copy)]
struct How {
    /// The factor of a number of stops.
    factor: fn(stops: f32) -> f32,
    /// What becomes of a colour by the factor.
    apply: fn(colour: Rgb, factor: f32) -> Rgb,
}

/// As it should be.
const WELL: How = How {
    factor: f32::exp2,
    apply: |colour, factor| colour * factor,
};

/// The colour, exposed rightly but for what is changed.
fn exposed(q: &Expose, change: fn(&mut How)) -> Rgb {
    let how = changed(WELL, change);
    (how.apply)(q.radiance, (how.factor)(q.stops))
}

fn added(colour: Rgb, factor: f32) -> Rgb {
    colour + Rgb::gray(factor)
}

/// The power of 2 of a whole number of stops, times 1 plus the rest of them.
fn between_whole(stops: f32, whole: f32) -> f32 {
    whole.exp2() * (1.0 + stops - whole)
}

//! `phong`: random questions, judge and mistakes.

use super::highlight::{
    BALL, ambient, from_above, greater_term, half, highlight_without_light, matte_from_below,
    matte_without_cosine, mirrored, on_ball, power, power_of_colour, power_of_more, radiance,
    random, shining_through, with_highlight, with_terms,
};
use crate::{Graded, Mistake, Picture, Verdict};
use raybook::image::rgb::Rgb;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch12_phong::{Highlight, PhongExercise};
use std::f32::consts::{PI, TAU};

/// (R·V)^α.
fn highlight(q: &Highlight) -> f32 {
    power(mirrored(q).dot(*q.view), q)
}

impl Graded for PhongExercise {
    fn random(rng: &mut Pcg) -> Self {
        Self { at: random(rng) }
    }

    fn judge(_q: &Self, golden: &Rgb, got: &Rgb) -> Verdict {
        radiance(*golden, *got)
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "lets the highlight shine through from behind",
            hint: "Put the light below the surface: the diffuse part vanishes; does everything?",
            answer: |q| with_terms(&q.at, highlight(&q.at), shining_through),
        },
        Mistake {
            name: "lets the highlight shine from behind, mirrored with a cosine of 0",
            hint: "Put the light below the surface: the diffuse part vanishes; does everything?",
            answer: |q| {
                let cosine = q.at.toward.dot(*q.at.normal).max(0.0);
                let mirrored = 2.0 * cosine * *q.at.normal - *q.at.toward;
                let highlight = q.at.specular * power(mirrored.dot(*q.at.view), &q.at);
                (q.at.diffuse * cosine + highlight) * q.at.arriving
            },
        },
        Mistake {
            name: "lets a light from behind take light away",
            hint: "Is any of your channels ever negative? There is no negative light.",
            answer: |q| {
                let diffuse = q.at.diffuse * q.at.toward.dot(*q.at.normal);
                (diffuse + q.at.specular * highlight(&q.at)) * q.at.arriving
            },
        },
        Mistake {
            name: "lights the matte part from both sides",
            hint: "Put the light below the surface: how much of its light arrives at the upper side?",
            answer: |q| PhongExercise::right(q) + matte_from_below(&q.at),
        },
        Mistake {
            name: "mirrors the wrong way",
            hint: "Draw L, N and R: on which side of the surface does your R end?",
            answer: |q| with_highlight(&q.at, power(-mirrored(&q.at).dot(*q.at.view), &q.at)),
        },
        Mistake {
            name: "takes the light's direction for its mirror direction",
            hint: "Where do you have to stand to see a lamp in a polished floor: beside the lamp?",
            answer: |q| with_highlight(&q.at, power(q.at.toward.dot(*q.at.view), &q.at)),
        },
        Mistake {
            name: "takes N·H for R·V",
            hint: "That is Blinn's highlight: which two directions does Phong compare?",
            answer: |q| with_highlight(&q.at, power(half(&q.at).dot(*q.at.normal), &q.at)),
        },
        Mistake {
            name: "has a highlight on the far side too",
            hint: "An even power of a negative number is positive: what if R and V point away from each other?",
            answer: |q| {
                with_highlight(
                    &q.at,
                    mirrored(&q.at).dot(*q.at.view).abs().powf(q.at.exponent),
                )
            },
        },
        Mistake {
            name: "multiplies by the exponent instead of raising to it",
            hint: "Raise α: the highlight should become smaller, and stay as bright in its middle.",
            answer: |q| {
                with_highlight(
                    &q.at,
                    q.at.exponent * mirrored(&q.at).dot(*q.at.view).max(0.0),
                )
            },
        },
        Mistake {
            name: "multiplies the highlight by L·N",
            hint: "In the formula as it stands, which of the two terms has the factor L·N?",
            answer: |q| {
                with_terms(&q.at, highlight(&q.at), |q, highlight| {
                    from_above(q, q.toward.dot(*q.normal) * highlight)
                })
            },
        },
        Mistake {
            name: "forgets the light i in the highlight",
            hint: "Switch the light off: is your highlight gone?",
            answer: |q| with_terms(&q.at, highlight(&q.at), highlight_without_light),
        },
        Mistake {
            name: "forgets the diffuse term's cosine",
            hint: "Tilt the surface away from the light: does it receive as much?",
            answer: |q| with_terms(&q.at, highlight(&q.at), matte_without_cosine),
        },
        Mistake {
            name: "takes N·V for R·V",
            hint: "Walk around the lamp at the same height: should the highlight follow you?",
            answer: |q| with_highlight(&q.at, power(q.at.normal.dot(*q.at.view), &q.at)),
        },
        Mistake {
            name: "divides k_d by π, as in a BRDF",
            hint: "That belongs to a BRDF, whose light comes from all sides: is there a π in the task's formula?",
            answer: |q| Self::misread(q, |q| q.at.diffuse = q.at.diffuse / PI),
        },
        Mistake {
            name: "exchanges k_d and k_s",
            hint: "Which of the two colours belongs to the matte part, and which to the highlight?",
            answer: |q| Self::misread(q, |q| std::mem::swap(&mut q.at.diffuse, &mut q.at.specular)),
        },
        Mistake {
            name: "forgets the exponent",
            hint: "Raise α: the highlight should become smaller.",
            answer: |q| Self::misread(q, |q| q.at.exponent = 1.0),
        },
        Mistake {
            name: "forgets the 2 of the mirrored direction",
            hint: "Mirror a vector by hand: how often do you take away what is along the normal?",
            answer: |q| {
                let mirrored = q.at.toward.dot(*q.at.normal) * *q.at.normal - *q.at.toward;
                with_highlight(&q.at, power(mirrored.dot(*q.at.view), &q.at))
            },
        },
        Mistake {
            name: "multiplies the highlight by (α + 2)/2",
            hint: "Is the highlight to conserve energy here, or to be as in the formula?",
            answer: |q| {
                with_terms(&q.at, highlight(&q.at), |q, highlight| {
                    from_above(q, 0.5 * (q.exponent + 2.0) * highlight)
                })
            },
        },
        Mistake {
            name: "multiplies the highlight by (α + 2)/2π",
            hint: "Is the highlight to conserve energy here, or to be as in the formula?",
            answer: |q| {
                with_terms(&q.at, highlight(&q.at), |q, highlight| {
                    from_above(q, (q.exponent + 2.0) / TAU * highlight)
                })
            },
        },
        Mistake {
            name: "forgets the light i in the matte part",
            hint: "Switch the light off: is the matte part gone?",
            answer: |q| {
                let highlight = highlight(&q.at);
                if q.at.toward.dot(*q.at.normal) > 0.0 {
                    q.at.diffuse * q.at.toward.dot(*q.at.normal)
                        + q.at.specular * highlight * q.at.arriving
                } else {
                    Rgb::BLACK
                }
            },
        },
        Mistake {
            name: "raises k_s to the exponent too",
            hint: "What stands below α: the cosine alone, or k_s as well?",
            answer: |q| power_of_more(&q.at, mirrored(&q.at).dot(*q.at.view), false),
        },
        Mistake {
            name: "raises the whole sum to the exponent, the diffuse part too",
            hint: "Which of the two terms has an exponent? Raise α: may the matte part change?",
            answer: |q| power_of_more(&q.at, mirrored(&q.at).dot(*q.at.view), true),
        },
        Mistake {
            name: "raises k_s to the exponent, and not the cosine",
            hint: "What stands below α: the cosine, or k_s?",
            answer: |q| power_of_colour(&q.at, mirrored(&q.at).dot(*q.at.view)),
        },
        Mistake {
            name: "raises the exponent to the power of the cosine",
            hint: "Which of the two is the base of the power: the cosine R·V, or α?",
            answer: |q| {
                let cosine = mirrored(&q.at).dot(*q.at.view).max(0.0);
                with_highlight(&q.at, q.at.exponent.powf(cosine))
            },
        },
        Mistake {
            name: "takes the greater of matte part and highlight for their sum",
            hint: "Does the matte part vanish where the highlight is?",
            answer: |q| with_terms(&q.at, highlight(&q.at), greater_term),
        },
        Mistake {
            name: "adds an ambient part, a tenth of k_d i",
            hint: "Put the light below the surface: does anything of it arrive?",
            answer: |q| PhongExercise::right(q) + ambient(&q.at),
        },
        Mistake {
            name: "takes Schlick's quotient x/(α − αx + x) for the power x^α of the highlight",
            hint: "The quotient is a fast approximation, right for x = 0 and x = 1: how large is each of both for x = 0.9?",
            answer: |q| {
                let x = mirrored(&q.at).dot(*q.at.view).max(0.0);
                let quotient = x / (q.at.exponent * (1.0 - x) + x);
                with_highlight(&q.at, if x > 0.0 { quotient } else { 0.0 })
            },
        },
        Mistake {
            name: "takes a bell curve of the angle, e^(−α θ²/2), for the power of its cosine",
            hint: "The bell curve comes near to the power: for which angles, and what does the formula say?",
            answer: |q| {
                let x = mirrored(&q.at).dot(*q.at.view);
                let angle = x.clamp(-1.0, 1.0).acos();
                let bell = (-0.5 * q.at.exponent * angle * angle).exp();
                with_highlight(&q.at, if x > 0.0 { bell } else { 0.0 })
            },
        },
        Mistake {
            name: "multiplies the angle by the exponent, and takes the cosine of that",
            hint: "Which of the two has the exponent: the angle, or its cosine?",
            answer: |q| {
                let x = mirrored(&q.at).dot(*q.at.view);
                let angle = x.clamp(-1.0, 1.0).acos();
                with_highlight(&q.at, (q.at.exponent * angle).cos().max(0.0))
            },
        },
        Mistake {
            name: "cuts off the exponent behind the decimal point, as a loop of products does",
            hint: "How often does your loop go round for an exponent of 2.5?",
            answer: |q| Self::misread(q, |q| q.at.exponent = q.at.exponent.floor()),
        },
        Mistake {
            name: "subtracts the light's direction, not the viewer's, where it mirrors the viewer's: 2 (N·V) N − L",
            hint: "Which direction does the reflection keep on its side of the normal, the light's or the viewer's? Is it the same one in both places?",
            answer: |q| {
                let Highlight {
                    normal,
                    view,
                    toward,
                    ..
                } = q.at;
                let mixed = 2.0 * normal.dot(*view) * *normal - *toward;
                with_highlight(&q.at, power(mixed.dot(*toward), &q.at))
            },
        },
    ];

    const PICTURES: &'static [Picture<Self>] = &[Picture {
        name: "phong",
        width: 64,
        height: 64,
        alt: BALL,
        question: |x, y| Self { at: on_ball(x, y) },
        colour: |_, radiance| *radiance,
    }];
}

//! `blinn_phong`: random questions, judge and mistakes.

use super::highlight::{
    BALL, ambient, from_above, greater_term, half, highlight_without_light, matte_from_below,
    matte_without_cosine, mirrored, on_ball, power, power_of_colour, power_of_more, radiance,
    random, shining_through, with_highlight, with_terms,
};
use crate::{Graded, Mistake, Picture, Verdict};
use raybook::image::rgb::Rgb;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch12_phong::{BlinnPhongExercise, Highlight};
use std::f32::consts::{PI, TAU};

/// (N·H)^α.
fn highlight(q: &Highlight) -> f32 {
    power(half(q).dot(*q.normal), q)
}

impl Graded for BlinnPhongExercise {
    fn random(rng: &mut Pcg) -> Self {
        Self { at: random(rng) }
    }

    fn judge(_q: &Self, golden: &Rgb, got: &Rgb) -> Verdict {
        radiance(*golden, *got)
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "forgets to normalise H",
            hint: "How long is L + V if light and viewer are in the same place, and if they are far apart?",
            answer: |q| {
                with_highlight(
                    &q.at,
                    power((*q.at.toward + *q.at.view).dot(*q.at.normal), &q.at),
                )
            },
        },
        Mistake {
            name: "halves L + V instead of normalising it",
            hint: "The middle of two points on a circle is not on the circle: how long is your H?",
            answer: |q| {
                with_highlight(
                    &q.at,
                    power(0.5 * (*q.at.toward + *q.at.view).dot(*q.at.normal), &q.at),
                )
            },
        },
        Mistake {
            name: "takes the cross product of L and V for H",
            hint: "Which direction is half way between two others, and which is perpendicular to both?",
            answer: |q| {
                let half = q.at.toward.cross(*q.at.view).normalize_or_zero();
                with_highlight(&q.at, power(half.dot(*q.at.normal), &q.at))
            },
        },
        Mistake {
            name: "takes R·V for N·H",
            hint: "That is Phong's highlight: which two directions does Blinn compare?",
            answer: |q| with_highlight(&q.at, power(mirrored(&q.at).dot(*q.at.view), &q.at)),
        },
        Mistake {
            name: "takes V·H, which is L·H, for N·H",
            hint: "V·H and L·H are the same on every surface, however it is turned: what is missing?",
            answer: |q| with_highlight(&q.at, power(half(&q.at).dot(*q.at.view), &q.at)),
        },
        Mistake {
            name: "takes the difference of L and V for H",
            hint: "Let light and viewer be in the same place, straight above: where does H point?",
            answer: |q| {
                let across = (*q.at.toward - *q.at.view).normalize_or_zero();
                with_highlight(&q.at, power(across.dot(*q.at.normal), &q.at))
            },
        },
        Mistake {
            name: "takes four times the exponent",
            hint: "That makes Phong's and Blinn's highlights alike; but the α that you are given is already Blinn's.",
            answer: |q| {
                with_highlight(
                    &q.at,
                    half(&q.at)
                        .dot(*q.at.normal)
                        .max(0.0)
                        .powf(4.0 * q.at.exponent),
                )
            },
        },
        Mistake {
            name: "lets the highlight shine through from behind",
            hint: "Put the light just below the surface: N·H may still be large; should there be a highlight?",
            answer: |q| with_terms(&q.at, highlight(&q.at), shining_through),
        },
        Mistake {
            name: "lights the matte part from both sides",
            hint: "Put the light below the surface: how much of its light arrives at the upper side?",
            answer: |q| BlinnPhongExercise::right(q) + matte_from_below(&q.at),
        },
        Mistake {
            name: "divides by 0 where L + V is 0",
            hint: "What is L + V if light and viewer are opposite each other, both at the horizon?",
            answer: |q| {
                let half = (*q.at.toward + *q.at.view) / (*q.at.toward + *q.at.view).length();
                let highlight = half.dot(*q.at.normal).powf(q.at.exponent);
                let right = with_highlight(&q.at, highlight);
                if highlight.is_nan() {
                    Rgb::gray(f32::NAN)
                } else {
                    right
                }
            },
        },
        Mistake {
            name: "takes N·V for N·H",
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
            name: "forgets the light i in the highlight",
            hint: "Switch the light off: is your highlight gone?",
            answer: |q| with_terms(&q.at, highlight(&q.at), highlight_without_light),
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
            name: "forgets the diffuse term's cosine",
            hint: "Tilt the surface away from the light: does it receive as much?",
            answer: |q| with_terms(&q.at, highlight(&q.at), matte_without_cosine),
        },
        Mistake {
            name: "multiplies by the exponent instead of raising to it",
            hint: "Raise α: the highlight should become smaller, and stay as bright in its middle.",
            answer: |q| {
                with_highlight(
                    &q.at,
                    q.at.exponent * half(&q.at).dot(*q.at.normal).max(0.0),
                )
            },
        },
        Mistake {
            name: "raises k_s to the exponent too",
            hint: "What stands below α: the cosine alone, or k_s as well?",
            answer: |q| power_of_more(&q.at, half(&q.at).dot(*q.at.normal), false),
        },
        Mistake {
            name: "raises the whole sum to the exponent, the diffuse part too",
            hint: "Which of the two terms has an exponent? Raise α: may the matte part change?",
            answer: |q| power_of_more(&q.at, half(&q.at).dot(*q.at.normal), true),
        },
        Mistake {
            name: "takes the normal for the light in H",
            hint: "H is half way between two directions: which two?",
            answer: |q| {
                let half = (*q.at.normal + *q.at.view).normalize_or_zero();
                with_highlight(&q.at, power(half.dot(*q.at.normal), &q.at))
            },
        },
        Mistake {
            name: "takes the normal for the viewer in H",
            hint: "H is half way between two directions: which two?",
            answer: |q| {
                let half = (*q.at.normal + *q.at.toward).normalize_or_zero();
                with_highlight(&q.at, power(half.dot(*q.at.normal), &q.at))
            },
        },
        Mistake {
            name: "divides L + V by the square of its length",
            hint: "How long is a vector after it is divided by the square of its length?",
            answer: |q| {
                let sum = *q.at.toward + *q.at.view;
                let half = sum / sum.length_squared().max(f32::MIN_POSITIVE);
                with_highlight(&q.at, power(half.dot(*q.at.normal), &q.at))
            },
        },
        Mistake {
            name: "raises k_s to the exponent, and not the cosine",
            hint: "What stands below α: the cosine, or k_s?",
            answer: |q| power_of_colour(&q.at, half(&q.at).dot(*q.at.normal)),
        },
        Mistake {
            name: "lets a light from behind take light away",
            hint: "Is any of your channels ever negative? There is no negative light.",
            answer: |q| {
                let diffuse = q.at.diffuse * q.at.toward.dot(*q.at.normal);
                let highlight = q.at.specular * highlight(&q.at);
                (diffuse + highlight) * q.at.arriving
            },
        },
        Mistake {
            name: "raises the exponent to the power of the cosine",
            hint: "Which of the two is the base of the power: the cosine N·H, or α?",
            answer: |q| {
                let cosine = half(&q.at).dot(*q.at.normal).max(0.0);
                with_highlight(&q.at, q.at.exponent.powf(cosine))
            },
        },
        Mistake {
            name: "multiplies the highlight by (α + 8)/8π",
            hint: "Is the highlight to conserve energy here, or to be as in the formula?",
            answer: |q| {
                with_terms(&q.at, highlight(&q.at), |q, highlight| {
                    from_above(q, (q.exponent + 8.0) / (8.0 * PI) * highlight)
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
            name: "divides the highlight by 4 (L·N) (N·V), as in Cook and Torrance's model",
            hint: "That belongs to a BRDF of microfacets: is it in the formula that you are given?",
            answer: |q| {
                with_terms(&q.at, highlight(&q.at), |q, highlight| {
                    let cosines = q.toward.dot(*q.normal) * q.view.dot(*q.normal);
                    from_above(q, 0.25 / cosines.max(1e-6) * highlight)
                })
            },
        },
        Mistake {
            name: "takes the mirrored light for the light in H",
            hint: "In Blinn's model nothing is mirrored: H is half way between which two directions?",
            answer: |q| {
                let half = (mirrored(&q.at) + *q.at.view).normalize_or_zero();
                with_highlight(&q.at, power(half.dot(*q.at.normal), &q.at))
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
            answer: |q| BlinnPhongExercise::right(q) + ambient(&q.at),
        },
        Mistake {
            name: "takes half of the angle between R and V for the angle between N and H",
            hint: "Let L, N and V lie in one plane, and then turn V out of it: does the angle between R and V still grow twice as fast as that between N and H?",
            answer: |q| {
                // The cosine of half an angle.
                let cosine = (0.5 + 0.5 * mirrored(&q.at).dot(*q.at.view))
                    .max(0.0)
                    .sqrt();
                with_highlight(&q.at, power(cosine, &q.at))
            },
        },
    ];

    const PICTURES: &'static [Picture<Self>] = &[Picture {
        name: "blinn_phong",
        width: 64,
        height: 64,
        alt: BALL,
        question: |x, y| Self { at: on_ball(x, y) },
        colour: |_, radiance| *radiance,
    }];
}

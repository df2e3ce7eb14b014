//! `blinn_phong`: its cases, judge and mistakes.

use super::highlight::{edges, half, mirrored, picture, power, radiance, random, with_highlight};
use crate::{Edge, Graded, Mistake, Picture, Verdict};
use raybook::image::rgb::Rgb;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch12_phong::{BlinnPhongExercise, Highlight};

impl Graded for BlinnPhongExercise {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "forgets to normalise H",
            hint: "How long is L + V if light and viewer are in the same place, and if they are far apart?",
            answer: |q| with_highlight(q, power((*q.toward + *q.view).dot(*q.normal), q)),
        },
        Mistake {
            name: "halves L + V",
            hint: "The middle of two points on a circle is not on the circle: how long is your H?",
            answer: |q| with_highlight(q, power(0.5 * (*q.toward + *q.view).dot(*q.normal), q)),
        },
        Mistake {
            name: "takes R·V",
            hint: "That is Phong's highlight: which two directions does Blinn compare?",
            answer: |q| with_highlight(q, power(mirrored(q).dot(*q.view), q)),
        },
        Mistake {
            name: "takes V·H",
            hint: "V·H is the same on every surface, however it is turned: what is missing?",
            answer: |q| with_highlight(q, power(half(q).dot(*q.view), q)),
        },
        Mistake {
            name: "takes the difference of L and V",
            hint: "Let light and viewer be in the same place, straight above: where does H point?",
            answer: |q| {
                let across = (*q.toward - *q.view).normalize_or_zero();
                with_highlight(q, power(across.dot(*q.normal), q))
            },
        },
        Mistake {
            name: "takes four times the exponent",
            hint: "That makes Phong's and Blinn's highlights alike; but the α that you are given is already Blinn's.",
            answer: |q| with_highlight(q, half(q).dot(*q.normal).max(0.0).powf(4.0 * q.exponent)),
        },
        Mistake {
            name: "lets the highlight shine through from behind",
            hint: "Put the light just below the surface: N·H may still be large; should there be a highlight?",
            answer: |q| {
                let diffuse = q.diffuse * q.toward.dot(*q.normal).max(0.0);
                (diffuse + q.specular * power(half(q).dot(*q.normal), q)) * q.arriving
            },
        },
        Mistake {
            name: "normalises a vector without direction",
            hint: "What is L + V if light and viewer are opposite each other, both at the horizon?",
            answer: |q| {
                let half = (*q.toward + *q.view) / (*q.toward + *q.view).length();
                let highlight = half.dot(*q.normal).powf(q.exponent);
                let right = with_highlight(q, highlight);
                if highlight.is_nan() {
                    Rgb::gray(f32::NAN)
                } else {
                    right
                }
            },
        },
    ];

    const PICTURES: &'static [Picture<Self>] = &[picture()];

    fn edges() -> Vec<Edge<Self>> {
        edges()
    }

    fn random(rng: &mut Pcg) -> Highlight {
        random(rng)
    }

    fn judge(_q: &Highlight, golden: &Rgb, got: &Rgb) -> Verdict {
        radiance(*golden, *got)
    }
}

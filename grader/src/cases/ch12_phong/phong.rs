//! `phong`: its cases, judge and mistakes.

use super::highlight::{edges, half, mirrored, picture, power, radiance, random, with_highlight};
use crate::{Edge, Graded, Mistake, Picture, Verdict};
use raybook::image::rgb::Rgb;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch12_phong::{Highlight, PhongExercise};

impl Graded for PhongExercise {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "lets the highlight shine through from behind",
            hint: "Put the light below the surface: the diffuse part vanishes; does everything?",
            answer: |q| {
                let diffuse = q.diffuse * q.toward.dot(*q.normal).max(0.0);
                (diffuse + q.specular * power(mirrored(q).dot(*q.view), q)) * q.arriving
            },
        },
        Mistake {
            name: "lets a light from behind take light away",
            hint: "Is any of your channels ever negative? There is no negative light.",
            answer: |q| {
                let diffuse = q.diffuse * q.toward.dot(*q.normal);
                (diffuse + q.specular * power(mirrored(q).dot(*q.view), q)) * q.arriving
            },
        },
        Mistake {
            name: "mirrors the wrong way",
            hint: "Draw L, N and R: on which side of the surface does your R end?",
            answer: |q| with_highlight(q, power(-mirrored(q).dot(*q.view), q)),
        },
        Mistake {
            name: "takes the light's direction for its mirror direction",
            hint: "Where do you have to stand to see a lamp in a polished floor: beside the lamp?",
            answer: |q| with_highlight(q, power(q.toward.dot(*q.view), q)),
        },
        Mistake {
            name: "takes N·H",
            hint: "That is Blinn's highlight: which two directions does Phong compare?",
            answer: |q| with_highlight(q, power(half(q).dot(*q.normal), q)),
        },
        Mistake {
            name: "has a highlight on the far side too",
            hint: "An even power of a negative number is positive: what if R and V point away from each other?",
            answer: |q| with_highlight(q, mirrored(q).dot(*q.view).abs().powf(q.exponent)),
        },
        Mistake {
            name: "multiplies by the exponent",
            hint: "Raise α: the highlight should become smaller, and stay as bright in its middle.",
            answer: |q| with_highlight(q, q.exponent * mirrored(q).dot(*q.view).max(0.0)),
        },
        Mistake {
            name: "multiplies the highlight by L·N",
            hint: "In the formula as it stands, which of the two terms has the factor L·N?",
            answer: |q| {
                with_highlight(
                    q,
                    q.toward.dot(*q.normal) * power(mirrored(q).dot(*q.view), q),
                )
            },
        },
        Mistake {
            name: "forgets what arrives in the highlight",
            hint: "Switch the light off: is your highlight gone?",
            answer: |q| {
                let highlight = q.specular * power(mirrored(q).dot(*q.view), q);
                let matt = with_highlight(q, 0.0);
                if q.toward.dot(*q.normal) > 0.0 {
                    matt + highlight
                } else {
                    matt
                }
            },
        },
        Mistake {
            name: "forgets the diffuse term's cosine",
            hint: "Tilt the surface away from the light: does it receive as much?",
            answer: |q| {
                let cosine = q.toward.dot(*q.normal);
                let highlight = q.specular * power(mirrored(q).dot(*q.view), q);
                if cosine > 0.0 {
                    (q.diffuse + highlight) * q.arriving
                } else {
                    Rgb::BLACK
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

//! `expose`: its cases, judge and mistakes.

use super::{channels, colour};
use crate::{Edge, Graded, Mistake, Verdict, sample};
use raybook::image::rgb::Rgb;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercise::Exercise;
use raybook_workbook::exercises::ch02_hdr::{Expose, ExposeQuestion};

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

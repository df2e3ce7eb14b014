//! `lit`: its cases, judge and mistakes.

use crate::{Edge, Graded, Mistake, Verdict, sample};
use raybook::math::{dir3::Dir3, interval::Interval, pcg::Pcg};
use raybook_workbook::exercise::Exercise;
use raybook_workbook::exercises::ch15_shadows::{Ball, Lit, LitQuestion};
use glam::{Vec3, vec3};
use rand::RngExt;

/// Whether any of these spheres is met from the point itself, at min < t < max.
fn blocked(q: &LitQuestion, spheres: &[Ball], within: Interval) -> bool {
    let to_light = |ball: &Ball| {
        let from = q.position - ball.center;
        let middle = -from.dot(*q.toward);
        let aside = (from + middle * *q.toward).length_squared();
        let half = (ball.radius * ball.radius - aside).sqrt(); // NaN where it misses
        within.contains(middle - half) || within.contains(middle + half)
    };
    spheres.iter().any(to_light)
}

/// The spheres on which the point does not lie.
fn others(q: &LitQuestion) -> Vec<Ball> {
    let off = |ball: &Ball| (ball.center.distance(q.position) - ball.radius).abs();
    let others = q.spheres.iter().filter(|b| off(b) > 0.05 * b.radius);
    others.cloned().collect()
}

impl Graded for Lit {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "answers the other way round",
            hint: "Something is in the way: is the point lit?",
            answer: |q| 1 - Lit::answer(q),
        },
        Mistake {
            name: "starts on the surface itself",
            hint: "The point may lie a hair below the surface: who is in the way then?",
            answer: |q| u32::from(!blocked(q, &q.spheres, Interval::new(0.0, q.distance))),
        },
        Mistake {
            name: "takes what is behind the light for an obstacle",
            hint: "How far is the light? What is farther away cannot hide it.",
            answer: |q| {
                Lit::answer(&LitQuestion {
                    distance: f32::INFINITY,
                    ..q.clone()
                })
            },
        },
        Mistake {
            name: "takes what is behind the point for an obstacle",
            hint: "A hit at a negative t is not between the point and the light.",
            answer: |q| {
                let behind = Interval::new(f32::NEG_INFINITY, -0.1);
                Lit::answer(q) * u32::from(!blocked(q, &others(q), behind))
            },
        },
        Mistake {
            name: "only asks the first sphere",
            hint: "Any of the spheres may be in the way: do you ask them all?",
            answer: |q| {
                let spheres = q.spheres.iter().take(1).cloned().collect();
                Lit::answer(&LitQuestion {
                    spheres,
                    ..q.clone()
                })
            },
        },
        Mistake {
            name: "only asks whether the light is above the horizon",
            hint: "A light above the horizon may still be hidden: by what?",
            answer: |q| u32::from(q.normal.dot(*q.toward) > 0.0),
        },
        Mistake {
            name: "never asks the sphere on which the point lies",
            hint: "A ball has a dark side: what is in the way there?",
            answer: |q| {
                let spheres = others(q);
                Lit::answer(&LitQuestion {
                    spheres,
                    ..q.clone()
                })
            },
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let ball = |x, y, z, radius| Ball {
            center: vec3(x, y, z),
            radius,
        };
        // The point is the top of a ball, or its side; `off` is how far off the true surface rounding has put it.
        let edge = |name, off: f32, toward: Vec3, distance, others: &[Ball]| {
            let mut spheres = others.to_vec();
            spheres.push(ball(0.0, 0.0, 0.0, 1.0));
            Edge::new(
                name,
                LitQuestion {
                    position: vec3(0.0, 1.0 + off, 0.0),
                    error: 0.001,
                    normal: Dir3::Y,
                    toward: Dir3::new_or(toward, Dir3::Y),
                    distance,
                    spheres,
                },
            )
        };
        let aslant = vec3(0.6, 0.8, 0.0);
        let in_way = ball(1.5, 3.0, 0.0, 0.5);
        let beside = ball(1.5, 3.0, 0.75, 0.5);
        let behind = ball(-3.0, -3.0, 0.0, 0.5);
        let shade = ball(3.0, 5.0, 0.0, 0.5);
        let beyond = ball(6.0, 9.0, 0.0, 1.0);
        let moon = ball(60.0, 81.0, 0.0, 5.0);
        let above = ball(0.0, 5.0, 0.0, 1.0);
        let (sun, below) = (f32::INFINITY, vec3(0.6, -0.8, 0.0));
        vec![
            edge("nothing in the way", 0.0, aslant, 5.0, &[]),
            edge("a ball in the way", 0.0, aslant, 5.0, &[in_way]),
            edge("a ball beside the way", 0.0, aslant, 5.0, &[beside]),
            edge("a ball behind the light", 0.0, aslant, 5.0, &[beyond]),
            edge("a ball behind the point", 0.0, aslant, 5.0, &[behind]),
            edge("the light in a lampshade", 0.0, aslant, 5.0, &[shade]),
            edge("the sun behind a moon", 0.0, aslant, sun, &[moon]),
            edge("the point is below its surface", -0.0005, aslant, 5.0, &[]),
            edge("the point is above its surface", 0.0005, aslant, 5.0, &[]),
            edge("the light below its own ball", 0.0, below, 5.0, &[]),
            edge(
                "below its surface, in shadow",
                -0.0005,
                Vec3::Y,
                9.0,
                &[above],
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> LitQuestion {
        let own = Ball {
            center: sample::point(rng, 3.0),
            radius: sample::number(rng, 0.5, 1.5),
        };
        let error = 0.001 * own.radius;
        let (normal, toward) = loop {
            let (normal, toward) = (sample::direction(rng), sample::direction(rng));
            let cosine = normal.dot(*toward);
            let wanted = if rng.random_bool(0.3) {
                -cosine
            } else {
                cosine
            };
            if wanted > 0.15 {
                break (normal, toward);
            }
        };
        let off = own.radius + sample::number(rng, -0.5, 0.5) * error;
        let position = own.center + off * *normal;
        let distance = sample::number(rng, 4.0, 8.0);
        let other = |rng: &mut Pcg| {
            // In the way, behind the light, or behind the point.
            let along = [0.5, 1.4, 1.4, -0.8][rng.random_range(0..4)] * distance;
            let radius = sample::number(rng, 0.4, 0.9);
            let aside = sample::point(rng, 0.7);
            Ball {
                center: position + along * *toward + aside,
                radius,
            }
        };
        let mut spheres = vec![other(rng), other(rng)];
        spheres.insert(rng.random_range(0..3), own);
        LitQuestion {
            position,
            error,
            normal,
            toward,
            distance,
            spheres,
        }
    }

    fn judge(_q: &LitQuestion, golden: &u32, got: &u32) -> Verdict {
        match (golden, got) {
            (golden, got) if golden == got => Ok(()),
            (1, 0) => {
                Err("nothing is in the way of this light, but you say it is in shadow".into())
            }
            (0, 1) => Err("something is in the way of this light, but you say it arrives".into()),
            _ => Err(format!("{got} is neither 1, lit, nor 0, in shadow")),
        }
    }
}

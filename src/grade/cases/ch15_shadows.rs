//! Chapter 15: `shadow_ray`, `lit`.

use crate::grade::examine::Examiner;
use crate::grade::{Edge, Graded, Mistake, Verdict, judge, sample};
use crate::math::{dir3::Dir3, interval::Interval, pcg::Pcg};
use crate::workbook::exercise::Exercise;
use crate::workbook::exercises::ch15_shadows::{
    Ball, Lit, LitQuestion, ShadowRay, ShadowRayQuestion, Way,
};
use glam::{DVec3, Vec3, vec3};
use rand::RngExt;

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&ShadowRay, &Lit];

/// A shadow ray may start so many times the error bound off the surface: beyond, shadows come loose.
const FARTHEST: f64 = 5.0;

/// Of the step off the surface, so much must be there: the rest is rounding.
const ROUNDED: f64 = 0.9;

/// A shadow ray must end at least this share of the way before the light, and at most this.
const NEAREST_END: f64 = 5e-7;
const FARTHEST_END: f64 = 0.01;

/// The right answer, with another start.
fn starting(q: &ShadowRayQuestion, origin: Vec3, min: f32) -> Way {
    let right = ShadowRay::answer(q);
    let within = Interval::new(min, right.within.max);
    Way {
        origin,
        within,
        ..right
    }
}

/// The right answer, with another end.
fn ending(q: &ShadowRayQuestion, max: f32) -> Way {
    let right = ShadowRay::answer(q);
    Way {
        within: right.within.before(max),
        ..right
    }
}

impl Graded for ShadowRay {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "starts on the surface itself",
            hint: "The point is not exactly on the surface: it may lie a little below. What does a ray to the light meet first then?",
            answer: |q| starting(q, q.position, 0.0),
        },
        Mistake {
            name: "starts a fixed millimetre along the ray",
            hint: "Is a millimetre much or little? On a grain of sand, on a planet? Which number in the question knows?",
            answer: |q| starting(q, q.position, 1e-3),
        },
        Mistake {
            name: "steps to the normal's side, wherever the light is",
            hint: "A sheet may be lit from behind: on which side of it does the ray leave?",
            answer: |q| {
                let step = q.error * q.normal.abs().element_sum();
                starting(q, q.position + step * *q.normal, 0.0)
            },
        },
        Mistake {
            name: "skips a quarter of the way",
            hint: "What stands close to the surface throws no shadow any more: how far off need the ray start?",
            answer: |q| {
                let far = if q.distance.is_finite() {
                    q.distance
                } else {
                    100.0
                };
                starting(q, q.position, 0.25 * far)
            },
        },
        Mistake {
            name: "never ends",
            hint: "There is a wall behind the lamp: does it throw a shadow on you?",
            answer: |q| ending(q, f32::INFINITY),
        },
        Mistake {
            name: "ends as far behind the light as it is away",
            hint: "How far is the light, and how far does your interval reach?",
            answer: |q| ending(q, 2.0 * q.distance),
        },
        Mistake {
            name: "takes the way for the unit",
            hint: "A direction has length 1, so t is in metres: at which t is the light?",
            answer: |q| {
                let right = ShadowRay::answer(q);
                let far = if q.distance.is_finite() {
                    q.distance
                } else {
                    1.0
                };
                Way {
                    direction: far * right.direction,
                    within: Interval::new(0.0, 1.0),
                    ..right
                }
            },
        },
        Mistake {
            name: "goes away from the light",
            hint: "From the surface to the light: in which direction?",
            answer: |q| {
                let away = ShadowRayQuestion {
                    toward: -q.toward,
                    ..q.clone()
                };
                ShadowRay::answer(&away)
            },
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, position, error, normal: Vec3, toward: Vec3, distance| {
            let [normal, toward] = [normal, toward].map(|v| Dir3::new_or(v, Dir3::Y));
            Edge::new(
                name,
                ShadowRayQuestion {
                    position,
                    error,
                    normal,
                    toward,
                    distance,
                },
            )
        };
        let here = vec3(1.0, 2.0, -1.0);
        vec![
            edge("a lamp straight above", here, 0.01, Vec3::Y, Vec3::Y, 2.0),
            edge(
                "a lamp aslant",
                here,
                0.01,
                Vec3::Y,
                vec3(0.6, 0.8, 0.0),
                5.0,
            ),
            edge(
                "a lamp below a sheet",
                here,
                0.01,
                Vec3::Y,
                vec3(0.0, -0.8, 0.6),
                3.0,
            ),
            edge(
                "the normal points down, the lamp is above",
                here,
                0.01,
                Vec3::NEG_Y,
                Vec3::Y,
                2.0,
            ),
            edge(
                "a surface askew to all axes",
                here,
                0.02,
                Vec3::ONE,
                vec3(0.0, 0.0, 1.0),
                4.0,
            ),
            edge(
                "a lamp just above the horizon",
                here,
                0.01,
                Vec3::Y,
                vec3(1.0, 0.1, 0.0),
                4.0,
            ),
            edge(
                "the sun",
                here,
                0.01,
                Vec3::Y,
                vec3(0.6, 0.8, 0.0),
                f32::INFINITY,
            ),
            edge(
                "the sun, from behind",
                here,
                0.01,
                Vec3::Y,
                vec3(0.6, -0.8, 0.0),
                f32::INFINITY,
            ),
            edge(
                "a grain of sand",
                vec3(0.001, 0.002, 0.0),
                1e-5,
                Vec3::Y,
                Vec3::Y,
                0.003,
            ),
            edge(
                "a planet",
                vec3(6e6, 0.0, 1e6),
                1e4,
                Vec3::X,
                vec3(0.8, 0.6, 0.0),
                4e7,
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> ShadowRayQuestion {
        let scale = 10.0_f32.powf(sample::number(rng, -1.5, 3.0));
        let (normal, toward) = loop {
            let (normal, toward) = (sample::direction(rng), sample::direction(rng));
            if normal.dot(*toward).abs() > 0.1 {
                break (normal, toward);
            }
        };
        let distance = if rng.random_bool(0.15) {
            f32::INFINITY
        } else {
            scale * sample::number(rng, 2.0, 6.0)
        };
        ShadowRayQuestion {
            position: scale * sample::point(rng, 3.0),
            error: scale * sample::number(rng, 0.01, 0.03),
            normal,
            toward,
            distance,
        }
    }

    fn judge(q: &ShadowRayQuestion, golden: &Way, got: &Way) -> Verdict {
        judge::direction("the ray", golden.direction, got.direction)?;
        starts_off(q, got)?;
        ends_before(q, got)
    }
}

/// Where the stretch that counts begins, seen from the point, and where it ends.
fn ends(q: &ShadowRayQuestion, got: &Way) -> [DVec3; 2] {
    let from = got.origin.as_dvec3() - q.position.as_dvec3();
    let at = |t: f32| from + f64::from(t) * got.direction.as_dvec3();
    [at(got.within.min), at(got.within.max)]
}

/// The start is on the light's side of all places where the surface may be, and not much farther.
fn starts_off(q: &ShadowRayQuestion, got: &Way) -> Verdict {
    let [start, _] = ends(q, got);
    if !start.is_finite() {
        return Err("the ray starts nowhere: a number is missing or infinite".into());
    }
    let normal = q.normal.as_dvec3();
    let cosine = normal.dot(q.toward.as_dvec3());
    let needed = f64::from(q.error) * normal.abs().element_sum();
    let (off, far) = (normal.dot(start) * cosine.signum(), start.length());
    if off < ROUNDED * needed {
        let side = if off < 0.0 {
            "on the wrong side of"
        } else {
            "off"
        };
        Err(format!(
            "the ray starts {:.4} m {side} the point, but the surface may be {needed:.4} m off: it may find its own surface again",
            off.abs()
        ))
    } else if far * cosine.abs() > FARTHEST * needed {
        Err(format!(
            "the ray starts {far:.4} m from the point, where {needed:.4} m off the surface are enough: what is in between throws no shadow"
        ))
    } else {
        Ok(())
    }
}

/// The end is before the light, and not much.
fn ends_before(q: &ShadowRayQuestion, got: &Way) -> Verdict {
    let (distance, max) = (f64::from(q.distance), got.within.max);
    if distance.is_infinite() {
        // The largest f32 will do.
        return if max > 1e30 {
            Ok(())
        } else {
            Err(format!(
                "the light is infinitely far away, and the interval ends at {max} m"
            ))
        };
    }
    if max.is_infinite() {
        return Err(format!(
            "the interval does not end, but the light is at {distance} m"
        ));
    }
    let before = distance - ends(q, got)[1].dot(q.toward.as_dvec3());
    if before.is_nan() || before < NEAREST_END * distance {
        Err(format!(
            "the interval ends {:.4} m behind the light, and not before it",
            (-before).max(0.0)
        ))
    } else if before > FARTHEST_END * distance + FARTHEST * f64::from(q.error) {
        Err(format!(
            "the interval ends {before:.4} m before the light, too soon"
        ))
    } else {
        Ok(())
    }
}

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
                let others = q.spheres.get(1..).unwrap_or_default();
                Lit::answer(q) * u32::from(!blocked(q, others, behind))
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
                let own = |ball: &Ball| {
                    (ball.center.distance(q.position) - ball.radius).abs() < 0.05 * ball.radius
                };
                let spheres = q
                    .spheres
                    .iter()
                    .filter(|ball| !own(ball))
                    .cloned()
                    .collect();
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
            let mut spheres = vec![ball(0.0, 0.0, 0.0, 1.0)];
            spheres.extend(others.iter().cloned());
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
        vec![
            edge("nothing in the way", 0.0, aslant, 5.0, &[]),
            edge(
                "a ball in the way",
                0.0,
                aslant,
                5.0,
                &[ball(1.5, 3.0, 0.0, 0.5)],
            ),
            edge(
                "a ball beside the way",
                0.0,
                aslant,
                5.0,
                &[ball(1.5, 3.0, 0.75, 0.5)],
            ),
            edge(
                "a ball behind the light",
                0.0,
                aslant,
                5.0,
                &[ball(6.0, 9.0, 0.0, 1.0)],
            ),
            edge(
                "a ball behind the point",
                0.0,
                aslant,
                5.0,
                &[ball(-3.0, -3.0, 0.0, 0.5)],
            ),
            edge(
                "the light inside a lampshade",
                0.0,
                aslant,
                5.0,
                &[ball(3.0, 5.0, 0.0, 0.5)],
            ),
            edge(
                "the sun, and a ball far away in the way",
                0.0,
                aslant,
                f32::INFINITY,
                &[ball(60.0, 81.0, 0.0, 5.0)],
            ),
            edge(
                "rounding has put the point below its surface",
                -0.0005,
                aslant,
                5.0,
                &[],
            ),
            edge(
                "rounding has put the point above its surface",
                0.0005,
                aslant,
                5.0,
                &[],
            ),
            edge(
                "the light is below: its own ball is in the way",
                0.0,
                vec3(0.6, -0.8, 0.0),
                5.0,
                &[],
            ),
            edge(
                "a ball in the way, and the point below its surface",
                -0.0005,
                Vec3::Y,
                9.0,
                &[ball(0.0, 5.0, 0.0, 1.0)],
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
        let spheres = vec![own, other(rng), other(rng)];
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

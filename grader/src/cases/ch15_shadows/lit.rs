//! `lit`: random questions, judge and mistakes.

use crate::{Graded, Mistake, Verdict, sample};
use rand::RngExt;
use raybook::math::{interval::Interval, pcg::Pcg};
use raybook_workbook::exercise::Exercise;
use raybook_workbook::exercises::ch15_shadows::{Ball, Lit, ShadowRay, Way};

/// Whether any of these spheres is met from the point itself, at min < t < max.
fn blocked(q: &Lit, spheres: &[Ball], within: Interval) -> bool {
    let to_light = |ball: &Ball| {
        let from = q.position - ball.center;
        let middle = -from.dot(*q.toward);
        let aside = (from + middle * *q.toward).length_squared();
        let half = (ball.radius * ball.radius - aside).sqrt(); // NaN where it misses
        within.contains(middle - half) || within.contains(middle + half)
    };
    spheres.iter().any(to_light)
}

/// Whether a sphere is in the way by which of its two hits, the nearer one first, are between the right start and the light.
fn blocked_by(q: &Lit, hides: fn([bool; 2]) -> bool) -> bool {
    let way = shadow(q);
    let is_hiding = |ball: &Ball| {
        let from = way.origin - ball.center;
        let middle = -from.dot(*q.toward);
        let aside = (from + middle * *q.toward).length_squared();
        let half = (ball.radius * ball.radius - aside).sqrt(); // NaN where it misses
        hides([middle - half, middle + half].map(|t| way.within.contains(t)))
    };
    q.spheres.iter().any(is_hiding)
}

/// The answer by the cones around the spheres ahead. Whether the light is in a cone is said of the sine and the cosine of the angle from it to the
/// sphere's middle, and of the sine of that from the middle to the rim.
fn by_cones(q: &Lit, is_in: fn([f32; 2], f32) -> bool) -> u32 {
    let way = shadow(q);
    let is_hiding = |ball: &Ball| {
        let to = ball.center - way.origin;
        let (away, foot) = (to.length(), to.dot(*q.toward));
        let end = way.within.max;
        if away < ball.radius {
            return true;
        }
        if foot > end {
            return (to - end * *q.toward).length() < ball.radius;
        }
        let aside = (away * away - foot * foot).max(0.0).sqrt();
        foot > 0.0 && is_in([aside / away, foot / away], ball.radius / away)
    };
    u32::from(!q.spheres.iter().any(is_hiding))
}

/// The way to the light.
fn shadow(q: &Lit) -> Way {
    ShadowRay::answer(&ShadowRay {
        position: q.position,
        error: q.error,
        normal: q.normal,
        toward: q.toward,
        distance: q.distance,
    })
}

/// The spheres on which the point does not lie.
fn others(q: &Lit) -> Vec<Ball> {
    let off = |ball: &Ball| (ball.center.distance(q.position) - ball.radius).abs();
    let others = q.spheres.iter().filter(|b| off(b) > 0.05 * b.radius);
    others.cloned().collect()
}

impl Graded for Lit {
    fn random(rng: &mut Pcg) -> Lit {
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
        // The normal may point to either side of the surface.
        let normal = if rng.random_bool(0.3) {
            -normal
        } else {
            normal
        };
        let distance = sample::number(rng, 4.0, 8.0);
        let other = |rng: &mut Pcg| loop {
            let radius = sample::number(rng, 0.4, 0.9);
            // In the way, behind the light, behind the point, or at the light, which may be inside.
            let along = match rng.random_range(0..6) {
                0 => 0.5 * distance,
                1 | 2 => 1.4 * distance,
                3 => -0.8 * distance,
                _ => distance + sample::number(rng, -0.5, 1.5) * radius,
            };
            let center = position + along * *toward + sample::point(rng, 0.7);
            let ball = Ball { center, radius };
            // The way may start anywhere within some errors of the position, and end so: that must not decide whether it meets the ball.
            let foot = (center - position).dot(*toward);
            let passes = (center - position).reject_from_normalized(*toward).length();
            let half = (radius * radius - passes * passes).max(0.0).sqrt();
            let ends = [foot - half, foot + half].map(|t| (t - distance).abs());
            if (passes - radius).abs() > 4.0 * error && ends.iter().all(|end| *end > 20.0 * error) {
                break ball;
            }
        };
        let mut spheres = vec![other(rng), other(rng)];
        spheres.insert(rng.random_range(0..3), own);
        Lit {
            position,
            error,
            normal,
            toward,
            distance,
            spheres,
        }
    }

    fn judge(_q: &Lit, golden: &u32, got: &u32) -> Verdict {
        match (golden, got) {
            (golden, got) if golden == got => Ok(()),
            (1, 0) => {
                Err("nothing is in the way of this light, but you say it is in shadow".into())
            }
            (0, 1) => Err("something is in the way of this light, but you say it arrives".into()),
            _ => Err(format!("{got} is neither 1, lit, nor 0, in shadow")),
        }
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "answers the other way round",
            hint: "Something is in the way: is the point lit?",
            answer: |q| 1 - Lit::right(q),
        },
        Mistake {
            name: "starts on the surface itself",
            hint: "The point may lie a hair below the surface: which surface is in the way then?",
            answer: |q| u32::from(!blocked(q, &q.spheres, Interval::new(0.0, q.distance))),
        },
        Mistake {
            name: "takes what is behind the light for an obstacle",
            hint: "How far is the light? What is farther away cannot hide it.",
            answer: |q| Self::misread(q, |q| q.distance = f32::INFINITY),
        },
        Mistake {
            name: "takes another sphere behind the point for an obstacle",
            hint: "A hit at a negative t is not between the point and the light.",
            answer: |q| {
                let behind = Interval::new(f32::NEG_INFINITY, -0.1);
                Lit::right(q) * u32::from(!blocked(q, &others(q), behind))
            },
        },
        Mistake {
            name: "only asks the first sphere",
            hint: "Any of the spheres may be in the way: do you ask them all?",
            answer: |q| {
                let spheres = q.spheres.iter().take(1).cloned().collect();
                Lit::right(&Lit {
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
                Lit::right(&Lit {
                    spheres,
                    ..q.clone()
                })
            },
        },
        Mistake {
            name: "says that every light arrives",
            hint: "Which of your tests can ever answer that something is in the way?",
            answer: |_| 1,
        },
        Mistake {
            name: "says that no light arrives",
            hint: "Which of your tests is always true?",
            answer: |_| 0,
        },
        Mistake {
            name: "says that a surface which faces away is dark",
            hint: "Whether the surface faces the light is asked elsewhere, by the cosine: what is asked here?",
            answer: |q| {
                if q.normal.dot(*q.toward) <= 0.0 {
                    0
                } else {
                    Lit::right(q)
                }
            },
        },
        Mistake {
            name: "takes any sphere behind the point for an obstacle, its own sphere too",
            hint: "In which direction from the point is the light? What lies in the opposite direction?",
            answer: |q| {
                let behind = Interval::new(f32::NEG_INFINITY, -2.0 * q.error);
                Lit::right(q) * u32::from(!blocked(q, &q.spheres, behind))
            },
        },
        Mistake {
            name: "finds its own sphere in the way: starts below its surface, or takes the sphere for larger than it is",
            hint: "On which side of the surface is the light, and to which side do you step off it?",
            answer: |q| {
                let own = q.spheres.iter().any(|ball| {
                    (ball.center.distance(q.position) - ball.radius).abs() <= 0.05 * ball.radius
                });
                Lit::right(q) * u32::from(!own)
            },
        },
        Mistake {
            name: "takes twice the radius of each sphere",
            hint: "You compare a distance from the centre with a number: is that number a radius or a diameter?",
            answer: |q| {
                Self::misread(q, |q| {
                    q.spheres.iter_mut().for_each(|ball| ball.radius *= 2.0);
                })
            },
        },
        Mistake {
            name: "takes half the radius of each sphere",
            hint: "You compare a distance from the centre with a number: is that number a radius or a diameter?",
            answer: |q| {
                Self::misread(q, |q| {
                    q.spheres.iter_mut().for_each(|ball| ball.radius *= 0.5);
                })
            },
        },
        Mistake {
            name: "asks only for the nearer of the two hits with each sphere, or leaves out a sphere in which the way begins",
            hint: "A ray that starts inside of a sphere hits it once, on its way out: which of your two distances is that?",
            answer: |q| u32::from(!blocked_by(q, |[nearer, _]| nearer)),
        },
        Mistake {
            name: "steps to the normal's side, wherever the light is",
            hint: "The normal may point away from the light: on which side of the surface does the way to the light begin?",
            answer: |q| {
                let off = q.normal.abs().element_sum() * q.error;
                let moved = Lit {
                    position: q.position + off * *q.normal,
                    ..q.clone()
                };
                let end = shadow(q).within.max;
                u32::from(!blocked(&moved, &q.spheres, Interval::new(0.0, end)))
            },
        },
        Mistake {
            name: "looks at the first metre of the way only",
            hint: "The light is farther away than a metre: where does your interval end, and how long is the direction that it belongs to?",
            answer: |q| Self::misread(q, |q| q.distance = q.distance.min(1.0)),
        },
        Mistake {
            name: "skips the first metre of the way",
            hint: "A sphere may stand close to the surface: how far from it does your way to the light begin?",
            answer: |q| {
                let way = shadow(q);
                let later = Lit {
                    position: way.origin,
                    ..q.clone()
                };
                u32::from(!blocked(
                    &later,
                    &q.spheres,
                    Interval {
                        min: 1.0,
                        ..way.within
                    },
                ))
            },
        },
        Mistake {
            name: "leaves out a sphere whose middle is not between the point and the light",
            hint: "A sphere begins before its middle: can it be in the way although its middle is behind the light?",
            answer: |q| {
                let way = shadow(q);
                let between = |ball: &Ball| {
                    let along = (ball.center - way.origin).dot(way.direction);
                    0.0 < along && along < q.distance
                };
                Self::misread(q, |q| q.spheres.retain(between))
            },
        },
        Mistake {
            name: "leaves out a sphere in which the light is",
            hint: "A lamp may stand in a lampshade: does the way to it go through the shade? Do you ask only for the farther of two hits?",
            answer: |q| {
                Self::misread(q, |q| {
                    let light = q.position + q.distance * *q.toward;
                    let is_around = |ball: &Ball| ball.center.distance(light) < ball.radius;
                    q.spheres.retain(|ball| !is_around(ball));
                })
            },
        },
        Mistake {
            name: "goes away from the light",
            hint: "From the surface to the light: in which direction?",
            answer: |q| {
                let way = shadow(q);
                let back = Lit {
                    position: way.origin,
                    toward: -q.toward,
                    ..q.clone()
                };
                u32::from(!blocked(&back, &q.spheres, way.within))
            },
        },
        Mistake {
            name: "leaves out a sphere whose middle is behind the start of the way",
            hint: "The way may begin inside of a sphere: does it leave that sphere although the middle is behind?",
            answer: |q| {
                let way = shadow(q);
                let is_ahead = |ball: &Ball| (ball.center - way.origin).dot(way.direction) >= 0.0;
                Self::misread(q, |q| q.spheres.retain(is_ahead))
            },
        },
        Mistake {
            name: "moves the start along the way, not along the normal",
            hint: "A lamp just above the horizon: how far above the surface does your way to it start?",
            answer: |q| {
                let moved = Lit {
                    position: q.position + 2.0 * q.error * *q.toward,
                    ..q.clone()
                };
                let end = shadow(q).within.max;
                u32::from(!blocked(&moved, &q.spheres, Interval::new(0.0, end)))
            },
        },
        Mistake {
            name: "takes a sphere for an obstacle only if the way both enters and leaves it",
            hint: "The way may begin or end inside of a sphere: how often does it meet that sphere?",
            answer: |q| u32::from(!blocked_by(q, |[nearer, farther]| nearer && farther)),
        },
        Mistake {
            name: "sees nothing in the way of a light that is infinitely far away",
            hint: "The sun has no place to which you could go: which numbers of yours are infinite, or not numbers at all?",
            answer: |q| {
                if q.distance.is_finite() {
                    Self::right(q)
                } else {
                    1
                }
            },
        },
        Mistake {
            name: "starts on the surface itself, and leaves out hits that are nearer than a millimetre",
            hint: "How far below the surface may the point lie, and is a millimetre always more than that?",
            answer: |q| u32::from(!blocked(q, &q.spheres, Interval::new(1e-3, q.distance))),
        },
        Mistake {
            name: "takes any sphere on the line to the light for an obstacle, behind the point and behind the light too",
            hint: "A line has no ends: between which two points of it are obstacles?",
            answer: |q| {
                let line = Interval::new(f32::NEG_INFINITY, f32::INFINITY);
                u32::from(!blocked(q, &q.spheres, line))
            },
        },
        Mistake {
            name: "says that a surface which faces away is lit, whatever is in the way",
            hint: "The normal may point to either side: does it tell what is in the way?",
            answer: |q| {
                if q.normal.dot(*q.toward) < 0.0 {
                    1
                } else {
                    Self::right(q)
                }
            },
        },
        Mistake {
            name: "takes B/2 for B in the discriminant: subtracts 4 C from its square",
            hint: "With B = 2 o·d the discriminant is B² − 4 C, and with half of B?",
            answer: |q| {
                let way = shadow(q);
                let is_hiding = |ball: &Ball| {
                    let from = way.origin - ball.center;
                    let middle = -from.dot(*q.toward);
                    let free = from.length_squared() - ball.radius * ball.radius;
                    let half = (middle * middle - 4.0 * free).sqrt(); // NaN where it misses
                    [middle - half, middle + half]
                        .iter()
                        .any(|t| way.within.contains(*t))
                };
                u32::from(!q.spheres.iter().any(is_hiding))
            },
        },
        Mistake {
            name: "compares the tangent of the angle to a sphere's middle with its radius over its distance, not the sine",
            hint: "A ray that just touches a sphere, its middle and the touched point make a triangle: where is its right angle?",
            answer: |q| by_cones(q, |[sine, cosine], rim| sine / cosine < rim),
        },
        Mistake {
            name: "compares the sine of the angle to a sphere's middle with the tangent of that to its rim",
            hint: "Of the angle to the middle and of the angle to the rim, which function do you compare: the same one of both?",
            answer: |q| by_cones(q, |[sine, _], rim| sine < rim / (1.0 - rim * rim).sqrt()),
        },
        Mistake {
            name: "compares the distance of a sphere's middle with that of the light, not the distance of the hit",
            hint: "A sphere begins before its middle: can it be in the way although its middle is farther away than the light?",
            answer: |q| by_distances(q, |away, _| away),
        },
        Mistake {
            name: "keeps the answer for the last sphere only",
            hint: "The first sphere is in the way, and the last one is not: what does your variable hold after the loop?",
            answer: |q| {
                let rest = q.spheres.len().saturating_sub(1);
                Self::misread(q, |q| drop(q.spheres.drain(..rest)))
            },
        },
        Mistake {
            name: "lets two spheres in the way cancel each other, as two negations do",
            hint: "A second sphere behind the first: does the light come back?",
            answer: |q| 1 - (hiding(q) % 2) as u32,
        },
        Mistake {
            name: "takes the square of each sphere's radius for its radius",
            hint: "You compare a length with a number: is that number a radius, or its square?",
            answer: |q| {
                Self::misread(q, |q| {
                    q.spheres
                        .iter_mut()
                        .for_each(|ball| ball.radius *= ball.radius);
                })
            },
        },
        Mistake {
            name: "compares the square of a distance with the radius, which is not squared",
            hint: "In which unit is a squared distance, and in which is a radius?",
            answer: |q| {
                Self::misread(q, |q| {
                    for ball in &mut q.spheres {
                        ball.radius = ball.radius.sqrt();
                    }
                })
            },
        },
    ];
}

/// How many of the spheres are in the way.
fn hiding(q: &Lit) -> usize {
    let is_hiding = |ball: &&Ball| {
        let spheres = vec![(*ball).clone()];
        let alone = Lit {
            spheres,
            ..q.clone()
        };
        Lit::right(&alone) == 0
    };
    q.spheres.iter().filter(is_hiding).count()
}

/// The answer if the spheres that the line to the light meets are in the way by a distance that is less than the light's, of the distance to a
/// sphere's middle and of the radius. A way that begins inside of a sphere is always blocked.
fn by_distances(q: &Lit, distance: fn(f32, f32) -> f32) -> u32 {
    let start = shadow(q).origin;
    let is_hiding = |ball: &Ball| {
        let to = ball.center - start;
        let (away, along) = (to.length(), to.dot(*q.toward));
        let aside = (to - along * *q.toward).length();
        let is_met = along > 0.0 && aside < ball.radius;
        away < ball.radius || is_met && distance(away, ball.radius) < q.distance
    };
    u32::from(!q.spheres.iter().any(is_hiding))
}

//! Chapter 3: `solve_quadratic`, `sphere_hit`, `sphere_normal`.

use crate::grade::examine::Examiner;
use crate::grade::{Edge, Graded, Mistake, Picture, Verdict, judge, sample};
use crate::image::rgb::Rgb;
use crate::lab::palette::viridis;
use crate::math::{dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use crate::workbook::exercise::Exercise;
use crate::workbook::exercises::ch03_sphere::{
    Coefficients, SolveQuadratic, SphereHit, SphereHitQuestion, SphereNormal, SphereNormalQuestion,
};
use glam::{Vec2, Vec3, vec2, vec3};
use rand::RngExt;

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&SolveQuadratic, &SphereHit, &SphereNormal];

impl Graded for SolveQuadratic {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "uses the schoolbook formula for both roots",
            hint: "Where b² is much larger than 4ac, −b and the square root nearly cancel in one of the roots: which one, and how else can you get it?",
            answer: |q| {
                roots(q, |q, root| {
                    vec2((-q.b - root) / (2.0 * q.a), (-q.b + root) / (2.0 * q.a))
                })
                .map(sorted)
            },
        },
        Mistake {
            name: "returns the roots unsorted",
            hint: "Try a negative a, then a positive b: which of your two roots is the smaller one?",
            answer: |q| {
                SolveQuadratic::answer(q).map(|t| {
                    if q.a < 0.0 || q.b > 0.0 {
                        vec2(t.y, t.x)
                    } else {
                        t
                    }
                })
            },
        },
        Mistake {
            name: "forgets the 2 in 2a",
            hint: "Put one of your roots back into the equation: is a·t² + b·t + c really 0?",
            answer: |q| SolveQuadratic::answer(q).map(|t| 2.0 * t),
        },
        Mistake {
            name: "has the sign of b wrong",
            hint: "Put one of your roots back into the equation, and then its negative.",
            answer: |q| SolveQuadratic::answer(q).map(|t| vec2(-t.y, -t.x)),
        },
        Mistake {
            name: "takes a double root for none",
            hint: "When b² = 4ac the parabola touches zero: how often?",
            answer: |q| SolveQuadratic::answer(q).filter(|t| t.x != t.y),
        },
        Mistake {
            name: "takes the root of |b² − 4ac|",
            hint: "What does a negative discriminant say about the parabola?",
            answer: |q| {
                let root = (q.b * q.b - 4.0 * q.a * q.c).abs().sqrt();
                (q.a != 0.0).then(|| {
                    sorted(vec2(
                        (-q.b - root) / (2.0 * q.a),
                        (-q.b + root) / (2.0 * q.a),
                    ))
                })
            },
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, a, b, c| Edge::new(name, Coefficients { a, b, c });
        vec![
            edge("two whole roots", 1.0, -3.0, 2.0),
            edge("a double root", 1.0, -2.0, 1.0),
            edge("no real root", 1.0, 2.0, 5.0),
            edge("a is 0, so it is not a quadratic", 0.0, 2.0, -4.0),
            edge("b is 0", 1.0, 0.0, -9.0),
            edge("c is 0", 2.0, -6.0, 0.0),
            edge("all roots are 0", 3.0, 0.0, 0.0),
            edge("a is negative", -1.0, 1.0, 6.0),
            edge(
                "a large negative b: the small root cancels",
                1.0,
                -20000.0,
                1.0,
            ),
            edge(
                "a large positive b: the other root cancels",
                1.0,
                20000.0,
                1.0,
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> Coefficients {
        let (a, b) = (
            sample::number(rng, 0.2, 3.0),
            sample::number(rng, -8.0, 8.0),
        );
        let sign = if rng.random_bool(0.3) { -1.0 } else { 1.0 };
        Coefficients {
            a: sign * a,
            b,
            c: sample::number(rng, -6.0, 6.0),
        }
    }

    fn judge(_q: &Coefficients, golden: &Option<Vec2>, got: &Option<Vec2>) -> Verdict {
        judge::option(
            "a pair of real roots",
            golden.as_ref(),
            got.as_ref(),
            |golden, got| {
                for (name, golden, got) in [("t0", golden.x, got.x), ("t1", golden.y, got.y)] {
                    // Relative to the root alone: the small one is what cancellation spoils.
                    judge::number_within(
                        name,
                        "",
                        golden,
                        got,
                        judge::RELATIVE * golden.abs().max(1e-6),
                    )?;
                }
                Ok(())
            },
        )
    }
}

/// The roots by a formula that is given √(b² − 4ac), where that is real and a ≠ 0.
fn roots(q: &Coefficients, formula: fn(&Coefficients, f32) -> Vec2) -> Option<Vec2> {
    let discriminant = q.b * q.b - 4.0 * q.a * q.c;
    (q.a != 0.0 && discriminant >= 0.0).then(|| formula(q, discriminant.sqrt()))
}

fn sorted(t: Vec2) -> Vec2 {
    vec2(t.min_element(), t.max_element())
}

impl Graded for SphereHit {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "takes the far root",
            hint: "The ray enters the sphere before it leaves it: which of the two does the eye see?",
            answer: |q| pick(q, |_, far| Some(far)),
        },
        Mistake {
            name: "gives up when the near root does not count",
            hint: "Stand inside the sphere: the near root is behind you, but you still see a wall.",
            answer: |q| pick(q, |near, _| Some(near)),
        },
        Mistake {
            name: "ignores the interval",
            hint: "Is every t you return between min and max?",
            answer: |q| both(q).map(|t| t.x),
        },
        Mistake {
            name: "only asks for t > min",
            hint: "Something nearer may already have been hit: what is the interval's max for?",
            answer: |q| both(q).and_then(|t| [t.x, t.y].into_iter().find(|t| *t > q.within.min)),
        },
        Mistake {
            name: "takes the sphere to be at the origin",
            hint: "Move the sphere by one metre: does your answer move with it?",
            answer: |q| {
                SphereHit::answer(&SphereHitQuestion {
                    center: Vec3::ZERO,
                    ..q.clone()
                })
            },
        },
        Mistake {
            name: "forgets to square the radius",
            hint: "Check the units: what do you subtract from a squared length?",
            answer: |q| {
                SphereHit::answer(&SphereHitQuestion {
                    radius: q.radius.sqrt(),
                    ..q.clone()
                })
            },
        },
        Mistake {
            name: "skips the first millimetre",
            hint: "You may have learnt to ignore small t against self-intersection; the interval you are given already says where hits begin to count.",
            answer: |q| {
                let within = Interval::new(q.within.min.max(1e-3), q.within.max);
                SphereHit::answer(&SphereHitQuestion {
                    within,
                    ..q.clone()
                })
            },
        },
        Mistake {
            name: "computes b² − 4ac from far away",
            hint: "From a thousand radii away, |o − c|² and r² differ in size by a million: what is left of r² after the subtraction? Could you move the ray's start closer first?",
            answer: |q| {
                let (d, from) = (*q.ray.direction, q.ray.origin - q.center);
                let (b, c) = (
                    2.0 * from.dot(d),
                    from.length_squared() - q.radius * q.radius,
                );
                let root = (b * b - 4.0 * c).sqrt();
                [0.5 * (-b - root), 0.5 * (-b + root)]
                    .into_iter()
                    .find(|t| q.within.contains(*t))
            },
        },
    ];

    const PICTURE: Option<Picture<Self>> = Some(Picture {
        width: 96,
        height: 54,
        alt: "A sphere; the brighter, the nearer",
        question: |x, y| {
            let toward = vec3((x as f32 - 47.5) / 54.0, (26.5 - y as f32) / 54.0, -1.0);
            let ray = Ray::new(vec3(0.0, 0.0, 3.0), Dir3::new_or(toward, Dir3::Z));
            SphereHitQuestion {
                ray,
                within: Interval::AHEAD,
                center: vec3(0.2, 0.1, 0.0),
                radius: 1.0,
            }
        },
        colour: |_, t| t.map_or(Rgb::gray(0.1), |t| viridis(1.0 - (t - 2.0) / 2.0)),
    });

    fn edges() -> Vec<Edge<Self>> {
        let question = |origin, toward, within, center, radius| SphereHitQuestion {
            ray: Ray::new(origin, Dir3::new_or(toward, Dir3::Z)),
            within,
            center,
            radius,
        };
        let ahead = Interval::AHEAD;
        let back = vec3(0.0, 0.0, -3.0);
        vec![
            Edge::new("head on", question(back, Vec3::Z, ahead, Vec3::ZERO, 1.0)),
            Edge::new(
                "from the centre",
                question(Vec3::ZERO, Vec3::Y, ahead, Vec3::ZERO, 2.0),
            ),
            Edge::new(
                "from inside, off the centre",
                question(vec3(0.5, 0.0, 0.0), Vec3::X, ahead, Vec3::ZERO, 1.0),
            ),
            Edge::new(
                "the sphere is behind",
                question(back, Vec3::NEG_Z, ahead, Vec3::ZERO, 1.0),
            ),
            Edge::new(
                "past it",
                question(back, vec3(0.0, 1.0, 1.0), ahead, Vec3::ZERO, 1.0),
            ),
            Edge::new(
                "both hits lie beyond the interval",
                question(back, Vec3::Z, Interval::new(0.0, 1.5), Vec3::ZERO, 1.0),
            ),
            Edge::new(
                "the interval begins inside",
                question(
                    back,
                    Vec3::Z,
                    Interval::new(3.0, f32::INFINITY),
                    Vec3::ZERO,
                    1.0,
                ),
            ),
            Edge::new(
                "the interval lies inside",
                question(back, Vec3::Z, Interval::new(2.5, 3.5), Vec3::ZERO, 1.0),
            ),
            Edge::new(
                "away from the origin",
                question(
                    vec3(4.0, -2.0, 7.0),
                    vec3(0.0, 0.0, 1.0),
                    ahead,
                    vec3(4.2, -2.1, 12.0),
                    0.5,
                ),
            ),
            Edge::new(
                "starts a quarter of a millimetre before the surface",
                question(
                    vec3(0.0, 0.0, -1.0 - 1.0 / 4096.0),
                    Vec3::Z,
                    ahead,
                    Vec3::ZERO,
                    1.0,
                ),
            ),
            Edge::new(
                "a small sphere, far away",
                question(
                    vec3(0.0, 0.0, -4096.0),
                    Vec3::Z,
                    ahead,
                    vec3(0.0625, 0.0, 0.0),
                    0.125,
                ),
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> SphereHitQuestion {
        let (center, radius) = (sample::point(rng, 3.0), sample::number(rng, 0.5, 2.0));
        // One ray in four starts inside; most aim near the sphere, so that about half of all hit.
        let distance = radius
            * if rng.random_bool(0.25) {
                sample::number(rng, 0.1, 0.9)
            } else {
                sample::number(rng, 1.5, 5.0)
            };
        let origin = center - distance * *sample::direction(rng);
        let aim = center + sample::point(rng, 1.2 * radius);
        let direction = Dir3::new_or(aim - origin, Dir3::X);
        let max = if rng.random_bool(0.3) {
            sample::number(rng, 0.5, 6.0)
        } else {
            f32::INFINITY
        };
        SphereHitQuestion {
            ray: Ray::new(origin, direction),
            within: Interval::new(0.0, max),
            center,
            radius,
        }
    }

    fn judge(q: &SphereHitQuestion, golden: &Option<f32>, got: &Option<f32>) -> Verdict {
        judge::option("a hit", golden.as_ref(), got.as_ref(), |golden, got| {
            // Measured by the sphere, not by its distance; but no finer than a few of t's last digits.
            let tolerance = judge::RELATIVE * q.radius + 4.0 * f32::EPSILON * golden.abs();
            judge::number_within("t", "m", *golden, *got, tolerance)
        })
    }
}

/// Both distances at which the whole line meets the sphere.
fn both(q: &SphereHitQuestion) -> Option<Vec2> {
    let line = Interval::new(f32::NEG_INFINITY, f32::INFINITY);
    let near = SphereHit::answer(&SphereHitQuestion {
        within: line,
        ..q.clone()
    })?;
    let middle = (q.center - q.ray.origin).dot(*q.ray.direction);
    Some(vec2(near, 2.0 * middle - near))
}

/// The root that is picked, if it counts.
fn pick(q: &SphereHitQuestion, choose: fn(f32, f32) -> Option<f32>) -> Option<f32> {
    both(q)
        .and_then(|t| choose(t.x, t.y))
        .filter(|t| q.within.contains(*t))
}

impl Graded for SphereNormal {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "points inwards",
            hint: "From the centre to the point, or from the point to the centre?",
            answer: |q| -SphereNormal::answer(q),
        },
        Mistake {
            name: "forgets to normalise",
            hint: "How long is the vector from the centre to the point?",
            answer: |q| q.p - q.center,
        },
        Mistake {
            name: "takes the sphere to be at the origin",
            hint: "Move the sphere and the point by one metre: the normal must not change.",
            answer: |q| q.p.normalize_or_zero(),
        },
        Mistake {
            name: "divides by the radius squared",
            hint: "A normal has no unit: metres divided by what?",
            answer: |q| (q.p - q.center) / (q.radius * q.radius),
        },
        Mistake {
            name: "multiplies by the radius",
            hint: "Try a sphere of radius 2: how long is your normal?",
            answer: |q| (q.p - q.center) * q.radius,
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, center: Vec3, radius: f32, toward: Vec3| {
            Edge::new(
                name,
                SphereNormalQuestion {
                    center,
                    radius,
                    p: center + radius * toward.normalize(),
                },
            )
        };
        vec![
            edge("the top of the unit sphere", Vec3::ZERO, 1.0, Vec3::Y),
            edge("a larger sphere", Vec3::ZERO, 4.0, Vec3::X),
            edge("a small sphere", Vec3::ZERO, 0.125, Vec3::NEG_Z),
            edge(
                "away from the origin",
                vec3(5.0, -3.0, 2.0),
                2.0,
                Vec3::NEG_Y,
            ),
            edge("askew", vec3(1.0, 2.0, 3.0), 0.5, vec3(1.0, -1.0, 1.0)),
            edge(
                "the side towards the world's origin",
                vec3(10.0, 0.0, 0.0),
                1.0,
                Vec3::NEG_X,
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> SphereNormalQuestion {
        let (center, radius) = (sample::point(rng, 5.0), sample::number(rng, 0.3, 3.0));
        SphereNormalQuestion {
            center,
            radius,
            p: center + radius * *sample::direction(rng),
        }
    }

    fn judge(_q: &SphereNormalQuestion, golden: &Vec3, got: &Vec3) -> Verdict {
        judge::direction("the normal", *golden, *got)
    }
}

//! Chapter 5: `box_clip`, `bounds_of`.

use crate::grade::examine::Examiner;
use crate::grade::{Edge, Graded, Mistake, Picture, Verdict, judge, sample};
use crate::image::rgb::Rgb;
use crate::lab::palette::viridis;
use crate::math::{dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use crate::workbook::exercise::Exercise;
use crate::workbook::exercises::ch05_box::{
    BoundsOf, BoundsOfQuestion, BoxClip, BoxClipQuestion, Corners,
};
use glam::{Vec3, vec3};
use rand::RngExt;

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&BoxClip, &BoundsOf];

impl Graded for BoxClip {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "does not swap the planes for a negative direction",
            hint: "A ray that goes left meets the right side first.",
            answer: |q| slabs(q, |near, far, _| (near, far), |min, max| min <= max),
        },
        Mistake {
            name: "keeps the union of the slabs, not their overlap",
            hint: "To be inside the box, the ray must be inside all three slabs at once: is that the earliest entry or the latest?",
            answer: |q| {
                let all = (0..3)
                    .map(|axis| slab(q, axis))
                    .reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))?;
                finish(all.0.max(q.within.min), all.1.min(q.within.max))
            },
        },
        Mistake {
            name: "divides 0 by 0 for a ray in a face",
            hint: "A ray that runs in a face has o − min = 0 and d = 0: what is 0/0, and what does a comparison make of it?",
            answer: |q| {
                let nan = (0..3).any(|axis| {
                    q.ray.direction[axis] == 0.0
                        && [q.min[axis], q.max[axis]].contains(&q.ray.origin[axis])
                });
                BoxClip::answer(q).filter(|_| !nan)
            },
        },
        Mistake {
            name: "skips an axis along which the ray does not move",
            hint: "A ray parallel to a slab is inside it always, or never: which?",
            answer: |q| {
                let moving = (0..3)
                    .filter(|&axis| q.ray.direction[axis] != 0.0)
                    .map(|axis| slab(q, axis));
                let (min, max) = moving
                    .fold((q.within.min, q.within.max), |(min, max), (near, far)| {
                        (min.max(near), max.min(far))
                    });
                finish(min, max)
            },
        },
        Mistake {
            name: "ignores the interval",
            hint: "You are asked for a part of the interval: can your answer be longer than it is?",
            answer: |q| {
                BoxClip::answer(&BoxClipQuestion {
                    within: Interval::new(f32::NEG_INFINITY, f32::INFINITY),
                    ..q.clone()
                })
            },
        },
        Mistake {
            name: "wants the ray to start outside",
            hint: "Put the origin inside the box: on which part of the ray is it inside?",
            answer: |q| {
                BoxClip::answer(q).filter(|_| (0..3).any(|axis| slab(q, axis).0 >= q.within.min))
            },
        },
        Mistake {
            name: "takes the box for one around the origin",
            hint: "Move the box and the ray by one metre: the answer must not change.",
            answer: |q| {
                let half = 0.5 * (q.max - q.min);
                BoxClip::answer(&BoxClipQuestion {
                    min: -half,
                    max: half,
                    ..q.clone()
                })
            },
        },
    ];

    const PICTURE: Option<Picture<Self>> = Some(Picture {
        width: 96,
        height: 54,
        alt: "How much of each ray is inside a box: the brighter, the more",
        question: |x, y| {
            let toward = vec3((x as f32 - 47.5) / 54.0, (26.5 - y as f32) / 54.0, -1.0);
            let turned = vec3(0.8 * toward.x - 0.6, toward.y - 0.4, -0.8 + 0.6 * -toward.x);
            let ray = Ray::new(vec3(2.0, 1.4, 2.6), Dir3::new_or(turned, Dir3::Z));
            BoxClipQuestion {
                ray,
                within: Interval::AHEAD,
                min: vec3(-1.0, -0.6, -0.8),
                max: vec3(0.8, 0.7, 0.6),
            }
        },
        colour: |_, inside| {
            inside.map_or(Rgb::gray(0.1), |inside| {
                viridis((inside.max - inside.min) / 2.2)
            })
        },
    });

    fn edges() -> Vec<Edge<Self>> {
        let question = |origin, toward, within| BoxClipQuestion {
            ray: Ray::new(origin, Dir3::new_or(toward, Dir3::Z)),
            within,
            min: vec3(1.0, -1.0, -2.0),
            max: vec3(3.0, 1.0, 2.0),
        };
        let ahead = Interval::AHEAD;
        let flat = |q: BoxClipQuestion| BoxClipQuestion {
            max: vec3(3.0, -1.0, 2.0),
            ..q
        };
        vec![
            Edge::new(
                "straight through along x",
                question(Vec3::ZERO, Vec3::X, ahead),
            ),
            Edge::new(
                "straight through the other way",
                question(vec3(5.0, 0.0, 0.0), Vec3::NEG_X, ahead),
            ),
            Edge::new(
                "from inside",
                question(vec3(2.0, 0.0, 0.0), vec3(1.0, 1.0, 0.0), ahead),
            ),
            Edge::new(
                "the box is behind",
                question(Vec3::ZERO, Vec3::NEG_X, ahead),
            ),
            Edge::new(
                "beside it, parallel",
                question(vec3(0.0, 3.0, 0.0), Vec3::X, ahead),
            ),
            Edge::new(
                "beside it, parallel, with a negative zero",
                question(vec3(0.0, 3.0, 0.0), vec3(1.0, -0.0, -0.0), ahead),
            ),
            Edge::new(
                "through it with a negative zero",
                question(Vec3::ZERO, vec3(1.0, -0.0, 0.0), ahead),
            ),
            Edge::new("in a face", question(vec3(0.0, 1.0, 0.0), Vec3::X, ahead)),
            Edge::new(
                "askew",
                question(vec3(0.0, 0.5, -3.0), vec3(1.0, -0.25, 2.0), ahead),
            ),
            Edge::new(
                "just past a corner",
                question(Vec3::ZERO, vec3(1.0, 1.1, 0.0), ahead),
            ),
            Edge::new(
                "the interval ends inside",
                question(Vec3::ZERO, Vec3::X, Interval::new(0.0, 2.5)),
            ),
            Edge::new(
                "the interval ends before it",
                question(Vec3::ZERO, Vec3::X, Interval::new(0.0, 0.5)),
            ),
            Edge::new(
                "a flat box",
                flat(question(vec3(2.0, 4.0, 0.0), Vec3::NEG_Y, ahead)),
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> BoxClipQuestion {
        let (center, half) = (
            sample::point(rng, 3.0),
            Vec3::splat(1.25) + sample::point(rng, 1.0),
        );
        let origin = center + sample::point(rng, 5.0);
        let aim = center + sample::point(rng, 1.5) * half;
        let max = if rng.random_bool(0.3) {
            sample::number(rng, 1.0, 8.0)
        } else {
            f32::INFINITY
        };
        BoxClipQuestion {
            ray: Ray::new(origin, Dir3::new_or(aim - origin, Dir3::X)),
            within: Interval::new(0.0, max),
            min: center - half,
            max: center + half,
        }
    }

    fn judge(_q: &BoxClipQuestion, golden: &Option<Interval>, got: &Option<Interval>) -> Verdict {
        judge::option(
            "a part of the ray inside the box",
            golden.as_ref(),
            got.as_ref(),
            |golden, got| {
                judge::number("the entry", "m", golden.min, got.min)?;
                judge::number("the exit", "m", golden.max, got.max)
            },
        )
    }
}

/// Where the whole line enters and leaves the slab of an axis; by the right rule.
fn slab(q: &BoxClipQuestion, axis: usize) -> (f32, f32) {
    let (o, d) = (q.ray.origin[axis], q.ray.direction[axis]);
    let (a, b) = ((q.min[axis] - o) / d, (q.max[axis] - o) / d);
    if d.is_sign_negative() { (b, a) } else { (a, b) }
}

/// Clips by three slabs, by a rule for the order of the planes and one for when there is anything left.
fn slabs(
    q: &BoxClipQuestion,
    order: fn(f32, f32, f32) -> (f32, f32),
    keep: fn(f32, f32) -> bool,
) -> Option<Interval> {
    let Interval { mut min, mut max } = q.within;
    for axis in 0..3 {
        let (o, d) = (q.ray.origin[axis], q.ray.direction[axis]);
        let (near, far) = order((q.min[axis] - o) / d, (q.max[axis] - o) / d, d);
        (min, max) = (min.max(near), max.min(far));
    }
    keep(min, max).then_some(Interval { min, max })
}

fn finish(min: f32, max: f32) -> Option<Interval> {
    (max - min >= 0.0).then_some(Interval { min, max })
}

impl Graded for BoundsOf {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "starts with the origin inside",
            hint: "Bound points that are all far from the world's origin: is the origin in your box?",
            answer: |q| bounds(q.points.iter().copied().chain([Vec3::ZERO])),
        },
        Mistake {
            name: "forgets the last point",
            hint: "Bound a single point: what is its box?",
            answer: |q| bounds(q.points.iter().copied().take(q.points.len().max(2) - 1)),
        },
        Mistake {
            name: "swaps the corners",
            hint: "Which of the two corners has the smaller coordinates?",
            answer: |q| {
                let Corners { min, max } = BoundsOf::answer(q);
                Corners { min: max, max: min }
            },
        },
        Mistake {
            name: "bounds by the first and the last point only",
            hint: "Put the outermost point in the middle of the list.",
            answer: |q| bounds(q.points.first().into_iter().chain(q.points.last()).copied()),
        },
        Mistake {
            name: "takes the smallest positive number for the smallest number",
            hint: "Try points whose coordinates are all negative; what is your box's max before the first point?",
            answer: |q| {
                let Corners { min, max } = BoundsOf::answer(q);
                Corners {
                    min,
                    max: max.max(Vec3::splat(f32::MIN_POSITIVE)),
                }
            },
        },
        Mistake {
            name: "makes the box a cube",
            hint: "Each axis has a smallest and a largest coordinate of its own.",
            answer: |q| {
                let Corners { min, max } = BoundsOf::answer(q);
                Corners {
                    min: Vec3::splat(min.min_element()),
                    max: Vec3::splat(max.max_element()),
                }
            },
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, points: &[Vec3]| {
            Edge::new(
                name,
                BoundsOfQuestion {
                    points: points.to_vec(),
                },
            )
        };
        let (a, b, c) = (
            vec3(1.0, 5.0, -2.0),
            vec3(4.0, 2.0, 6.0),
            vec3(2.0, 8.0, 1.0),
        );
        vec![
            edge("one point", &[a]),
            edge("two points", &[a, b]),
            edge("the extremes come from different points", &[a, b, c]),
            edge(
                "the outermost point is in the middle",
                &[a, vec3(9.0, -9.0, 9.0), b],
            ),
            edge(
                "all coordinates are negative",
                &[vec3(-1.0, -2.0, -3.0), vec3(-4.0, -5.0, -1.5)],
            ),
            edge("all coordinates are positive", &[b, vec3(5.0, 3.0, 7.0)]),
            edge("the same point twice", &[c, c]),
            edge("no points: the empty box, from +infinity to -infinity", &[]),
        ]
    }

    fn random(rng: &mut Pcg) -> BoundsOfQuestion {
        let center = sample::point(rng, 6.0);
        let count = rng.random_range(1..8);
        BoundsOfQuestion {
            points: (0..count)
                .map(|_| center + sample::point(rng, 3.0))
                .collect(),
        }
    }

    fn judge(_q: &BoundsOfQuestion, golden: &Corners, got: &Corners) -> Verdict {
        for (name, golden, got) in [("min", golden.min, got.min), ("max", golden.max, got.max)] {
            for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
                judge::number_within(
                    &format!("{name}.{letter}"),
                    "m",
                    golden[axis],
                    got[axis],
                    1e-5 * golden[axis].abs().max(1.0),
                )?;
            }
        }
        Ok(())
    }
}

/// The box of points, as an answer.
fn bounds(points: impl Iterator<Item = Vec3>) -> Corners {
    BoundsOf::answer(&BoundsOfQuestion {
        points: points.collect(),
    })
}

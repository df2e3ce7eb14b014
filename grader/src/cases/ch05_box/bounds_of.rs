//! `bounds_of`: random questions, judge and mistakes.

use crate::{Flaw, Graded, Mistake, Relation, Verdict, judge, sample};
use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch05_box::{BoundsOf, Corners};
use std::cmp::Ordering;

impl Graded for BoundsOf {
    fn random(rng: &mut Pcg) -> BoundsOf {
        let center = sample::point(rng, 6.0);
        let count = rng.random_range(1..8);
        BoundsOf {
            points: (0..count)
                .map(|_| center + sample::point(rng, 3.0))
                .collect(),
        }
    }

    fn judge(_q: &BoundsOf, golden: &Corners, got: &Corners) -> Verdict {
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

    const FLAWS: &'static [Flaw] = &[Flaw {
        complaint: "and should be inf",
        name: "returns another box for no points than the empty one",
        hint: "Which box is contained in every other, so that adding a point to it gives the point?",
    }];

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| BoundsOf {
        points: q.points.iter().map(|p| *p + sample::METRE).collect(),
    })];

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
            name: "looks for a new greatest coordinate only if there was no new least one (else if)",
            hint: "Bound a single point: which of your two conditions does it meet, and which should it?",
            answer: |q| {
                let empty = bounds([].into_iter());
                q.points
                    .iter()
                    .fold(empty, |Corners { min, max }, p| Corners {
                        min: min.min(*p),
                        max: Vec3::select(p.cmplt(min), max, max.max(*p)),
                    })
            },
        },
        Mistake {
            name: "compares absolute values",
            hint: "Which is less: −3 or 1?",
            answer: |q| {
                let chosen = |is_nearer: bool, none: f32| {
                    let of = |a: f32, b: f32| {
                        if (b.abs() < a.abs()) == is_nearer {
                            b
                        } else {
                            a
                        }
                    };
                    let points = q.points.iter().copied();
                    let point =
                        points.reduce(|a, b| vec3(of(a.x, b.x), of(a.y, b.y), of(a.z, b.z)));
                    point.unwrap_or(Vec3::splat(none))
                };
                Corners {
                    min: chosen(true, f32::INFINITY),
                    max: chosen(false, f32::NEG_INFINITY),
                }
            },
        },
        Mistake {
            name: "swaps the corners",
            hint: "Which of the two corners has the smaller coordinates?",
            answer: |q| {
                let Corners { min, max } = BoundsOf::right(q);
                Corners { min: max, max: min }
            },
        },
        Mistake {
            name: "compares points as a whole: by x, and by y and z only where x is equal",
            hint: "The least x and the least y may come from different points: what does your language compare first of two rows of numbers?",
            answer: |q| {
                let mut points = q.points.clone();
                points.sort_by(|a, b| {
                    let axes = (0..3).map(|axis| a[axis].total_cmp(&b[axis]));
                    axes.fold(Ordering::Equal, Ordering::then)
                });
                match (points.first(), points.last()) {
                    (Some(&min), Some(&max)) => Corners { min, max },
                    _ => BoundsOf::right(q),
                }
            },
        },
        Mistake {
            name: "bounds by the first and the last point only",
            hint: "Put the outermost point in the middle of the list.",
            answer: |q| bounds(q.points.first().into_iter().chain(q.points.last()).copied()),
        },
        Mistake {
            name: "starts the greatest corner at 0, or at the smallest positive number",
            hint: "Try points whose coordinates are all negative; what is your box's max before the first point?",
            answer: |q| {
                let Corners { min, max } = BoundsOf::right(q);
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
                let Corners { min, max } = BoundsOf::right(q);
                Corners {
                    min: Vec3::splat(min.min_element()),
                    max: Vec3::splat(max.max_element()),
                }
            },
        },
        Mistake {
            name: "returns the centre and half of the size",
            hint: "Which two points are asked for?",
            answer: |q| {
                let Corners { min, max } = BoundsOf::right(q);
                Corners {
                    min: 0.5 * (min + max),
                    max: 0.5 * (max - min),
                }
            },
        },
        Mistake {
            name: "returns the size for the greatest corner",
            hint: "Is your second point a corner, or the way from the first corner?",
            answer: |q| {
                let Corners { min, max } = BoundsOf::right(q);
                Corners {
                    min,
                    max: max - min,
                }
            },
        },
        Mistake {
            name: "forgets the first point",
            hint: "Bound a single point: what is its box?",
            answer: |q| {
                bounds(
                    q.points
                        .iter()
                        .copied()
                        .skip(usize::from(q.points.len() > 1)),
                )
            },
        },
        Mistake {
            name: "returns zeros for no points",
            hint: "Which box is contained in every other, so that adding a point to it gives the point?",
            answer: |q| {
                if q.points.is_empty() {
                    bounds([Vec3::ZERO].into_iter())
                } else {
                    BoundsOf::right(q)
                }
            },
        },
        Mistake {
            name: "returns the empty box the other way round, its least corner at −∞",
            hint: "Which box is contained in every other, so that adding a point to it gives the point?",
            answer: |q| {
                let Corners { min, max } = BoundsOf::right(q);
                if q.points.is_empty() {
                    Corners { min: max, max: min }
                } else {
                    Corners { min, max }
                }
            },
        },
        Mistake {
            name: "never looks at x",
            hint: "How often does your loop over the axes go round?",
            answer: |q| {
                let mut right = BoundsOf::right(q);
                let empty = bounds([].into_iter());
                (right.min.x, right.max.x) = (empty.min.x, empty.max.x);
                right
            },
        },
        Mistake {
            name: "never looks at y",
            hint: "How often does your loop over the axes go round?",
            answer: |q| {
                let mut right = BoundsOf::right(q);
                let empty = bounds([].into_iter());
                (right.min.y, right.max.y) = (empty.min.y, empty.max.y);
                right
            },
        },
        Mistake {
            name: "never looks at z",
            hint: "How often does your loop over the axes go round?",
            answer: |q| {
                let mut right = BoundsOf::right(q);
                let empty = bounds([].into_iter());
                (right.min.z, right.max.z) = (empty.min.z, empty.max.z);
                right
            },
        },
        Mistake {
            name: "looks for a new least coordinate only if there was no new greatest one (else if)",
            hint: "Bound a single point: which of your two conditions does it meet, and which should it?",
            answer: |q| {
                let empty = bounds([].into_iter());
                q.points
                    .iter()
                    .fold(empty, |Corners { min, max }, p| Corners {
                        min: Vec3::select(p.cmpgt(max), min, min.min(*p)),
                        max: max.max(*p),
                    })
            },
        },
        Mistake {
            name: "moves one side of the box at most for each point (a chain of else if)",
            hint: "A point may lie outside along x and along y: how many of your conditions does it meet, and how many sides do you move?",
            answer: |q| {
                let Some(&first) = q.points.first() else {
                    return BoundsOf::right(q);
                };
                let (mut min, mut max) = (first, first);
                for p in &q.points {
                    for axis in 0..3 {
                        let (is_below, is_above) = (p[axis] < min[axis], p[axis] > max[axis]);
                        if is_below {
                            min[axis] = p[axis];
                        }
                        if is_above {
                            max[axis] = p[axis];
                        }
                        if is_below || is_above {
                            break;
                        }
                    }
                }
                Corners { min, max }
            },
        },
        Mistake {
            name: "ends at the first point that is inside already",
            hint: "A point inside changes nothing: does the next one?",
            answer: |q| {
                let Corners { mut min, mut max } = bounds([].into_iter());
                for p in &q.points {
                    if p.cmpge(min).all() && p.cmple(max).all() {
                        break;
                    }
                    (min, max) = (min.min(*p), max.max(*p));
                }
                Corners { min, max }
            },
        },
        Mistake {
            name: "starts the least corner at 0",
            hint: "Try points whose coordinates are all positive; what is your box's min before the first point?",
            answer: |q| {
                let Corners { min, max } = BoundsOf::right(q);
                Corners {
                    min: min.min(Vec3::ZERO),
                    max,
                }
            },
        },
        Mistake {
            name: "makes a flat box thicker, so that each side is at least 0.0001 long",
            hint: "What is the smallest box that holds a single point: how thick is it?",
            answer: |q| {
                let Corners { min, max } = BoundsOf::right(q);
                let pad = (max - min).map(|extent| {
                    if (0.0..1e-4).contains(&extent) {
                        5e-5
                    } else {
                        0.0
                    }
                });
                Corners {
                    min: min - pad,
                    max: max + pad,
                }
            },
        },
        Mistake {
            name: "takes the points nearest to and farthest from the world's origin for the corners",
            hint: "Must a corner of the box be one of the points? And does the box change if all of them are moved?",
            answer: |q| {
                let by_distance = |a: &&Vec3, b: &&Vec3| a.length().total_cmp(&b.length());
                let points = q.points.iter();
                match (
                    points.clone().min_by(by_distance),
                    points.max_by(by_distance),
                ) {
                    (Some(&min), Some(&max)) => Corners { min, max },
                    _ => BoundsOf::right(q),
                }
            },
        },
        Mistake {
            name: "returns the box of a sphere round the mean of the points",
            hint: "Each side of the smallest box touches a point: does each of yours?",
            answer: |q| {
                if q.points.is_empty() {
                    return BoundsOf::right(q);
                }
                let middle = q.points.iter().sum::<Vec3>() / q.points.len() as f32;
                let farthest = |most: f32, p: &Vec3| most.max(p.distance(middle));
                let radius = q.points.iter().fold(0.0, farthest);
                Corners {
                    min: middle - radius,
                    max: middle + radius,
                }
            },
        },
        Mistake {
            name: "takes the points with the least and with the greatest sum of coordinates for the corners",
            hint: "Must a corner of the box be one of the points? Bound (1, 5, −2) and (4, 2, 6): from which of the two comes the least y?",
            answer: |q| {
                let sum = |p: &Vec3| p.element_sum();
                let by_sum = |a: &&Vec3, b: &&Vec3| sum(a).total_cmp(&sum(b));
                let points = q.points.iter();
                // Of equal sums the first counts, and `max_by` takes the last.
                match (points.clone().min_by(by_sum), points.rev().max_by(by_sum)) {
                    (Some(&min), Some(&max)) => Corners { min, max },
                    _ => BoundsOf::right(q),
                }
            },
        },
        Mistake {
            name: "starts with the origin inside, unless there are no points",
            hint: "Bound points that are all far from the world's origin: is the origin in your box?",
            answer: |q| {
                if q.points.is_empty() {
                    return BoundsOf::right(q);
                }
                bounds(q.points.iter().copied().chain([Vec3::ZERO]))
            },
        },
    ];
}

/// The box of points, as an answer.
fn bounds(points: impl Iterator<Item = Vec3>) -> Corners {
    BoundsOf::right(&BoundsOf {
        points: points.collect(),
    })
}

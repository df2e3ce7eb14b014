//! `box_clip`: random questions, judge and mistakes.

mod clips;

use crate::{Graded, Mistake, Picture, Relation, Verdict, judge, sample};
use clips::{
    FAR_FIRST, IS_NOT_EMPTY, MIN_AND_MAX, NEAR_FIRST, Parallel, clipped, crossings, is_edge,
    once_at_edges, overlap, unless_alone, whole,
};
use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::image::rgb::Rgb;
use raybook::math::{interval::Interval, pcg::Pcg, ray::Ray};
use raybook_chapters::kit::palette::viridis;
use raybook_workbook::exercises::ch05_box::BoxClip;

impl Graded for BoxClip {
    fn random(rng: &mut Pcg) -> BoxClip {
        let (center, half) = (
            sample::point(rng, 3.0),
            Vec3::splat(1.25) + sample::point(rng, 1.0),
        );
        // One ray in eight passes close to an edge, on either side of it, and one in four is parallel to faces.
        let ray = match rng.random_range(0..8) {
            0 => beside_an_edge(rng, center, half),
            1 | 2 => parallel_to_faces(rng, center, half),
            _ => {
                let origin = center + sample::point(rng, 5.0);
                let aim = center + sample::point(rng, 1.5) * half;
                sample::ray(origin, aim - origin)
            }
        };
        // One interval in two begins ahead of the ray's origin or behind it, and the box may be behind it, too.
        let (ray, min) = if rng.random_bool(0.5) {
            let origin = ray.at(sample::number(rng, 0.0, 8.0));
            let min = sample::number(rng, -6.0, 2.0);
            (Ray::new(origin, ray.direction), min)
        } else {
            (ray, 0.0)
        };
        let max = min + sample::end(rng, 0.3, 1.0, 8.0);
        BoxClip {
            ray,
            within: Interval::new(min, max),
            min: center - half,
            max: center + half,
        }
    }

    fn is_sound(q: &BoxClip) -> bool {
        sample::is_box(q.min, q.max)
    }

    fn judge(_q: &BoxClip, golden: &Option<Interval>, got: &Option<Interval>) -> Verdict {
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

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| BoxClip {
        ray: sample::moved(&q.ray),
        min: q.min + sample::METRE,
        max: q.max + sample::METRE,
        ..q.clone()
    })];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "does not swap the planes for a negative direction",
            hint: "A ray that goes left meets the right side first.",
            answer: |q| {
                clipped(q, |how| {
                    how.swapped_by = [None; 3];
                    how.parallel = Parallel::Divided;
                    how.is_left = |part| part.min <= part.max;
                })
            },
        },
        Mistake {
            name: "keeps the union of the slabs, not their overlap",
            hint: "To be inside the box, the ray must be inside all three slabs at once: is that the earliest entry or the latest?",
            answer: |q| {
                clipped(q, |how| {
                    how.parallel = Parallel::Divided;
                    how.start = |_| Interval::new(f32::INFINITY, f32::NEG_INFINITY);
                    how.enter = |entry, near, _| entry.min(near);
                    how.leave = |exit, far, _| exit.max(far);
                    how.is_cut_at_end = true;
                })
            },
        },
        Mistake {
            name: "keeps the earliest of the entries",
            hint: "At the first plane that the ray meets, is it inside the other two slabs already?",
            answer: |q| {
                clipped(q, |how| {
                    how.enter = |entry, near, _| entry.min(near);
                    how.parallel = Parallel::Divided;
                })
            },
        },
        Mistake {
            name: "keeps the latest of the exits",
            hint: "Once the ray has left one slab, is it still in the box?",
            answer: |q| {
                clipped(q, |how| {
                    how.leave = |exit, far, _| exit.max(far);
                    how.parallel = Parallel::Divided;
                })
            },
        },
        Mistake {
            name: "compares the entry and the exit of each slab with the ends of the interval, not with those of what is left",
            hint: "The first slab leaves 2 to 9, and the second one is entered at 1: where does what is left begin?",
            answer: |q| {
                clipped(q, |how| {
                    how.enter = |entry, near, start| if near > start { near } else { entry };
                    how.leave = |exit, far, end| if far < end { far } else { exit };
                })
            },
        },
        Mistake {
            name: "keeps the latest of the exits, and has a case of its own for a parallel ray",
            hint: "Once the ray has left one slab, is it still in the box?",
            answer: |q| clipped(q, |how| how.leave = |exit, far, _| exit.max(far)),
        },
        Mistake {
            name: "misses a ray that runs in a face: by 0/0, or by < instead of ≤",
            hint: "A ray that runs in a face has o − min = 0 and d = 0: what is 0/0, what does a comparison make of it, and does yours count a ray in the face as inside?",
            answer: |q| {
                let nan = (0..3).any(|axis| {
                    q.ray.direction[axis] == 0.0
                        && [q.min[axis], q.max[axis]].contains(&q.ray.origin[axis])
                });
                BoxClip::right(q).filter(|_| !nan)
            },
        },
        Mistake {
            name: "lets a comparison with NaN decide where a ray runs in a face",
            hint: "In a face, one of the slab's two distances is 0/0, which is NaN: which of two numbers do your comparisons, or the least and the greatest of two vectors, take if one is NaN?",
            answer: |q| {
                clipped(q, |how| {
                    how.order = |a, b, _| (if a < b { a } else { b }, if a > b { a } else { b });
                    how.parallel = Parallel::Divided;
                    how.is_left = |part| part.min <= part.max;
                })
            },
        },
        Mistake {
            name: "multiplies by 1/0 = ∞, and lets 0 · ∞ = NaN take the place of an end where a ray runs in a face",
            hint: "In a face, the way to one of the slab's planes is 0: what is 0 · ∞? And which of two numbers do your `min` and `max` take if the first is NaN?",
            answer: |q| {
                clipped(q, |how| {
                    how.parallel = Parallel::Divided;
                    how.order = |a, b, _| if a > b { (b, a) } else { (a, b) };
                    (how.enter, how.leave) = (NEAR_FIRST, FAR_FIRST);
                    how.is_left = IS_NOT_EMPTY;
                })
            },
        },
        Mistake {
            name: "multiplies by 1/0 = ∞, orders a slab's two distances by `min` and `max` though 0 · ∞ is NaN, and lets NaN take the place of an end",
            hint: "In a face, the way to one of the slab's planes is 0: what is 0 · ∞? And which of two numbers do your `min` and `max` take if the first is NaN?",
            answer: |q| {
                clipped(q, |how| {
                    how.parallel = Parallel::Divided;
                    how.order = MIN_AND_MAX;
                    (how.enter, how.leave) = (NEAR_FIRST, FAR_FIRST);
                    how.is_left = IS_NOT_EMPTY;
                })
            },
        },
        Mistake {
            name: "multiplies by 1/0 = ∞, and orders a slab's two distances by `min` and `max` though 0 · ∞ is NaN",
            hint: "In a face, the way to one of the slab's planes is 0: what is 0 · ∞? And which of two numbers do your `min` and `max` take if the second is NaN?",
            answer: |q| {
                clipped(q, |how| {
                    how.parallel = Parallel::Divided;
                    how.order = MIN_AND_MAX;
                    how.is_left = IS_NOT_EMPTY;
                })
            },
        },
        Mistake {
            name: "skips an axis along which the ray does not move",
            hint: "A ray parallel to a slab is inside it always, or never: which?",
            answer: |q| clipped(q, |how| how.parallel = Parallel::Skipped),
        },
        Mistake {
            name: "ignores the interval",
            hint: "You are asked for a part of the interval: can your answer be longer than it is?",
            answer: |q| Self::misread(q, |q| q.within = sample::LINE),
        },
        Mistake {
            name: "finds nothing if the ray starts inside the box",
            hint: "Put the origin inside the box: on which part of the ray is it inside?",
            answer: |q| {
                let starts_outside = whole(q)?.min >= q.within.min;
                Self::right(q).filter(|_| starts_outside)
            },
        },
        Mistake {
            name: "takes the box to be around the world's origin",
            hint: "Move the box and the ray by one metre: the answer must not change.",
            answer: |q| {
                let half = 0.5 * (q.max - q.min);
                Self::misread(q, |q| (q.min, q.max) = (-half, half))
            },
        },
        Mistake {
            name: "forgets the x axis",
            hint: "How many pairs of planes has a box?",
            answer: |q| Self::misread(q, |q| (q.min.x, q.max.x) = (-1e9, 1e9)),
        },
        Mistake {
            name: "forgets the y axis",
            hint: "How many pairs of planes has a box?",
            answer: |q| Self::misread(q, |q| (q.min.y, q.max.y) = (-1e9, 1e9)),
        },
        Mistake {
            name: "forgets the z axis",
            hint: "How many pairs of planes has a box?",
            answer: |q| Self::misread(q, |q| (q.min.z, q.max.z) = (-1e9, 1e9)),
        },
        Mistake {
            name: "calls every ray that is parallel to a face a miss",
            hint: "A ray that never leaves the slab between two faces: what does that slab cut off?",
            answer: |q| {
                BoxClip::right(q).filter(|_| q.ray.direction.to_array().iter().all(|d| *d != 0.0))
            },
        },
        Mistake {
            name: "misses what the ray only touches",
            hint: "At an edge, the ray enters and leaves at the same t: is that empty?",
            answer: |q| BoxClip::right(q).filter(|part| part.min < part.max),
        },
        Mistake {
            name: "keeps the union of the slabs and the interval, not their overlap",
            hint: "To be inside the box, the ray must be inside all three slabs and in the interval at once: is that the earliest entry or the latest?",
            answer: |q| {
                clipped(q, |how| {
                    how.enter = |entry, near, _| entry.min(near);
                    how.leave = |exit, far, _| exit.max(far);
                })
            },
        },
        Mistake {
            name: "asks whether the interval overlaps the box, but does not cut the answer to the interval",
            hint: "You are asked for a part of the interval: may your answer begin before min, or end behind max?",
            answer: |q| {
                whole(q).filter(|part| part.max >= q.within.min && part.min <= q.within.max)
            },
        },
        Mistake {
            name: "keeps the entry and the exit of the last axis only",
            hint: "The ray is inside the box once it has entered all three slabs: do you keep the latest entry, or the last one that you calculate?",
            answer: |q| {
                clipped(q, |how| {
                    how.check = |_, part, slab| overlap(part, slab).is_some();
                    how.enter = |_, near, _| near;
                    how.leave = |_, far, _| far;
                    how.is_cut_at_end = true;
                })
            },
        },
        Mistake {
            name: "gives up a box that lies behind the ray's origin",
            hint: "An interval may begin before 0: is what lies behind the origin in it?",
            answer: |q| Self::right(q).filter(|part| part.max >= 0.0),
        },
        Mistake {
            name: "returns the exit twice where the interval begins inside the box",
            hint: "Put the origin inside the box: on which part of the ray is it inside?",
            answer: |q| {
                let begins_inside = whole(q)?.min < q.within.min;
                Self::right(q).map(|part| {
                    if begins_inside {
                        Interval::new(part.max, part.max)
                    } else {
                        part
                    }
                })
            },
        },
        Mistake {
            name: "takes 0 for 1/0, and so has both planes of a parallel slab at the distance 0",
            hint: "A ray that is parallel to a slab never meets its planes: how far away should they be?",
            answer: |q| {
                clipped(q, |how| {
                    how.distance = |way, d| if d == 0.0 { 0.0 } else { way / d };
                    how.parallel = Parallel::Divided;
                })
            },
        },
        Mistake {
            name: "decides by the sign of the direction's x which plane comes first along all axes",
            hint: "A ray may go to the right and down: which plane of each axis does it meet first?",
            answer: |q| clipped(q, |how| how.swapped_by = [Some(0); 3]),
        },
        Mistake {
            name: "takes the greatest corner for the box's size, and adds it to the least",
            hint: "Which planes has the box along x: those of its two corners, or others?",
            answer: |q| {
                clipped(q, |how| {
                    how.planes = |q, axis| [q.min[axis], q.min[axis] + q.max[axis]];
                    how.order = |a, b, _| (a.min(b), a.max(b));
                })
            },
        },
        Mistake {
            name: "wants the box's whole chord in the interval",
            hint: "You are asked for a part of the interval: what if the interval begins or ends inside the box?",
            answer: |q| {
                whole(q).filter(|part| part.min >= q.within.min && part.max <= q.within.max)
            },
        },
        Mistake {
            name: "misses what the ray is inside of for less than a millimetre",
            hint: "How long must the part be to count? The ray may pass just beside an edge.",
            answer: |q| BoxClip::right(q).filter(|part| part.max - part.min >= 1e-3),
        },
        Mistake {
            name: "moves the exit along an axis only if it does not move the entry there (else if)",
            hint: "The box is entered and left along each axis: may one axis move both ends?",
            answer: |q| clipped(q, |how| how.is_either = true),
        },
        Mistake {
            name: "skips an axis if the ray begins between its two planes",
            hint: "The ray begins inside, and never leaves in your program: which axes do you ask?",
            answer: |q| {
                Self::misread(q, |q| {
                    for axis in 0..3 {
                        if (q.min[axis]..=q.max[axis]).contains(&q.ray.origin[axis]) {
                            (q.min[axis], q.max[axis]) = (f32::NEG_INFINITY, f32::INFINITY);
                        }
                    }
                })
            },
        },
        Mistake {
            name: "orders z's planes by the sign of the direction's y, or y's by that of its z",
            hint: "Which component of the direction tells which plane across an axis comes first? Was a line copied?",
            answer: |q| clipped(q, |how| how.swapped_by[2] = Some(1)),
        },
        Mistake {
            name: "orders y's planes by the sign of the direction's x, or x's by that of its y",
            hint: "Which component of the direction tells which plane across an axis comes first? Was a line copied?",
            answer: |q| clipped(q, |how| how.swapped_by[1] = Some(0)),
        },
        Mistake {
            name: "orders z's planes by the sign of the direction's x, or x's by that of its z",
            hint: "Which component of the direction tells which plane across an axis comes first? Was a line copied?",
            answer: |q| clipped(q, |how| how.swapped_by[2] = Some(0)),
        },
        Mistake {
            name: "does not cut the answer off at the interval's max",
            hint: "You are asked for a part of the interval: may your answer end behind max?",
            answer: |q| {
                let Interval { max, .. } = whole(q)?;
                Self::right(q).map(|part| Interval { max, ..part })
            },
        },
        Mistake {
            name: "does not cut the answer off at the interval's min",
            hint: "You are asked for a part of the interval: may your answer begin before min?",
            answer: |q| {
                let Interval { min, .. } = whole(q)?;
                Self::right(q).map(|part| Interval { min, ..part })
            },
        },
        Mistake {
            name: "takes a face that is crossed alone in the interval for the exit, even where the interval ends inside",
            hint: "The interval ends inside the box: which face does the ray cross before, the one of the entry or of the exit?",
            answer: |q| {
                unless_alone(q, &once_at_edges(crossings(q)), |q, t| Interval {
                    max: t,
                    ..q.within
                })
            },
        },
        Mistake {
            name: "takes a face that is crossed alone in the interval for the exit, and an edge for the entry and the exit",
            hint: "An edge is crossed: by how many faces at once, and does the ray enter there, leave, or both?",
            answer: |q| {
                unless_alone(q, &crossings(q), |q, t| {
                    let min = if is_edge(q, t) { t } else { q.within.min };
                    Interval::new(min, t)
                })
            },
        },
        Mistake {
            name: "takes a face that is crossed alone in the interval for the entry, even where the interval begins inside",
            hint: "The interval begins inside the box: which face does the ray cross after that, the one of the entry or of the exit?",
            answer: |q| {
                unless_alone(q, &once_at_edges(crossings(q)), |q, t| Interval {
                    min: t,
                    ..q.within
                })
            },
        },
        Mistake {
            name: "returns the first and the last face that is crossed in the interval, also where that is only one",
            hint: "The interval begins or ends inside the box: how many faces does the ray cross in it, and where does your part begin and end?",
            answer: |q| {
                let crossings = crossings(q);
                Some(Interval::new(*crossings.first()?, *crossings.last()?))
            },
        },
        Mistake {
            name: "begins at 0 where the ray's origin is inside the box, whatever the interval says",
            hint: "The interval may begin elsewhere than at the ray's origin: where does it say so?",
            answer: |q| {
                let is_inside =
                    |axis: usize| (q.min[axis]..=q.max[axis]).contains(&q.ray.origin[axis]);
                let part = Self::right(q)?;
                let min = if (0..3).all(is_inside) { 0.0 } else { part.min };
                Some(Interval { min, ..part })
            },
        },
        Mistake {
            name: "does not swap the planes for a negative direction, and has a case of its own for a parallel ray",
            hint: "A ray that goes left meets the right side first: which of your two distances is the entry then?",
            answer: |q| clipped(q, |how| how.swapped_by = [None; 3]),
        },
        Mistake {
            name: "does not swap the planes for a negative direction along x",
            hint: "A ray that goes left meets the right side first: which of your two distances is the entry then?",
            answer: |q| clipped(q, |how| how.swapped_by[0] = None),
        },
        Mistake {
            name: "does not swap the planes for a negative direction along y",
            hint: "A ray that goes down meets the upper side first: which of your two distances is the entry then?",
            answer: |q| clipped(q, |how| how.swapped_by[1] = None),
        },
        Mistake {
            name: "does not swap the planes for a negative direction along z",
            hint: "A ray that goes against z meets the side of greater z first: which of your two distances is the entry then?",
            answer: |q| clipped(q, |how| how.swapped_by[2] = None),
        },
        Mistake {
            name: "does not ask whether anything is left after the last axis",
            hint: "A ray passes above the box: when does your loop ask whether the end is before the beginning, and how often?",
            answer: |q| {
                clipped(q, |how| {
                    how.check = |axis, part, slab| axis == 2 || overlap(part, slab).is_some();
                    how.is_left = |_| true;
                })
            },
        },
        Mistake {
            name: "takes 0 for within.min, wherever the interval begins",
            hint: "An interval may begin ahead of the origin or behind it: which part of the ray is before `min`?",
            answer: |q| Self::misread(q, |q| q.within.min = 0.0),
        },
        Mistake {
            name: "takes 0 for within.min where the interval begins behind the origin",
            hint: "An interval may begin behind the origin: is what lies there in it?",
            answer: |q| Self::misread(q, |q| q.within.min = q.within.min.max(0.0)),
        },
        Mistake {
            name: "keeps the entry of the last axis only, or the interval's min if that is later",
            hint: "The ray is in the box where it is in all three slabs: which of the three entries counts?",
            answer: |q| clipped(q, |how| how.enter = |_, near, start| near.max(start)),
        },
        Mistake {
            name: "keeps the exit of the last axis only, or the interval's max if that is earlier",
            hint: "The ray is in the box where it is in all three slabs: which of the three exits counts?",
            answer: |q| clipped(q, |how| how.leave = |_, far, end| far.min(end)),
        },
        Mistake {
            name: "keeps the entry of the last axis only, also where the interval begins later",
            hint: "The ray is in the box where it is in all three slabs: which of the three entries counts, and where does the interval begin?",
            answer: |q| {
                clipped(q, |how| {
                    how.check = |_, part, slab| slab.min <= part.max.min(slab.max);
                    how.enter = |_, near, _| near;
                })
            },
        },
        Mistake {
            name: "keeps the exit of the last axis only, also where the interval ends earlier",
            hint: "The ray is in the box where it is in all three slabs: which of the three exits counts, and where does the interval end?",
            answer: |q| {
                clipped(q, |how| {
                    how.check = |_, part, slab| part.min.max(slab.min) <= slab.max;
                    how.leave = |_, far, _| far;
                })
            },
        },
    ];

    const PICTURES: &'static [Picture<Self>] = &[Picture {
        name: "box_clip",
        width: 96,
        height: 54,
        alt: "How much of each ray is inside a box: the brighter, the more",
        question: |x, y| {
            let toward = sample::pixel(x, y);
            let turned = vec3(0.8 * toward.x - 0.6, toward.y - 0.4, -0.8 + 0.6 * -toward.x);
            let ray = sample::ray(vec3(2.0, 1.4, 2.6), turned);
            BoxClip {
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
    }];
}

/// A ray close to an edge that is part of the box's outline as the ray sees it: it leaves one slab about where it enters another.
fn beside_an_edge(rng: &mut Pcg, center: Vec3, half: Vec3) -> Ray {
    let direction = sample::direction(rng);
    let leaves = rng.random_range(0..3);
    let enters = (leaves + rng.random_range(1..3)) % 3;
    let mut place = sample::point(rng, 0.9);
    let out = 1.0 - sample::beside(rng);
    place[leaves] = out * direction[leaves].signum();
    place[enters] = -out * direction[enters].signum();
    let aim = center + place * half;
    Ray::new(aim - sample::number(rng, 1.0, 6.0) * *direction, direction)
}

/// A ray that does not move along one axis or two. Along each of these it is between the box's planes, or up to 1 m outside of them.
fn parallel_to_faces(rng: &mut Pcg, center: Vec3, half: Vec3) -> Ray {
    let mut origin = center + sample::point(rng, 5.0);
    let aim = center + sample::point(rng, 0.9) * half;
    let mut toward = aim - origin;
    let first = rng.random_range(0..3);
    for axis in (first..first + rng.random_range(1..3)).map(|axis| axis % 3) {
        origin[axis] = if rng.random_bool(0.4) {
            let beyond = sample::number(rng, -1.0, 1.0);
            center[axis] + half[axis].copysign(beyond) + beyond
        } else {
            aim[axis]
        };
        // Of either sign.
        toward[axis] *= 0.0;
    }
    sample::ray(origin, toward)
}

//! `mesh_hit`: random questions, judge and mistakes.

use super::place;
use crate::{Graded, Mistake, Picture, Relation, Verdict, judge, sample};
use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::image::rgb::Rgb;
use raybook::math::{interval::Interval, pcg::Pcg, ray::Ray};
use raybook_chapters::kit::palette::viridis;
use raybook_workbook::exercises::ch07_mesh::{Corners, MeshHit, MeshHitAnswer};

impl Graded for MeshHit {
    fn random(rng: &mut Pcg) -> MeshHit {
        let count = rng.random_range(2..7);
        let corners = |rng: &mut Pcg| std::array::from_fn(|_| sample::point(rng, 2.5));
        let mut triangles = (0..count)
            .map(|_| {
                let [p0, p1, p2] = corners(rng);
                Corners { p0, p1, p2 }
            })
            .collect::<Vec<_>>();
        let origin = sample::point(rng, 3.0);
        let ray = sample::ray(origin, sample::point(rng, 1.0) - origin);
        // In one question in two the ray passes through all triangles, so that their order counts.
        if rng.random_bool(0.5) {
            for Corners { p0, p1, p2 } in &mut triangles {
                let b = place(rng);
                let from = *p0 + b.x * (*p1 - *p0) + b.y * (*p2 - *p0);
                let by = ray.at(sample::number(rng, 2.0, 4.0)) - from;
                for p in [p0, p1, p2] {
                    *p += by;
                }
            }
        }
        // One interval in two begins ahead of the ray's origin or behind it, and all triangles may be behind it, too.
        let (ray, min) = if rng.random_bool(0.5) {
            let origin = ray.at(sample::number(rng, 0.0, 6.0));
            let min = sample::number(rng, -5.0, 2.0);
            (Ray::new(origin, ray.direction), min)
        } else {
            (ray, 0.0)
        };
        let max = min + sample::end(rng, 0.3, 1.0, 4.0);
        MeshHit {
            ray,
            within: Interval::new(min, max),
            triangles,
        }
    }

    fn is_sound(q: &MeshHit) -> bool {
        let mut triangles = q.triangles.iter();
        triangles.all(|t| sample::is_triangle([t.p0, t.p1, t.p2]))
    }

    fn judge(_q: &MeshHit, golden: &Option<MeshHitAnswer>, got: &Option<MeshHitAnswer>) -> Verdict {
        judge::nearest(golden.as_ref(), got.as_ref())
    }

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| MeshHit {
        ray: sample::moved(&q.ray),
        triangles: q.triangles.iter().map(sample::moved_triangle).collect(),
        ..q.clone()
    })];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "returns the first hit in the list",
            hint: "Put the far triangle first: which one do you see?",
            answer: |q| hits(q).next(),
        },
        Mistake {
            name: "ends at the first triangle that is missed",
            hint: "Put a triangle that the ray misses in front of one that it hits: what becomes of your loop?",
            answer: |q| {
                let until = hits(q).zip(0..).take_while(|(hit, i)| hit.id == *i);
                let hits = until.map(|(hit, _)| hit);
                hits.min_by(|a, b| a.t.total_cmp(&b.t))
            },
        },
        Mistake {
            name: "returns the last hit in the list",
            hint: "Put the near triangle first: is it still the one you return?",
            answer: |q| hits(q).last(),
        },
        Mistake {
            name: "returns the least distance with the number of the first triangle that is hit",
            hint: "When a nearer triangle is hit, which two things change?",
            answer: |q| {
                let nearest = MeshHit::right(q)?;
                hits(q).next().map(|first| MeshHitAnswer {
                    t: nearest.t,
                    ..first
                })
            },
        },
        Mistake {
            name: "returns the least distance with the number of the last triangle that is hit",
            hint: "When a nearer triangle is hit, which two things change? And when a farther one is?",
            answer: |q| {
                let nearest = MeshHit::right(q)?;
                hits(q).last().map(|last| MeshHitAnswer {
                    t: nearest.t,
                    ..last
                })
            },
        },
        Mistake {
            name: "returns the farthest hit",
            hint: "Which of two opaque triangles hides the other?",
            answer: |q| hits(q).max_by(|a, b| a.t.total_cmp(&b.t)),
        },
        Mistake {
            name: "ignores the interval's max",
            hint: "Something nearer may already have been hit: what is the interval's max for?",
            answer: |q| Self::misread(q, |q| q.within.max = f32::INFINITY),
        },
        Mistake {
            name: "ignores the interval's min",
            hint: "Can the ray hit what lies behind its origin?",
            answer: |q| Self::misread(q, |q| q.within.min = f32::NEG_INFINITY),
        },
        Mistake {
            name: "begins the interval at 0 again once something is hit",
            hint: "A hit ends the interval at its distance: what becomes of the interval's beginning?",
            answer: |q| {
                let all = Self {
                    within: Interval::new(q.within.min.min(0.0), q.within.max),
                    ..q.clone()
                };
                let (mut within, mut nearest) = (q.within, None);
                for hit in hits(&all) {
                    if within.contains(hit.t) {
                        within = Interval::new(0.0, hit.t);
                        nearest = Some(hit);
                    }
                }
                nearest
            },
        },
        Mistake {
            name: "forgets the last triangle",
            hint: "Try a list of a single triangle.",
            answer: |q| {
                let rest = q.triangles.len().saturating_sub(1);
                Self::misread(q, |q| q.triangles.truncate(rest))
            },
        },
        Mistake {
            name: "counts ids from 1",
            hint: "What is the number of the first triangle?",
            answer: |q| {
                MeshHit::right(q).map(|hit| MeshHitAnswer {
                    id: hit.id + 1,
                    ..hit
                })
            },
        },
        Mistake {
            name: "returns the number of the last triangle tested",
            hint: "When a nearer hit is found, what do you keep beside its distance?",
            answer: |q| {
                let last = (q.triangles.len() as u32).saturating_sub(1);
                MeshHit::right(q).map(|hit| MeshHitAnswer { id: last, ..hit })
            },
        },
        Mistake {
            name: "numbers the triangles that are hit, and not all of them",
            hint: "Which triangle has the number 1: the second of the list, or the second that is hit?",
            answer: |q| {
                let hits = hits(q).zip(0..);
                hits.map(|(hit, id)| MeshHitAnswer { id, ..hit })
                    .min_by(|a, b| a.t.total_cmp(&b.t))
            },
        },
        Mistake {
            name: "forgets the first triangle, or takes its number 0 for none",
            hint: "Where does your loop begin, and what does a condition make of the number 0? Try a list of a single triangle.",
            answer: |q| {
                hits(q)
                    .filter(|hit| hit.id > 0)
                    .min_by(|a, b| a.t.total_cmp(&b.t))
            },
        },
        Mistake {
            name: "keeps the nearest hit ahead of the origin, and asks only then whether it is behind the interval's min",
            hint: "A triangle lies before the interval, and another one in it: which of the two do you keep?",
            answer: |q| counted_last(q, 0.0, |hit| hit.t),
        },
        Mistake {
            name: "keeps the first hit of the whole line, and asks only then whether it is behind the interval's min",
            hint: "A triangle lies behind the origin, and another one ahead: which of the two do you keep?",
            answer: |q| counted_last(q, f32::NEG_INFINITY, |hit| hit.t),
        },
        Mistake {
            name: "keeps the hit with the least |t|, and asks only then whether it counts",
            hint: "A triangle close behind the origin, and one farther ahead: which of the two is in the interval?",
            answer: |q| counted_last(q, f32::NEG_INFINITY, |hit| hit.t.abs()),
        },
        Mistake {
            name: "keeps that of the hits in the interval whose |t| is the least",
            hint: "The interval may begin behind the origin: which comes first along the ray, −4 or −2?",
            answer: |q| hits(q).min_by(|a, b| a.t.abs().total_cmp(&b.t.abs())),
        },
        Mistake {
            name: "sees the front of each triangle only",
            hint: "Walk around a triangle: it has two sides.",
            answer: |q| facing(q, -1.0),
        },
        Mistake {
            name: "takes the triangles in the order of their first corners' distances, and returns the first that is hit",
            hint: "A large triangle may have its first corner far away: how near may its nearest point be?",
            answer: |q| first_by(q, |corners| corners.p0),
        },
        Mistake {
            name: "compares each hit with the one before, not with the nearest so far",
            hint: "Three hits, at 2, 5 and 3 metres: which one do you return?",
            answer: |q| {
                let mut nearest: Option<MeshHitAnswer> = None;
                let mut before = f32::INFINITY;
                for hit in hits(q) {
                    let t = hit.t;
                    if t < before {
                        nearest = Some(hit);
                    }
                    before = t;
                }
                nearest
            },
        },
        Mistake {
            name: "ends at the first hit that is farther than the one before",
            hint: "Three hits, at 3, 5 and 2 metres: when does your loop end?",
            answer: |q| {
                let mut least = f32::INFINITY;
                let nearer = |hit: &MeshHitAnswer| {
                    let is_nearer = hit.t <= least;
                    least = hit.t;
                    is_nearer
                };
                hits(q).take_while(nearer).last()
            },
        },
        Mistake {
            name: "wants a hit to be nearer by more than a millimetre than the nearest so far",
            hint: "Of two triangles half a millimetre apart, which one is seen?",
            answer: |q| {
                hits(q).reduce(|nearest, hit| {
                    if hit.t < nearest.t - 1e-3 {
                        hit
                    } else {
                        nearest
                    }
                })
            },
        },
        Mistake {
            name: "returns the number of the nearest triangle with the distance of the last that is hit",
            hint: "When a triangle is hit that is not nearer, what must not change?",
            answer: |q| {
                let last = hits(q).last()?;
                MeshHit::right(q).map(|nearest| MeshHitAnswer {
                    t: last.t,
                    ..nearest
                })
            },
        },
        Mistake {
            name: "hits the whole plane of each triangle",
            hint: "The plane is found; is the point inside the triangle?",
            answer: |q| {
                let planes = q
                    .triangles
                    .iter()
                    .zip(0..)
                    .map(|(Corners { p0, p1, p2 }, id)| {
                        let n = (*p1 - *p0).cross(*p2 - *p0);
                        let t = n.dot(*p0 - q.ray.origin) / n.dot(*q.ray.direction);
                        MeshHitAnswer { t, id }
                    });
                let hits = planes.filter(|hit| q.within.contains(hit.t));
                hits.min_by(|a, b| a.t.total_cmp(&b.t))
            },
        },
        Mistake {
            name: "takes the triangles in the order of their middles' distances, and returns the first that is hit",
            hint: "A large triangle may have its middle far away: how near may its nearest point be?",
            answer: |q| first_by(q, |Corners { p0, p1, p2 }| (*p0 + *p1 + *p2) / 3.0),
        },
        Mistake {
            name: "sees the back of each triangle only",
            hint: "What is the sign of your determinant for the side that you look at?",
            answer: |q| facing(q, 1.0),
        },
        Mistake {
            name: "returns the number of the nearest triangle with the distance of the first that is hit",
            hint: "When a nearer triangle is hit, which two things change?",
            answer: |q| {
                let first = hits(q).next()?;
                MeshHit::right(q).map(|nearest| MeshHitAnswer {
                    t: first.t,
                    ..nearest
                })
            },
        },
        Mistake {
            name: "skips every triangle whose first corner is behind the origin",
            hint: "A large triangle may begin behind the origin: where does the ray meet it?",
            answer: |q| {
                let is_ahead = |hit: &MeshHitAnswer| {
                    let way = q.triangles[hit.id as usize].p0 - q.ray.origin;
                    way.dot(*q.ray.direction) >= 0.0
                };
                let ahead = hits(q).filter(is_ahead);
                ahead.min_by(|a, b| a.t.total_cmp(&b.t))
            },
        },
        Mistake {
            name: "takes triangle 0 for no hit at all: the next hit replaces it, however far it is",
            hint: "The first triangle is the nearest: which value of yours says that nothing is hit yet, and can a number have it?",
            answer: |q| {
                let nearer = |best: MeshHitAnswer, hit: MeshHitAnswer| {
                    if best.id == 0 || hit.t < best.t {
                        hit
                    } else {
                        best
                    }
                };
                hits(q).reduce(nearer)
            },
        },
        Mistake {
            name: "takes 0 for within.min, wherever the interval begins",
            hint: "The interval says where hits begin to count: is that always at the ray's origin?",
            answer: |q| Self::misread(q, |q| q.within.min = 0.0),
        },
        Mistake {
            name: "takes 0 for within.min where the interval begins behind the origin",
            hint: "An interval may begin behind the origin: is what lies there in it?",
            answer: |q| Self::misread(q, |q| q.within.min = q.within.min.max(0.0)),
        },
    ];

    const PICTURES: &'static [Picture<Self>] = &[Picture {
        name: "mesh_hit",
        width: 96,
        height: 54,
        alt: "Three triangles, one before the other, each in its colour",
        question: |x, y| {
            let toward = sample::pixel(x, y);
            let shifted = |by: Vec3| {
                let [p0, p1, p2] = [
                    vec3(-0.8, -0.7, 0.0),
                    vec3(0.8, -0.7, 0.0),
                    vec3(0.0, 0.8, 0.0),
                ]
                .map(|p| p + by);
                Corners { p0, p1, p2 }
            };
            MeshHit {
                ray: sample::ray(vec3(0.0, 0.0, 3.0), toward),
                within: Interval::AHEAD,
                triangles: [
                    vec3(0.5, 0.2, -0.4),
                    vec3(0.0, 0.0, 0.0),
                    vec3(-0.5, 0.1, -0.2),
                ]
                .map(shifted)
                .into(),
            }
        },
        colour: |_, hit| {
            hit.as_ref()
                .map_or(Rgb::gray(0.1), |hit| viridis(0.2 + 0.35 * hit.id as f32))
        },
    }];
}

/// The hit of each triangle that is hit, in the order of the list.
fn hits(q: &MeshHit) -> impl Iterator<Item = MeshHitAnswer> {
    q.triangles.iter().zip(0..).filter_map(|(triangle, id)| {
        let alone = MeshHit {
            triangles: vec![triangle.clone()],
            ..q.clone()
        };
        MeshHit::right(&alone).map(|hit| MeshHitAnswer { id, ..hit })
    })
}

/// The nearest of the hits on one side of the triangles: the front, of −1, or the back, of 1.
fn facing(q: &MeshHit, side: f32) -> Option<MeshHitAnswer> {
    let is_seen = |hit: &MeshHitAnswer| {
        let Corners { p0, p1, p2 } = q.triangles[hit.id as usize];
        side * (p1 - p0).cross(p2 - p0).dot(*q.ray.direction) > 0.0
    };
    let seen = hits(q).filter(is_seen);
    seen.min_by(|a, b| a.t.total_cmp(&b.t))
}

/// The first hit, if the triangles are taken in the order of the distances of a point of each.
fn first_by(q: &MeshHit, point: fn(&Corners) -> Vec3) -> Option<MeshHitAnswer> {
    let far = |hit: &MeshHitAnswer| point(&q.triangles[hit.id as usize]).distance(q.ray.origin);
    hits(q).min_by(|a, b| far(a).total_cmp(&far(b)))
}

/// The least of the hits from `min` on by an order, if it is in the interval.
fn counted_last(
    q: &MeshHit,
    min: f32,
    order: impl Fn(&MeshHitAnswer) -> f32,
) -> Option<MeshHitAnswer> {
    let all = MeshHit {
        within: Interval::new(min, q.within.max),
        ..q.clone()
    };
    let least = hits(&all).min_by(|a, b| order(a).total_cmp(&order(b)));
    least.filter(|hit| q.within.contains(hit.t))
}

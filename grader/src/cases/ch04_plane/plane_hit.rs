//! Chapter 4: `plane_hit`.

use crate::{Graded, Mistake, Picture, Relation, Verdict, judge, sample};
use glam::vec3;
use rand::RngExt;
use raybook::image::rgb::Rgb;
use raybook::math::{dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use raybook_chapters::kit::palette::viridis;
use raybook_workbook::exercises::ch04_plane::PlaneHit;

impl Graded for PlaneHit {
    fn random(rng: &mut Pcg) -> PlaneHit {
        // One interval in two begins ahead of the ray's origin or behind it.
        let min = if rng.random_bool(0.5) {
            sample::number(rng, -6.0, 2.0)
        } else {
            0.0
        };
        let max = min + sample::end(rng, 0.4, 1.0, 8.0);
        PlaneHit {
            ray: Ray::new(sample::point(rng, 4.0), sample::direction(rng)),
            within: Interval::new(min, max),
            normal: sample::direction(rng),
            offset: sample::number(rng, -3.0, 3.0),
        }
    }

    fn judge(_q: &PlaneHit, golden: &Option<f32>, got: &Option<f32>) -> Verdict {
        judge::option("a hit", golden.as_ref(), got.as_ref(), |golden, got| {
            judge::number("t", "m", *golden, *got)
        })
    }

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| PlaneHit {
        ray: sample::moved(&q.ray),
        offset: q.offset + q.normal.dot(sample::METRE),
        ..q.clone()
    })];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "has the sign of the offset wrong",
            hint: "A point p of the plane has n·p = offset: put o + t·d in for p and solve again.",
            answer: |q| Self::misread(q, |q| q.offset = -q.offset),
        },
        Mistake {
            name: "takes the plane to go through the world's origin",
            hint: "Move the plane by one metre along its normal: does your t change?",
            answer: |q| Self::misread(q, |q| q.offset = 0.0),
        },
        Mistake {
            name: "takes (0, offset, 0) for a point of the plane",
            hint: "Which point of the plane is nearest to the world's origin, and how far along n is it? Is it above the origin, whatever n is?",
            answer: |q| Self::misread(q, |q| q.offset *= q.normal.y),
        },
        Mistake {
            name: "sees the front only",
            hint: "Look at the plane from below: is it still there?",
            answer: |q| PlaneHit::right(q).filter(|_| q.normal.dot(*q.ray.direction) < 0.0),
        },
        Mistake {
            name: "ignores the interval",
            hint: "Is every t you return between min and max?",
            answer: |q| line(q).filter(|t| t.is_finite()),
        },
        Mistake {
            name: "only asks for t > min",
            hint: "Something nearer may already have been hit: what is the interval's max for?",
            answer: |q| line(q).filter(|t| t.is_finite() && *t > q.within.min),
        },
        Mistake {
            name: "turns the sign of t round after the interval has been checked",
            hint: "What is the sign of (offset − n·o)/(n·d) for a plane that lies ahead?",
            answer: |q| PlaneHit::right(q).map(|t| -t),
        },
        Mistake {
            name: "returns the distance along the normal",
            hint: "Does a slanted ray go as far to the plane as a ray along the normal?",
            answer: |q| PlaneHit::right(q).map(|t| (t * q.normal.dot(*q.ray.direction)).abs()),
        },
        Mistake {
            name: "calls a nearly parallel ray a miss",
            hint: "How close to 0 is too close? A plane reaches to the horizon.",
            answer: |q| PlaneHit::right(q).filter(|_| q.normal.dot(*q.ray.direction).abs() > 0.02),
        },
        Mistake {
            name: "forgets to divide by n·d",
            hint: "Turn the ray while the plane stays: must t change?",
            answer: |q| {
                let t = q.offset - q.normal.dot(q.ray.origin);
                (q.normal.dot(*q.ray.direction) != 0.0 && q.within.contains(t)).then_some(t)
            },
        },
        Mistake {
            name: "has the sign of t wrong, and hits planes that are behind the origin",
            hint: "Put the origin one metre in front of a wall and look at the wall: what is the sign of your t?",
            answer: |q| Self::misread(q, |q| q.ray.direction = -q.ray.direction),
        },
        Mistake {
            name: "takes |t| for t",
            hint: "Where is the point of a negative t: ahead of the origin, or behind it?",
            answer: |q| {
                Self::misread(q, |q| q.within = sample::LINE)
                    .map(f32::abs)
                    .filter(|t| q.within.contains(*t))
            },
        },
        Mistake {
            name: "returns the distance of the hit from the world's origin",
            hint: "From where is t measured: from the ray's origin, or from the world's?",
            answer: |q| PlaneHit::right(q).map(|t| q.ray.at(t).length()),
        },
        Mistake {
            name: "sees the back only",
            hint: "What is the sign of n·d for a ray that comes from the side to which the normal points?",
            answer: |q| PlaneHit::right(q).filter(|_| q.normal.dot(*q.ray.direction) > 0.0),
        },
        Mistake {
            name: "takes (offset, offset, offset) for a point of the plane",
            hint: "Which point of the plane is nearest to the world's origin, and in which direction does it lie?",
            answer: |q| Self::misread(q, |q| q.offset *= q.normal.element_sum()),
        },
        Mistake {
            name: "counts a ray that runs in the plane as a hit at 0",
            hint: "A ray in the plane meets all of its points, or none: does the task give such a ray a distance?",
            answer: |q| {
                let runs_in_it =
                    q.normal.dot(*q.ray.direction) == 0.0 && q.normal.dot(q.ray.origin) == q.offset;
                if runs_in_it {
                    Some(0.0)
                } else {
                    PlaneHit::right(q)
                }
            },
        },
        Mistake {
            name: "divides n·d by the height, and not the height by n·d",
            hint: "Check the units: metres over what give metres?",
            answer: |q| line(q).map(f32::recip).filter(|t| q.within.contains(*t)),
        },
        Mistake {
            name: "divides by the sine of the angle between ray and normal, not by its cosine",
            hint: "A ray along the normal goes the shortest way: what is the angle between the two, and what is its sine?",
            answer: |q| {
                let cosine = q.normal.dot(*q.ray.direction);
                let sine = (1.0 - cosine * cosine).max(0.0).sqrt().copysign(cosine);
                let t = (q.offset - q.normal.dot(q.ray.origin)) / sine;
                (cosine != 0.0 && sine != 0.0 && q.within.contains(t)).then_some(t)
            },
        },
        Mistake {
            name: "takes the absolute value of n·d",
            hint: "Look at the plane from both of its sides: what are the signs of the height and of n·d, and what is the sign of t?",
            answer: |q| {
                let height = q.offset - q.normal.dot(q.ray.origin);
                let t = height / q.normal.dot(*q.ray.direction).abs();
                q.within.contains(t).then_some(t)
            },
        },
        Mistake {
            name: "takes the absolute value of the origin's height above the plane",
            hint: "The origin may be on either side of the plane: what is the sign of its height on each, and what is the sign of t?",
            answer: |q| {
                let height = (q.offset - q.normal.dot(q.ray.origin)).abs();
                let t = height / q.normal.dot(*q.ray.direction);
                q.within.contains(t).then_some(t)
            },
        },
        Mistake {
            name: "only asks for t < max",
            hint: "What lies behind the origin is in front of max: what is the interval's min for?",
            answer: |q| line(q).filter(|t| *t < q.within.max),
        },
        Mistake {
            name: "skips the first millimetre of the interval",
            hint: "You may have learnt to ignore small t against self-intersection; the interval you are given already says where hits begin to count.",
            answer: |q| Self::misread(q, |q| q.within.min += 1e-3),
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
        Mistake {
            name: "divides the origin's height above the plane by the absolute value of n·d",
            hint: "Look at the plane from below: what are the signs of the height and of n·d, and what is the sign of t?",
            answer: |q| {
                let height = q.normal.dot(q.ray.origin) - q.offset;
                let t = height / q.normal.dot(*q.ray.direction).abs();
                q.within.contains(t).then_some(t)
            },
        },
        Mistake {
            name: "divides the absolute value of the origin's height above the plane by −n·d",
            hint: "Look at the plane from below: what are the signs of the height and of n·d, and what is the sign of t?",
            answer: |q| {
                let height = (q.normal.dot(q.ray.origin) - q.offset).abs();
                let t = -height / q.normal.dot(*q.ray.direction);
                q.within.contains(t).then_some(t)
            },
        },
        Mistake {
            name: "compares the origin's distance from the plane, along the normal, with the interval, and not t",
            hint: "A slanted ray goes further than along the normal: which of the two lengths do min and max belong to?",
            answer: |q| by_height(q, f32::abs),
        },
        Mistake {
            name: "compares the origin's distance from the plane, along the normal, with the interval, and t with 0 only",
            hint: "A slanted ray goes further than along the normal: which of the two lengths do min and max belong to?",
            answer: |q| by_height(q, f32::abs).filter(|t| *t > 0.0),
        },
        Mistake {
            name: "compares the origin's height above the plane with the interval, and not t",
            hint: "A slanted ray goes further than along the normal: which of the two lengths do min and max belong to?",
            answer: |q| by_height(q, |height| height),
        },
        Mistake {
            name: "compares the origin's height above the plane with the interval, and t with 0 only",
            hint: "A slanted ray goes further than along the normal: which of the two lengths do min and max belong to?",
            answer: |q| by_height(q, |height| height).filter(|t| *t > 0.0),
        },
        Mistake {
            name: "takes the way along the ray to the point offset · n for the distance",
            hint: "The point of the plane that is nearest to the world's origin: is it also the one that the ray meets?",
            answer: |q| {
                let t = (q.offset * *q.normal - q.ray.origin).dot(*q.ray.direction);
                (q.normal.dot(*q.ray.direction) != 0.0 && q.within.contains(t)).then_some(t)
            },
        },
        Mistake {
            name: "turns the normal against the ray, and forgets to turn the offset's sign with it",
            hint: "n·x = offset and (−n)·x = offset: are these the same plane?",
            answer: |q| {
                let is_behind = q.normal.dot(*q.ray.direction) > 0.0;
                Self::misread(q, |q| {
                    if is_behind {
                        q.normal = -q.normal;
                    }
                })
            },
        },
    ];

    const PICTURES: &'static [Picture<Self>] = &[Picture {
        name: "plane_hit",
        width: 96,
        height: 54,
        alt: "A floor and a wall of sky; the brighter, the nearer",
        question: |x, y| {
            let toward = vec3((x as f32 - 47.5) / 54.0, (16.5 - y as f32) / 54.0, -1.0);
            let ray = Ray::new(vec3(0.0, 1.0, 0.0), Dir3::new_or(toward, Dir3::Z));
            PlaneHit {
                ray,
                within: Interval::new(0.0, 60.0),
                normal: Dir3::Y,
                offset: -0.5,
            }
        },
        colour: |_, t| t.map_or(Rgb::gray(0.1), |t| viridis(2.0 / (0.5 + t))),
    }];
}

/// The distance at which the whole line meets the plane.
fn line(q: &PlaneHit) -> Option<f32> {
    PlaneHit::right(&PlaneHit {
        within: Interval::new(f32::NEG_INFINITY, f32::INFINITY),
        ..q.clone()
    })
}

/// The distance at which the whole line meets the plane, if the interval contains what is made of the origin's height above the plane.
fn by_height(q: &PlaneHit, made: fn(f32) -> f32) -> Option<f32> {
    let height = q.normal.dot(q.ray.origin) - q.offset;
    line(q).filter(|t| t.is_finite() && q.within.contains(made(height)))
}

//! `ray_at`: random questions, judge and mistakes.

use crate::{Graded, Mistake, Relation, Verdict, judge, sample};
use glam::Vec3;
use raybook::math::{pcg::Pcg, ray::Ray};
use raybook_workbook::exercises::ch01_rays::RayAt;

impl Graded for RayAt {
    fn random(rng: &mut Pcg) -> RayAt {
        RayAt {
            ray: Ray::new(sample::point(rng, 5.0), sample::direction(rng)),
            t: sample::number(rng, -5.0, 20.0),
        }
    }

    fn judge(_q: &RayAt, golden: &Vec3, got: &Vec3) -> Verdict {
        judge::point("the point", *golden, *got)
    }

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| RayAt {
        ray: sample::moved(&q.ray),
        ..q.clone()
    })];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "forgets the origin",
            hint: "At t = 0, where is the ray?",
            answer: |q| q.t * *q.ray.direction,
        },
        Mistake {
            name: "ignores t",
            hint: "How far from the origin is your point? How far should it be?",
            answer: |q| q.ray.origin + *q.ray.direction,
        },
        Mistake {
            name: "goes backwards",
            hint: "Does the point of a positive t lie ahead of the origin, or behind the origin?",
            answer: |q| q.ray.origin - q.t * *q.ray.direction,
        },
        Mistake {
            name: "scales the origin too",
            hint: "Only one of the two vectors grows with t.",
            answer: |q| q.t * (q.ray.origin + *q.ray.direction),
        },
        Mistake {
            name: "scales the origin instead of the direction",
            hint: "Which of the two vectors says where the ray starts?",
            answer: |q| q.t * q.ray.origin + *q.ray.direction,
        },
        Mistake {
            name: "takes 0 for a negative t",
            hint: "The line goes on behind the ray's origin: which point belongs to t = −2?",
            answer: |q| q.ray.at(q.t.max(0.0)),
        },
        Mistake {
            name: "takes the direction for a second point, and goes from the origin to it",
            hint: "A direction already says from where to where: is there anything to subtract from it?",
            answer: |q| q.ray.origin + q.t * (*q.ray.direction - q.ray.origin),
        },
        Mistake {
            name: "goes t metres towards the direction, which it takes for a second point",
            hint: "A direction already says from where to where: is there anything to subtract from it?",
            answer: |q| {
                let way = *q.ray.direction - q.ray.origin;
                q.ray.origin + q.t * way.normalize_or_zero()
            },
        },
        Mistake {
            name: "normalises the sum of origin and direction, and multiplies that by t",
            hint: "From which point is t measured: from the ray's origin, or from the world's?",
            answer: |q| q.t * (q.ray.origin + *q.ray.direction).normalize_or_zero(),
        },
    ];
}

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
        Mistake {
            name: "takes |t| for t",
            hint: "The line goes on behind the ray's origin: which point belongs to t = −2?",
            answer: |q| q.ray.at(q.t.abs()),
        },
        Mistake {
            name: "subtracts the origin instead of adding it",
            hint: "At t = 0, where is the ray, and where is your point?",
            answer: |q| q.t * *q.ray.direction - q.ray.origin,
        },
        Mistake {
            name: "adds t to each coordinate of the origin, whatever the direction is",
            hint: "A ray along x: which coordinates of its points change?",
            answer: |q| q.ray.origin + q.t,
        },
        Mistake {
            name: "adds t to each component of the direction, instead of multiplying by it",
            hint: "A ray along x: which coordinates of its points change?",
            answer: |q| q.ray.origin + *q.ray.direction + q.t,
        },
        Mistake {
            name: "goes along the origin's own vector, not along the direction",
            hint: "Which of the two vectors says where the ray goes?",
            answer: |q| q.ray.origin + q.t * q.ray.origin,
        },
        Mistake {
            name: "begins at the direction, not at the origin",
            hint: "Which of the two vectors says where the ray starts?",
            answer: |q| *q.ray.direction + q.t * *q.ray.direction,
        },
        Mistake {
            name: "cuts off what t has behind the decimal point",
            hint: "Which point belongs to t = 2.5: is it another one than that of t = 2?",
            answer: |q| q.ray.at(q.t.trunc()),
        },
        Mistake {
            name: "takes t for a share from 0 to 1, and clamps it",
            hint: "In which unit is t, and how far may the ray go?",
            answer: |q| q.ray.at(q.t.clamp(0.0, 1.0)),
        },
        Mistake {
            name: "divides the direction by t",
            hint: "Make t twice as large: do you go farther, or less far?",
            answer: |q| q.ray.origin + *q.ray.direction / q.t,
        },
        Mistake {
            name: "normalises the point",
            hint: "How long is a direction, and how far from the world's origin may a point be?",
            answer: |q| q.right().normalize_or_zero(),
        },
        Mistake {
            name: "measures t from the world's origin: subtracts the length of the origin's vector from it",
            hint: "At t = 0, where is the ray, and where is your point?",
            answer: |q| q.ray.at(q.t - q.ray.origin.length()),
        },
        Mistake {
            name: "moves along y by the direction's x",
            hint: "Which component of the direction belongs to each coordinate? Was a line copied?",
            answer: |q| moved_by(q, [0, 0, 2]),
        },
        Mistake {
            name: "moves along z by the direction's x",
            hint: "Which component of the direction belongs to each coordinate? Was a line copied?",
            answer: |q| moved_by(q, [0, 1, 0]),
        },
        Mistake {
            name: "moves along z by the direction's y",
            hint: "Which component of the direction belongs to each coordinate? Was a line copied?",
            answer: |q| moved_by(q, [0, 1, 1]),
        },
        Mistake {
            name: "does not move along z",
            hint: "A ray along z: does its point move?",
            answer: |q| q.right().with_z(q.ray.origin.z),
        },
        Mistake {
            name: "moves the wrong way along z",
            hint: "The direction has a sign along each axis already: is there another one to put before it?",
            answer: |q| {
                let z = q.ray.origin.z - q.t * q.ray.direction.z;
                q.right().with_z(z)
            },
        },
    ];
}

/// The point where each coordinate grows by one of the components of the direction.
fn moved_by(q: &RayAt, components: [usize; 3]) -> Vec3 {
    let by = components.map(|component| q.ray.direction[component]);
    q.ray.origin + q.t * Vec3::from_array(by)
}

//! `sphere_normal`: random questions, judge and mistakes.

use crate::{Graded, Mistake, Verdict, judge, sample};
use glam::Vec3;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch03_sphere::SphereNormal;

impl Graded for SphereNormal {
    fn random(rng: &mut Pcg) -> SphereNormal {
        let (center, radius) = (sample::point(rng, 5.0), sample::number(rng, 0.3, 3.0));
        SphereNormal {
            center,
            radius,
            p: center + radius * *sample::direction(rng),
        }
    }

    fn is_sound(q: &SphereNormal) -> bool {
        (q.p.distance(q.center) - q.radius).abs() < 1e-4 * q.radius
    }

    fn judge(_q: &SphereNormal, golden: &Vec3, got: &Vec3) -> Verdict {
        judge::direction("the normal", *golden, *got)
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "points inwards",
            hint: "From the centre to the point, or from the point to the centre?",
            answer: |q| -SphereNormal::right(q),
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
        Mistake {
            name: "divides the centre only by the radius, as p − c/r",
            hint: "What does your language calculate first in p − c/r?",
            answer: |q| q.p - q.center / q.radius,
        },
        Mistake {
            name: "divides by the point's distance from the world's origin, not from the centre",
            hint: "How long is p − c, and how long is p? By which length must p − c be divided to get the length 1?",
            answer: |q| (q.p - q.center) / q.p.length(),
        },
        Mistake {
            name: "turns the normal away from the world's origin",
            hint: "Move the sphere, and not the world's origin: from which point does a sphere's normal point away?",
            answer: |q| {
                let n = Self::right(q);
                if n.dot(q.p) < 0.0 { -n } else { n }
            },
        },
        Mistake {
            name: "divides the point only by the radius, as p/r − c",
            hint: "What does your language calculate first in p/r − c?",
            answer: |q| q.p / q.radius - q.center,
        },
        Mistake {
            name: "normalises the point and the centre, and then subtracts them",
            hint: "Which vector must have the length 1: the point, the centre, or the way between them?",
            answer: |q| q.p.normalize_or_zero() - q.center.normalize_or_zero(),
        },
        Mistake {
            name: "turns the normal towards the world's origin",
            hint: "Move the sphere, and not the world's origin: does the side change that is outside?",
            answer: |q| {
                let n = Self::right(q);
                if n.dot(q.p) > 0.0 { -n } else { n }
            },
        },
        Mistake {
            name: "turns every normal up",
            hint: "Where does the normal point at the bottom of a ball?",
            answer: |q| {
                let n = Self::right(q);
                if n.y < 0.0 { -n } else { n }
            },
        },
    ];
}

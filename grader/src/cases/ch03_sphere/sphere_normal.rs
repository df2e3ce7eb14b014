//! `sphere_normal`: its cases, judge and mistakes.

use crate::{Edge, Graded, Mistake, Verdict, judge, sample};
use raybook::math::pcg::Pcg;
use raybook_workbook::exercise::Exercise;
use raybook_workbook::exercises::ch03_sphere::{SphereNormal, SphereNormalQuestion};
use glam::{Vec3, vec3};

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

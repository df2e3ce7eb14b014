//! `triangle_normal`: its cases, judge and mistakes.

use crate::{Edge, Graded, Mistake, Verdict, judge, sample};
use raybook::math::{dir3::Dir3, pcg::Pcg};
use raybook_workbook::exercise::Exercise;
use raybook_workbook::exercises::ch06_triangle::{TriangleNormal, TriangleQuestion};
use glam::{Vec3, vec3};

impl Graded for TriangleNormal {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "points to the other side",
            hint: "Curl the fingers of your right hand from p0 over p1 to p2: where does the thumb point?",
            answer: |q| TriangleNormal::answer(q).map(|n| -n),
        },
        Mistake {
            name: "forgets to normalise",
            hint: "The cross product's length is twice the triangle's area.",
            answer: |q| TriangleNormal::answer(q).map(|_| (q.p1 - q.p0).cross(q.p2 - q.p0)),
        },
        Mistake {
            name: "crosses the corners instead of the edges",
            hint: "Move the triangle by one metre: the normal must not change.",
            answer: |q| Dir3::new(q.p1.cross(q.p2)).map(|n| *n),
        },
        Mistake {
            name: "returns NaN for a triangle without area",
            hint: "Three corners on a line: how long is the cross product, and what happens when you divide by that?",
            answer: |q| Some((q.p1 - q.p0).cross(q.p2 - q.p0).normalize()),
        },
        Mistake {
            name: "always points up",
            hint: "It is the order of the corners that decides which side is outside, not the world.",
            answer: |q| TriangleNormal::answer(q).map(|n| if n.y < 0.0 { -n } else { n }),
        },
        Mistake {
            name: "returns the direction of an edge",
            hint: "What is the normal's dot product with each edge?",
            answer: |q| TriangleNormal::answer(q).map(|_| (q.p1 - q.p0).normalize()),
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, p0, p1, p2| Edge::new(name, TriangleQuestion { p0, p1, p2 });
        let (x, y, z) = (Vec3::X, Vec3::Y, Vec3::Z);
        vec![
            edge("counter-clockwise seen from +z", Vec3::ZERO, x, y),
            edge("clockwise seen from +z", Vec3::ZERO, y, x),
            edge("lying on the floor, face down", Vec3::ZERO, x, z),
            edge(
                "away from the origin",
                vec3(5.0, 5.0, 5.0),
                vec3(6.0, 5.0, 5.0),
                vec3(5.0, 6.0, 5.0),
            ),
            edge("a small one", Vec3::ZERO, 0.001 * x, 0.001 * z),
            edge("a large one", Vec3::ZERO, 1000.0 * y, 1000.0 * z),
            edge("three corners on a line", Vec3::ZERO, x, 2.0 * x),
            edge("a single point", y, y, y),
        ]
    }

    fn random(rng: &mut Pcg) -> TriangleQuestion {
        let [p0, p1, p2] = std::array::from_fn(|_| sample::point(rng, 4.0));
        TriangleQuestion { p0, p1, p2 }
    }

    fn judge(_q: &TriangleQuestion, golden: &Option<Vec3>, got: &Option<Vec3>) -> Verdict {
        judge::option("a normal", golden.as_ref(), got.as_ref(), |golden, got| {
            judge::direction("the normal", *golden, *got)
        })
    }
}

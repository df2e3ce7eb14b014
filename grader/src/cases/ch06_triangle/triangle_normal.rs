//! `triangle_normal`: random questions, judge and mistakes.

use crate::{Graded, Mistake, Relation, Verdict, judge, sample};
use glam::{Vec3, Vec3Swizzles, vec3};
use raybook::math::{dir3::Dir3, pcg::Pcg};
use raybook_workbook::exercises::ch06_triangle::TriangleNormal;

/// The cross product of the edges from a corner to the two others, each of which is brought to length 1.
fn of_unit_edges(q: &TriangleNormal, corner: Vec3, others: [Vec3; 2]) -> Option<Vec3> {
    let [one, other] = others.map(|other| (other - corner).normalize_or_zero());
    TriangleNormal::right(q).map(|_| one.cross(other))
}

impl Graded for TriangleNormal {
    fn random(rng: &mut Pcg) -> TriangleNormal {
        let [p0, p1, p2] = std::array::from_fn(|_| sample::point(rng, 4.0));
        TriangleNormal { p0, p1, p2 }
    }

    fn is_sound(q: &TriangleNormal) -> bool {
        sample::is_triangle([q.p0, q.p1, q.p2])
    }

    fn judge(_q: &TriangleNormal, golden: &Option<Vec3>, got: &Option<Vec3>) -> Verdict {
        judge::option("a normal", golden.as_ref(), got.as_ref(), |golden, got| {
            judge::direction("the normal", *golden, *got)
        })
    }

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| TriangleNormal {
        p0: q.p0 + sample::METRE,
        p1: q.p1 + sample::METRE,
        p2: q.p2 + sample::METRE,
    })];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "exchanges the factors of the cross product, or has the sign of one of them wrong, and so points to the other side",
            hint: "Curl the fingers of your right hand from p0 over p1 to p2: where does the thumb point? From your first factor to your second, do they curl the same way?",
            answer: |q| TriangleNormal::right(q).map(|n| -n),
        },
        Mistake {
            name: "forgets to normalise",
            hint: "The cross product's length is twice the triangle's area.",
            answer: |q| TriangleNormal::right(q).map(|_| (q.p1 - q.p0).cross(q.p2 - q.p0)),
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
            answer: |q| TriangleNormal::right(q).map(|n| if n.y < 0.0 { -n } else { n }),
        },
        Mistake {
            name: "returns the direction of an edge",
            hint: "What is the normal's dot product with each edge?",
            answer: |q| TriangleNormal::right(q).map(|_| (q.p1 - q.p0).normalize()),
        },
        Mistake {
            name: "divides by the square of the length",
            hint: "How long is n, and how long is n/|n|²?",
            answer: |q| {
                TriangleNormal::right(q).map(|_| {
                    let n = (q.p1 - q.p0).cross(q.p2 - q.p0);
                    n / n.length_squared()
                })
            },
        },
        Mistake {
            name: "turns the normal away from the world's origin",
            hint: "It is the order of the corners that decides which side is outside: move the triangle to the other side of the origin, and look at its normal.",
            answer: |q| TriangleNormal::right(q).map(|n| if n.dot(q.p0) < 0.0 { -n } else { n }),
        },
        Mistake {
            name: "turns the normal towards the world's origin",
            hint: "It is the order of the corners that decides which side is outside: move the triangle to the other side of the origin, and look at its normal.",
            answer: |q| TriangleNormal::right(q).map(|n| if n.dot(q.p0) > 0.0 { -n } else { n }),
        },
        Mistake {
            name: "normalises the edges, and not their cross product",
            hint: "How long is the cross product of two unit vectors that are not perpendicular?",
            answer: |q| of_unit_edges(q, q.p0, [q.p1, q.p2]),
        },
        Mistake {
            name: "crosses the first corner and the second, not two edges",
            hint: "Move the triangle by one metre: the normal must not change. Where does your third corner come in?",
            answer: |q| Dir3::new(q.p0.cross(q.p1)).map(|n| *n),
        },
        Mistake {
            name: "always points towards +z",
            hint: "It is the order of the corners that decides which side is outside, not the world, nor a camera.",
            answer: |q| TriangleNormal::right(q).map(|n| if n.z < 0.0 { -n } else { n }),
        },
        Mistake {
            name: "asks only for corners at the same place, not for three on a line",
            hint: "Three different corners on a line: how long is the cross product, and what happens when you divide by that?",
            answer: |q| {
                let have_met = q.p0 == q.p1 || q.p1 == q.p2 || q.p2 == q.p0;
                (!have_met).then(|| TriangleNormal::right(q).unwrap_or(Vec3::NAN))
            },
        },
        Mistake {
            name: "takes the third corner itself for the edge to it",
            hint: "An edge leads from one corner to another: where does yours to the third corner begin?",
            answer: |q| Dir3::new((q.p1 - q.p0).cross(q.p2)).map(|n| *n),
        },
        Mistake {
            name: "takes the second corner itself for the edge to it, or leaves out one of the three cross products of neighbouring corners",
            hint: "An edge leads from one corner to another: where does yours to the second corner begin?",
            answer: |q| Dir3::new(q.p1.cross(q.p2 - q.p0)).map(|n| *n),
        },
        Mistake {
            name: "leaves out the side from the last corner to the first in Newell's sum over the sides",
            hint: "A triangle has three sides: how often does your loop go round, and from which corner to which does the last one lead?",
            answer: |q| {
                let newell = |a: Vec3, b: Vec3| (a - b).yzx() * (a + b).zxy();
                Dir3::new(newell(q.p0, q.p1) + newell(q.p1, q.p2)).map(|n| *n)
            },
        },
        Mistake {
            name: "has the sign of the middle component of the cross product wrong",
            hint: "The components of a cross product are those of yz, zx and xy: which two letters come first in your middle line?",
            answer: |q| Self::right(q).map(|n| n * vec3(1.0, -1.0, 1.0)),
        },
        Mistake {
            name: "has the sign of the first component of the cross product wrong",
            hint: "The components of a cross product are those of yz, zx and xy: in which of your lines do the letters not go round in this order?",
            answer: |q| Self::right(q).map(|n| n * vec3(-1.0, 1.0, 1.0)),
        },
        Mistake {
            name: "has the sign of the last component of the cross product wrong",
            hint: "The components of a cross product are those of yz, zx and xy: in which of your lines do the letters not go round in this order?",
            answer: |q| Self::right(q).map(|n| n * vec3(1.0, 1.0, -1.0)),
        },
        Mistake {
            name: "adds the two products in each component of the cross product",
            hint: "What is the cross product of a vector with itself, and what is yours?",
            answer: |q| {
                let (a, b) = (q.p1 - q.p0, q.p2 - q.p0);
                Dir3::new(a.yzx() * b.zxy() + a.zxy() * b.yzx()).map(|n| *n)
            },
        },
        Mistake {
            name: "multiplies the edges component by component, where a cross product belongs",
            hint: "Is your product perpendicular to both edges?",
            answer: |q| Dir3::new((q.p1 - q.p0) * (q.p2 - q.p0)).map(|n| *n),
        },
        Mistake {
            name: "adds the edges instead of crossing them",
            hint: "In which plane does the sum of two edges lie?",
            answer: |q| Dir3::new((q.p1 - q.p0) + (q.p2 - q.p0)).map(|n| *n),
        },
        Mistake {
            name: "normalises the edges at the second corner, and not their cross product",
            hint: "How long is the cross product of two unit vectors that are not perpendicular?",
            answer: |q| of_unit_edges(q, q.p1, [q.p2, q.p0]),
        },
        Mistake {
            name: "normalises the edges at the third corner, and not their cross product",
            hint: "How long is the cross product of two unit vectors that are not perpendicular?",
            answer: |q| of_unit_edges(q, q.p2, [q.p0, q.p1]),
        },
    ];
}

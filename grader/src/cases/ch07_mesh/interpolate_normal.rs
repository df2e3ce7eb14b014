//! `interpolate_normal`: random questions, judge and mistakes.

use super::{nearest_corner, place};
use crate::upon::changed;
use crate::{Graded, Mistake, Verdict, judge, sample};
use glam::Vec3;
use raybook::math::{dir3::Dir3, pcg::Pcg};
use raybook_workbook::exercises::ch07_mesh::InterpolateNormal;

impl Graded for InterpolateNormal {
    fn random(rng: &mut Pcg) -> InterpolateNormal {
        // Three normals of one hemisphere, as on a smooth mesh.
        let around = *sample::direction(rng);
        let mut normal = || Dir3::new_or(around + 0.9 * *sample::direction(rng), Dir3::Y);
        let (n0, n1, n2) = (normal(), normal(), normal());
        InterpolateNormal {
            n0,
            n1,
            n2,
            b: place(rng),
        }
    }

    fn is_sound(q: &InterpolateNormal) -> bool {
        sample::are_weights(q.b)
    }

    fn judge(_q: &InterpolateNormal, golden: &Vec3, got: &Vec3) -> Verdict {
        judge::direction("the normal", *golden, *got)
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "forgets to normalise",
            hint: "How long is the mean of two unit vectors at right angles?",
            answer: |q| blended(q, |how| how.normalises = false),
        },
        Mistake {
            name: "gives the weights to the wrong corners",
            hint: "At b1 = b2 = 0, whose normal do you return?",
            answer: |q| blended(q, |how| how.weights = |[b1, b2]| [b1, b2, 1.0 - b1 - b2]),
        },
        Mistake {
            name: "swaps b1 and b2",
            hint: "At b1 = 1, whose normal do you return?",
            answer: |q| blended(q, |how| how.weights = |[b1, b2]| [1.0 - b1 - b2, b2, b1]),
        },
        Mistake {
            name: "takes the mean of the three normals, wherever the point is",
            hint: "Move the point towards a corner: the normal should turn towards that corner's.",
            answer: |q| blended(q, |how| how.weights = |_| [1.0, 1.0, 1.0]),
        },
        Mistake {
            name: "gives the first corner the weight 1",
            hint: "The three weights add up to 1.",
            answer: |q| blended(q, |how| how.weights = |[b1, b2]| [1.0, b1, b2]),
        },
        Mistake {
            name: "returns the first corner's normal",
            hint: "That is flat shading; what changes inside the triangle?",
            answer: |q| *q.n0,
        },
        Mistake {
            name: "leaves b2 out of the first corner's weight",
            hint: "The three weights add up to 1: do yours, where neither b1 nor b2 is 0?",
            answer: |q| blended(q, |how| how.weights = |[b1, b2]| [1.0 - b1, b1, b2]),
        },
        Mistake {
            name: "returns the normal of the nearest corner, the one of the largest weight",
            hint: "Move the point a little: does the normal turn a little, or does it jump?",
            answer: |q| [*q.n0, *q.n1, *q.n2][nearest_corner(q.b)],
        },
        Mistake {
            name: "blends the first two normals by b1, and the result with the third by b2",
            hint: "At b1 = b2 = ½ the point lies half way between the second corner and the third: which weights have your three normals there?",
            answer: |q| {
                blended(q, |how| {
                    how.weights = |[b1, b2]| {
                        let rest = 1.0 - b2;
                        [rest * (1.0 - b1), rest * b1, b2]
                    };
                })
            },
        },
        Mistake {
            name: "takes (1 − b1)(1 − b2) for the first corner's weight, as on a square",
            hint: "On the side opposite to the first corner b1 + b2 is 1: which weight should the first corner have there?",
            answer: |q| {
                blended(q, |how| {
                    how.weights = |[b1, b2]| [(1.0 - b1) * (1.0 - b2), b1, b2];
                })
            },
        },
        Mistake {
            name: "forgets n0 in n0 + b1·(n1 − n0) + b2·(n2 − n0)",
            hint: "At b1 = b2 = 0, what do you return? From which normal do both ways begin?",
            answer: |q| blended(q, |how| how.weights = |[b1, b2]| [-b1 - b2, b1, b2]),
        },
        Mistake {
            name: "goes by b2 from the second normal to the third, not from the first",
            hint: "At b2 = 1, whose normal do you return?",
            answer: |q| blended(q, |how| how.weights = |[b1, b2]| [1.0 - b1, b1 - b2, b2]),
        },
        Mistake {
            name: "leaves b1 out of the first corner's weight",
            hint: "The three weights add up to 1: do yours, where neither b1 nor b2 is 0?",
            answer: |q| blended(q, |how| how.weights = |[b1, b2]| [1.0 - b2, b1, b2]),
        },
        Mistake {
            name: "turns the second and the third normal to the side of the first",
            hint: "Where a mesh bends sharply, its normals point far apart: which side is outside there?",
            answer: |q| {
                let turned = |n: Dir3| if n.dot(*q.n0) < 0.0 { -n } else { n };
                Self::misread(q, |q| (q.n1, q.n2) = (turned(q.n1), turned(q.n2)))
            },
        },
        Mistake {
            name: "turns the result to the side of the first normal",
            hint: "Where a mesh bends sharply, the normal may point away from that of the first corner: which side is outside there?",
            answer: |q| {
                let right = Self::right(q);
                if right.dot(*q.n0) < 0.0 {
                    -right
                } else {
                    right
                }
            },
        },
        Mistake {
            name: "crosses the differences of the normals, as if they were corners",
            hint: "The normal of a flat triangle is made of its edges: have you been given any?",
            answer: |q| (*q.n1 - *q.n0).cross(*q.n2 - *q.n0).normalize_or_zero(),
        },
        Mistake {
            name: "normalises after the first two normals, and once more after the third",
            hint: "Is the weight of the third normal still right, once the sum of the other two has been made longer?",
            answer: |q| {
                let first = q.n0.lerp(*q.n1, q.b.x).normalize_or_zero();
                (first + q.b.y * (*q.n2 - *q.n0)).normalize_or_zero()
            },
        },
        Mistake {
            name: "turns evenly from the first normal to the second by b1, and from there to the third by b2 (slerp)",
            hint: "At b1 = b2 = ½ the point lies half way between the second corner and the third: what of the first normal is in yours?",
            answer: |q| {
                let first = q.n0.slerp(*q.n1, q.b.x);
                first.slerp(*q.n2, q.b.y).normalize_or_zero()
            },
        },
        Mistake {
            name: "takes 1 − b1·b2 for the first corner's weight",
            hint: "The three weights add up to 1: do yours at the second corner?",
            answer: |q| blended(q, |how| how.weights = |[b1, b2]| [1.0 - b1 * b2, b1, b2]),
        },
        Mistake {
            name: "turns evenly (slerp) from the first normal by b1/(b0 + b1) to the second, and by b2 to the third",
            hint: "Half way between two normals both ways are the same: a third of the way, does the weighted sum turn by a third of the angle?",
            answer: |q| {
                let rest = 1.0 - q.b.y;
                let share = if rest > 0.0 { q.b.x / rest } else { 0.0 };
                let first = q.n0.slerp(*q.n1, share);
                first.slerp(*q.n2, q.b.y).normalize_or_zero()
            },
        },
        Mistake {
            name: "turns evenly (slerp) from the first normal by b1 + b2 to one between the second and the third",
            hint: "Half way between two normals both ways are the same: a third of the way, does the weighted sum turn by a third of the angle?",
            answer: |q| {
                let rest = q.b.x + q.b.y;
                let share = if rest > 0.0 { q.b.y / rest } else { 0.0 };
                let across = q.n1.slerp(*q.n2, share);
                q.n0.slerp(across, rest).normalize_or_zero()
            },
        },
    ];
}

/// How normals are blended; one field wrong is a mistake.
#[derive(Clone, Copy)]
struct How {
    /// The weights of the three normals, of b1 and b2.
    weights: fn(b: [f32; 2]) -> [f32; 3],
    /// Makes the sum a unit vector.
    normalises: bool,
}

/// As it should be.
const WELL: How = How {
    weights: |[b1, b2]| [1.0 - b1 - b2, b1, b2],
    normalises: true,
};

/// The normal, blended rightly but for what is changed.
fn blended(q: &InterpolateNormal, change: fn(&mut How)) -> Vec3 {
    let how = changed(WELL, change);
    let [w0, w1, w2] = (how.weights)(q.b.to_array());
    let sum = w0 * *q.n0 + w1 * *q.n1 + w2 * *q.n2;
    if how.normalises {
        sum.normalize_or_zero()
    } else {
        sum
    }
}

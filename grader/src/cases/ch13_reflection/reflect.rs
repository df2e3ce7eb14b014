//! Chapter 13: `reflect`.

use crate::upon::changed;
use crate::{Graded, Mistake, Picture, Verdict, judge, sample};
use glam::{Vec3, vec3};
use raybook::math::{dir3::Dir3, pcg::Pcg};
use raybook_chapters::kit::palette;
use raybook_workbook::exercises::ch13_reflection::Reflect;

/// i·n.
fn cosine(q: &Reflect) -> f32 {
    q.incoming.dot(*q.normal)
}

/// The normal on the side from which the ray comes.
fn facing(q: &Reflect) -> Vec3 {
    if cosine(q) > 0.0 {
        -*q.normal
    } else {
        *q.normal
    }
}

/// The right answer by the matrix of the mirror, 1 − 2 n nᵀ, in which an element is a copy of another one of its row: both beside the diagonal.
fn copied(q: &Reflect, row: usize, column: usize) -> Vec3 {
    let n = *q.normal;
    let other = 3 - row - column;
    let mut sent = Reflect::right(q);
    sent[row] += 2.0 * n[row] * (n[column] - n[other]) * q.incoming[column];
    sent.normalize_or_zero()
}

/// What tells a copied element of the matrix.
const COPIED_HINT: &str = "Exchange the rows of a mirror's matrix with its columns: it stays the same matrix. Does yours?";

impl Graded for Reflect {
    fn random(rng: &mut Pcg) -> Reflect {
        Reflect {
            incoming: sample::direction(rng),
            normal: sample::direction(rng),
        }
    }

    fn judge(_q: &Reflect, golden: &Vec3, got: &Vec3) -> Verdict {
        judge::direction("the reflected direction", *golden, *got)
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "turns round the part of i along the surface, not the part along the normal",
            hint: "Which part of i turns round at the mirror: the one along the surface, or the one perpendicular to it?",
            answer: |q| -Reflect::right(q),
        },
        Mistake {
            name: "forgets the 2",
            hint: "Subtract (i·n) n once, and you are left with a direction along the surface: how far is it to the other side?",
            answer: |q| scaled(q, |how| how.factor = 1.0),
        },
        Mistake {
            name: "takes the cross product i × n for the part of i along n",
            hint: "Which product of two vectors tells how much of one lies along the other, and which is perpendicular to both?",
            answer: |q| scaled(q, |how| how.part = |q| q.incoming.cross(*q.normal)),
        },
        Mistake {
            name: "adds 2 (i·n) n instead of subtracting it",
            hint: "Let the ray fall straight down: how long is your answer?",
            answer: |q| mirrored(q, |how| how.sign = -1.0),
        },
        Mistake {
            name: "adds 2 |i·n| n to i",
            hint: "Turn the normal round: it is the same mirror. Does your answer change?",
            answer: |q| mirrored(q, |how| how.part = |q| -cosine(q).abs() * *q.normal),
        },
        Mistake {
            name: "lets the ray pass",
            hint: "Your answer is the incoming direction itself.",
            answer: |q| mirrored(q, |how| how.factor = 0.0),
        },
        Mistake {
            name: "sends the ray back to where it came from",
            hint: "Only a ray along the normal comes back the same way.",
            answer: |q| Self::misread(q, |q| q.normal = q.incoming),
        },
        Mistake {
            name: "answers with the normal",
            hint: "The normal is half way between where the light comes from and where it goes.",
            answer: facing,
        },
        Mistake {
            name: "subtracts 2 |i·n| n from i",
            hint: "From which side does the ray come, and does the formula need to know?",
            answer: |q| mirrored(q, |how| how.part = |q| cosine(q).abs() * *q.normal),
        },
        Mistake {
            name: "takes a 4 for the 2",
            hint: "Mirror a vector by hand: how often do you take away what is along the normal?",
            answer: |q| scaled(q, |how| how.factor = 4.0),
        },
        Mistake {
            name: "mirrors only where the normal points along the ray",
            hint: "The normal may point to either side: what becomes of a ray that runs against it?",
            answer: |q| {
                if cosine(q) > 0.0 {
                    Reflect::right(q)
                } else {
                    *q.incoming
                }
            },
        },
        Mistake {
            name: "mirrors only where the ray runs against the normal",
            hint: "The normal may point to either side: what becomes of a ray that runs along it?",
            answer: |q| {
                if cosine(q) < 0.0 {
                    Reflect::right(q)
                } else {
                    *q.incoming
                }
            },
        },
        Mistake {
            name: "forgets the 2, and returns what is left along the surface",
            hint: "Subtract (i·n) n once, and you are left with a vector along the surface: how far is it to the other side?",
            answer: |q| mirrored(q, |how| how.factor = 1.0),
        },
        Mistake {
            name: "multiplies i and n axis by axis instead of taking their dot product",
            hint: "i·n is one number: what is still to be done with the three products?",
            answer: |q| mirrored(q, |how| how.part = axis_by_axis),
        },
        Mistake {
            name: "multiplies i and n axis by axis instead of taking their dot product, and normalises what comes of it",
            hint: "i·n is one number: what is still to be done with the three products?",
            answer: |q| {
                mirrored(q, |how| {
                    how.part = axis_by_axis;
                    // At 45° rounding decides the sign of 1 − 2 n.x²; less EPSILON, the sign is that of a program in double precision.
                    how.end = |sent, q| (sent - f32::EPSILON * *q.incoming).normalize_or_zero();
                })
            },
        },
        Mistake {
            name: "adds i and the normal, and normalises",
            hint: "A ray leaves a mirror at the angle at which it comes: does yours?",
            answer: |q| {
                mirrored(q, |how| {
                    how.part = |q| -0.5 * facing(q);
                    how.end = |sent, q| sent.normalize_or(facing(q));
                })
            },
        },
        Mistake {
            name: "turns round only the axis that the normal is nearest to",
            hint: "That mirrors at the faces of a box: what if the normal lies between two axes?",
            answer: |q| mirrored(q, |how| how.part = along_nearest_axis),
        },
        Mistake {
            name: "turns the arriving direction round together with the normal, where the normal points along it",
            hint: "A mirror has two sides: if you turn the normal to the side from which the ray comes, does the ray come from elsewhere?",
            answer: |q| {
                let right = Reflect::right(q);
                if cosine(q) > 0.0 { -right } else { right }
            },
        },
        Mistake {
            name: "has x·y of the normal where x·z belongs, in the first row of the mirror's matrix",
            hint: COPIED_HINT,
            answer: |q| copied(q, 0, 2),
        },
        Mistake {
            name: "has x·y of the normal where y·z belongs, in the second row of the mirror's matrix",
            hint: COPIED_HINT,
            answer: |q| copied(q, 1, 2),
        },
        Mistake {
            name: "has x·z of the normal where y·z belongs, in the last row of the mirror's matrix",
            hint: COPIED_HINT,
            answer: |q| copied(q, 2, 1),
        },
        Mistake {
            name: "adds 2 |i·n| n to i (and brings the sum to length 1)",
            hint: "Turn the normal round: it is the same mirror. Does your answer change?",
            answer: |q| scaled(q, |how| how.part = |q| -cosine(q).abs() * *q.normal),
        },
    ];

    const PICTURES: &'static [Picture<Self>] = &[Picture {
        name: "reflect",
        width: 64,
        height: 64,
        alt: "A mirror ball; the direction that each pixel sees in it is a colour",
        question: |x, y| {
            let place = |i: u32| (i as f32 + 0.5) / 29.0 - 32.0 / 29.0;
            let (x, y) = (place(x), -place(y));
            let z = (1.0 - x * x - y * y).max(0.0).sqrt();
            let normal = if z > 0.0 { vec3(x, y, z) } else { Vec3::Z };
            Reflect {
                incoming: Dir3::new_or(vec3(0.2 * x, 0.2 * y, -1.0), -Dir3::Z),
                normal: Dir3::new_or(normal, Dir3::Z),
            }
        },
        colour: |_, reflected| palette::direction(*reflected),
    }];
}

/// How a ray is mirrored; one field wrong is a mistake.
#[derive(Clone, Copy)]
struct How {
    /// The part of i along the normal.
    part: fn(q: &Reflect) -> Vec3,
    /// How often it is subtracted from i …
    factor: f32,
    /// … or added to it, if this is −1.
    sign: f32,
    /// What is made of the direction in the end.
    end: fn(sent: Vec3, q: &Reflect) -> Vec3,
}

/// As it should be.
const WELL: How = How {
    part: |q| cosine(q) * *q.normal,
    factor: 2.0,
    sign: 1.0,
    end: |sent, _| sent,
};

/// The reflected direction, mirrored rightly but for what is changed.
fn mirrored(q: &Reflect, change: impl FnOnce(&mut How)) -> Vec3 {
    let how = changed(WELL, change);
    (how.end)(*q.incoming - how.sign * how.factor * (how.part)(q), q)
}

/// The same, brought to length 1.
fn scaled(q: &Reflect, change: impl FnOnce(&mut How)) -> Vec3 {
    mirrored(q, |how| {
        how.end = |sent, _| sent.normalize_or_zero();
        change(how);
    })
}

/// (i.x n.x², …): what comes of (i·n) n without the sum.
fn axis_by_axis(q: &Reflect) -> Vec3 {
    *q.incoming * *q.normal * *q.normal
}

/// The part of i along the axis that the normal is nearest to.
fn along_nearest_axis(q: &Reflect) -> Vec3 {
    *q.incoming * Vec3::AXES[q.normal.abs().max_position()]
}

//! `solve_quadratic`: random questions, judge and mistakes.

use crate::{Flaw, Graded, Mistake, Verdict, judge, sample};
use glam::{Vec2, vec2};
use rand::RngExt;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch03_sphere::SolveQuadratic;

/// What loses digits, in whatever order and precision it is calculated.
const SCHOOLBOOK: &str = "uses the schoolbook formula for both roots";
const SCHOOLBOOK_HINT: &str = "Where b² is much larger than 4ac, −b and the square root nearly cancel in one of the roots: which one, and how else can you get it?";

/// What a few roundings leave of a large root, as a share of it.
const LAST: f32 = 4.0 * f32::EPSILON;

/// A root is small if it is below this share of the other.
const SMALL: f32 = 1e-3;

impl Graded for SolveQuadratic {
    fn random(rng: &mut Pcg) -> SolveQuadratic {
        let (a, b) = (
            sample::number(rng, 0.2, 3.0),
            sample::number(rng, -8.0, 8.0),
        );
        let sign = if rng.random_bool(0.3) { -1.0 } else { 1.0 };
        SolveQuadratic {
            a: sign * a,
            b,
            c: sample::number(rng, -6.0, 6.0),
        }
    }

    fn judge(_q: &SolveQuadratic, golden: &Option<Vec2>, got: &Option<Vec2>) -> Verdict {
        judge::option(
            "a pair of real roots",
            golden.as_ref(),
            got.as_ref(),
            |golden, got| {
                for (name, root, got) in [("t0", golden.x, got.x), ("t1", golden.y, got.y)] {
                    // Relative to the root alone: the small one is what cancellation spoils.
                    judge::number_within(
                        name,
                        "",
                        root,
                        got,
                        judge::RELATIVE * root.abs().max(1e-6),
                    )
                    .map_err(|why| {
                        // The last digits of the large root are the first ones of the small one.
                        let large = golden.abs().max_element();
                        let is_lost =
                            (got - root).abs() <= LAST * large && root.abs() < SMALL * large;
                        let lost = ": its digits are lost in the difference of two large numbers";
                        if is_lost { why + lost } else { why }
                    })?;
                }
                Ok(())
            },
        )
    }

    const FLAWS: &'static [Flaw] = &[Flaw {
        complaint: "its digits are lost",
        name: SCHOOLBOOK,
        hint: SCHOOLBOOK_HINT,
    }];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: SCHOOLBOOK,
            hint: SCHOOLBOOK_HINT,
            answer: |q| {
                roots(q, |q, root| {
                    vec2((-q.b - root) / (2.0 * q.a), (-q.b + root) / (2.0 * q.a))
                })
                .map(sorted)
            },
        },
        Mistake {
            name: "returns the roots unsorted",
            hint: "Try a negative a, then a positive b: which of your two roots is the smaller one?",
            answer: |q| {
                SolveQuadratic::right(q).map(|t| {
                    if q.a < 0.0 || q.b > 0.0 {
                        vec2(t.y, t.x)
                    } else {
                        t
                    }
                })
            },
        },
        Mistake {
            name: "forgets the 2 in 2a",
            hint: "Put one of your roots back into the equation: is a·t² + b·t + c really 0?",
            answer: |q| SolveQuadratic::right(q).map(|t| 2.0 * t),
        },
        Mistake {
            name: "has the sign of b wrong",
            hint: "Put one of your roots back into the equation, and then its negative.",
            answer: |q| SolveQuadratic::right(q).map(|t| vec2(-t.y, -t.x)),
        },
        Mistake {
            name: "takes 0 for the sign of b where b is 0",
            hint: "In −½(b + sign(b)·√(b² − 4ac)) the root must never get lost: which sign does it need where b is 0, and what does your sign function say of 0?",
            answer: |q| SolveQuadratic::right(q).map(|t| if q.b == 0.0 { Vec2::ZERO } else { t }),
        },
        Mistake {
            name: "returns none for a double root",
            hint: "When b² = 4ac the parabola touches zero: how often?",
            answer: |q| SolveQuadratic::right(q).filter(|t| t.x != t.y),
        },
        Mistake {
            name: "takes the root of |b² − 4ac|",
            hint: "What does a negative discriminant say about the parabola?",
            answer: |q| {
                let root = (q.b * q.b - 4.0 * q.a * q.c).abs().sqrt();
                (q.a != 0.0).then(|| {
                    sorted(vec2(
                        (-q.b - root) / (2.0 * q.a),
                        (-q.b + root) / (2.0 * q.a),
                    ))
                })
            },
        },
        Mistake {
            name: "divides by 2 instead of 2a",
            hint: "Put one of your roots back into the equation for an a other than 1.",
            answer: |q| {
                roots(q, |q, root| vec2(0.5 * (-q.b - root), 0.5 * (-q.b + root))).map(sorted)
            },
        },
        Mistake {
            name: "takes b² + 4ac under the root",
            hint: "Which sign stands before 4ac? Check one of your roots.",
            answer: |q| under(q, q.b * q.b + 4.0 * q.a * q.c),
        },
        Mistake {
            name: "forgets the root of the discriminant",
            hint: "Check the units: what is added to b?",
            answer: |q| {
                let inside = q.b * q.b - 4.0 * q.a * q.c;
                (q.a != 0.0 && inside >= 0.0).then(|| {
                    sorted(vec2(
                        (-q.b - inside) / (2.0 * q.a),
                        (-q.b + inside) / (2.0 * q.a),
                    ))
                })
            },
        },
        Mistake {
            name: "takes b² − ac under the root",
            hint: "Which number stands before ac in the discriminant? Check one of your roots.",
            answer: |q| under(q, q.b * q.b - q.a * q.c),
        },
        Mistake {
            name: "halves b under the root only",
            hint: "Two formulas are mixed: in the one with b/2 everything is divided by a, and b is halved everywhere.",
            answer: |q| under(q, 0.25 * q.b * q.b - q.a * q.c),
        },
        Mistake {
            name: "returns the root of the larger absolute value first",
            hint: "Which of the two roots is the smaller one, if both are negative?",
            answer: |q| {
                SolveQuadratic::right(q).map(|t| {
                    if t.y.abs() > t.x.abs() {
                        vec2(t.y, t.x)
                    } else {
                        t
                    }
                })
            },
        },
        Mistake {
            name: "forgets the ½ in −½ (b ± √(b² − 4ac)), from which both roots are made",
            hint: "In the stable formula one root is q/a, with q = −½ (b ± √(b² − 4ac)). What is the other root, and how large is your q?",
            answer: |q| stable(q, 2.0, 0.5),
        },
        Mistake {
            name: "forgets the 2 under the fraction line of the root of the larger absolute value",
            hint: "One of the two roots is right: put the other back into the equation.",
            answer: |q| stable(q, 2.0, 1.0),
        },
        Mistake {
            name: "forgets the 2 above the fraction line of the root of the smaller absolute value",
            hint: "The product of both roots is c/a: is yours?",
            answer: |q| stable(q, 1.0, 0.5),
        },
        Mistake {
            name: "takes b² − 2ac under the root",
            hint: "Which number stands before ac in the discriminant? Check one of your roots.",
            answer: |q| under(q, q.b * q.b - 2.0 * q.a * q.c),
        },
        Mistake {
            name: "writes /2*a, which divides by 2 and multiplies by a",
            hint: "What does your language calculate first in x/2*a?",
            answer: |q| SolveQuadratic::right(q).map(|t| q.a * q.a * t),
        },
        Mistake {
            name: "returns none where both roots are 0",
            hint: "t² = 0 has a root: which one?",
            answer: |q| SolveQuadratic::right(q).filter(|t| *t != Vec2::ZERO),
        },
        Mistake {
            name: "orders the roots as if a were positive",
            hint: "Where a is negative, which of (−b − √…)/2a and (−b + √…)/2a is the smaller?",
            answer: |q| {
                let right = SolveQuadratic::right(q);
                right.map(|t| if q.a < 0.0 { vec2(t.y, t.x) } else { t })
            },
        },
        Mistake {
            name: "returns the root of the smaller absolute value first",
            hint: "Which is the smaller one of −5 and 2?",
            answer: |q| {
                SolveQuadratic::right(q).map(|t| {
                    if t.y.abs() < t.x.abs() {
                        vec2(t.y, t.x)
                    } else {
                        t
                    }
                })
            },
        },
        Mistake {
            name: "solves b·t + c = 0 where a is 0",
            hint: "Where a is 0, how many roots are there: a pair?",
            answer: |q| {
                if q.a == 0.0 && q.b != 0.0 {
                    Some(Vec2::splat(-q.c / q.b))
                } else {
                    SolveQuadratic::right(q)
                }
            },
        },
        Mistake {
            name: "takes 0 for a negative discriminant",
            hint: "What does a negative discriminant say about the parabola?",
            answer: |q| {
                let vertex = || (q.a != 0.0).then(|| Vec2::splat(-q.b / (2.0 * q.a)));
                SolveQuadratic::right(q).or_else(vertex)
            },
        },
        Mistake {
            name: "divides only the square root by 2a, and not −b",
            hint: "What does your language calculate first in −b − √…/(2a)?",
            answer: |q| {
                roots(q, |q, root| {
                    let half = root / (2.0 * q.a);
                    vec2(-q.b - half, -q.b + half)
                })
                .map(sorted)
            },
        },
        Mistake {
            name: "takes c for the product of both roots, which is c/a",
            hint: "Multiply a·(t − t0)·(t − t1) out: what stands where c stands?",
            answer: |q| stable(q, 1.0, q.a),
        },
        Mistake {
            name: "halves b in all places, and still takes 4ac under the root",
            hint: "Put b = 2h into the formula: what is left of the 4 in 4ac when the 2 has been cancelled?",
            answer: |q| Self::misread(q, |q| q.c *= 4.0),
        },
        Mistake {
            name: "halves b under the root and divides by a, but does not halve −b",
            hint: "Put b = 2h into the formula and cancel the 2: what becomes of −b?",
            answer: |q| {
                roots(q, |q, root| {
                    vec2((-q.b - 0.5 * root) / q.a, (-q.b + 0.5 * root) / q.a)
                })
                .map(sorted)
            },
        },
        Mistake {
            name: "returns none where both roots are negative, as if they were distances",
            hint: "A negative root is a root: who decides here whether a distance counts?",
            answer: |q| SolveQuadratic::right(q).filter(|t| t.y >= 0.0),
        },
        Mistake {
            name: "takes b/a for the sum of both roots, which is −b/a",
            hint: "Multiply a·(t − t0)·(t − t1) out: what stands where b stands?",
            answer: |q| {
                SolveQuadratic::right(q).map(|t| {
                    let first = if t.x.abs() > t.y.abs() { t.x } else { t.y };
                    sorted(vec2(first, q.b / q.a - first))
                })
            },
        },
        Mistake {
            name: "returns the middle of both roots and half of their distance",
            hint: "Which two numbers are asked for? Put yours back into the equation.",
            answer: |q| {
                SolveQuadratic::right(q).map(|t| vec2(0.5 * (t.x + t.y), 0.5 * (t.y - t.x)))
            },
        },
        Mistake {
            name: "writes /2*a in the root of the larger absolute value, which divides by 2 and multiplies by a",
            hint: "What does your language calculate first in x/2*a?",
            answer: |q| stable(q, q.a * q.a, 1.0),
        },
        Mistake {
            name: "writes /2*a in the root of the larger absolute value, and makes the other root of that",
            hint: "What does your language calculate first in x/2*a?",
            answer: |q| stable(q, q.a * q.a, 1.0 / (q.a * q.a)),
        },
        Mistake {
            name: "writes −b ± √…/2*a without any brackets",
            hint: "What does your language calculate first in −b + x/2*a?",
            answer: |q| {
                roots(q, |q, root| {
                    let part = 0.5 * root * q.a;
                    vec2(-q.b - part, -q.b + part)
                })
                .map(sorted)
            },
        },
        Mistake {
            name: "uses the formula (−h ± √(h² − ac))/a of a·t² + 2h·t + c = 0, and puts b in for h",
            hint: "Compare a·t² + 2h·t + c with a·t² + b·t + c: what is h?",
            answer: |q| Self::misread(q, |q| q.b *= 2.0),
        },
        Mistake {
            name: "uses the p-q formula, −p/2 ± √(p²/4 − q), with b and c themselves for p and q",
            hint: "In t² + p·t + q = 0 nothing stands before t²: how do you get there from a·t² + b·t + c = 0?",
            answer: |q| Self::misread(q, |q| q.a = if q.a == 0.0 { 0.0 } else { 1.0 }),
        },
        Mistake {
            name: "divides b by a for the p-q formula, −p/2 ± √(p²/4 − q), but not c",
            hint: "In t² + p·t + q = 0 nothing stands before t²: what becomes of c on the way there?",
            answer: |q| Self::misread(q, |q| q.c *= q.a),
        },
        Mistake {
            name: "divides c by a for the p-q formula, −p/2 ± √(p²/4 − q), but not b",
            hint: "In t² + p·t + q = 0 nothing stands before t²: what becomes of b on the way there?",
            answer: |q| Self::misread(q, |q| q.b *= q.a),
        },
        Mistake {
            name: "takes p²/2 for (p/2)² in the p-q formula, −p/2 ± √((p/2)² − q)",
            hint: "How large is the square of p/2, for p = 6?",
            answer: |q| {
                let (p, product) = (q.b / q.a, q.c / q.a);
                let root = (0.5 * p * p - product).sqrt();
                let is_real = q.a != 0.0 && root.is_finite();
                is_real.then(|| vec2(-0.5 * p - root, -0.5 * p + root))
            },
        },
        Mistake {
            name: "takes b² + 4ac under the root, and makes the other root of the first",
            hint: "Which sign stands before 4ac? Check one of your roots.",
            answer: |q| kept_under(q, q.b * q.b + 4.0 * q.a * q.c),
        },
        Mistake {
            name: "takes b² − ac under the root, and makes the other root of the first",
            hint: "Which number stands before ac in the discriminant? Check one of your roots.",
            answer: |q| kept_under(q, q.b * q.b - q.a * q.c),
        },
        Mistake {
            name: "takes b² − 2ac under the root, and makes the other root of the first",
            hint: "Which number stands before ac in the discriminant? Check one of your roots.",
            answer: |q| kept_under(q, q.b * q.b - 2.0 * q.a * q.c),
        },
        Mistake {
            name: "takes b²/4 − ac under the root, and makes the other root of the first",
            hint: "Two formulas are mixed: in the one with b/2 everything is divided by a, and b is halved everywhere.",
            answer: |q| kept_under(q, 0.25 * q.b * q.b - q.a * q.c),
        },
        Mistake {
            name: "takes |b² − 4ac| under the root, and makes the other root of the first",
            hint: "What does a negative discriminant say about the parabola?",
            answer: |q| kept_under(q, (q.b * q.b - 4.0 * q.a * q.c).abs()),
        },
        Mistake {
            name: "forgets the root of the discriminant, and makes the other root of the first",
            hint: "Check the units: what is added to b?",
            answer: |q| {
                let inside = q.b * q.b - 4.0 * q.a * q.c;
                kept_under(q, inside * inside).filter(|_| inside >= 0.0)
            },
        },
    ];
}

/// The roots by a formula that is given √(b² − 4ac), where that is real and a ≠ 0.
fn roots(q: &SolveQuadratic, formula: fn(&SolveQuadratic, f32) -> Vec2) -> Option<Vec2> {
    let discriminant = q.b * q.b - 4.0 * q.a * q.c;
    (q.a != 0.0 && discriminant >= 0.0).then(|| formula(q, discriminant.sqrt()))
}

/// The same by the formula that keeps the digits: one root, and the other from their product, c/a.
fn kept_under(q: &SolveQuadratic, inside: f32) -> Option<Vec2> {
    let half = -0.5 * (q.b + inside.sqrt().copysign(q.b));
    let other = if half == 0.0 { 0.0 } else { q.c / half };
    (q.a != 0.0 && inside >= 0.0).then(|| sorted(vec2(half / q.a, other)))
}

/// The roots with another number under the root.
fn under(q: &SolveQuadratic, inside: f32) -> Option<Vec2> {
    let root = inside.sqrt();
    let roots = vec2((-q.b - root) / (2.0 * q.a), (-q.b + root) / (2.0 * q.a));
    (q.a != 0.0 && inside >= 0.0).then(|| sorted(roots))
}

fn sorted(t: Vec2) -> Vec2 {
    vec2(t.min_element(), t.max_element())
}

/// The roots by the stable formula, that of the larger size and that of the smaller size each times a factor.
fn stable(q: &SolveQuadratic, larger: f32, smaller: f32) -> Option<Vec2> {
    SolveQuadratic::right(q).map(|t| {
        sorted(if t.x.abs() > t.y.abs() {
            vec2(larger * t.x, smaller * t.y)
        } else {
            vec2(smaller * t.x, larger * t.y)
        })
    })
}

//! `refract`: random questions, judge and mistakes.

use crate::upon::changed;
use crate::{Graded, Mistake, Verdict, judge, sample};
use glam::Vec3;
use rand::RngExt;
use raybook::math::{dir3::Dir3, pcg::Pcg};
use raybook_workbook::exercises::ch14_refraction::Refract;
use std::f32::consts::FRAC_PI_2;

/// Rounding moves an angle by less than this, in radians.
const ROUNDING: f32 = 1e-5;

impl Graded for Refract {
    fn random(rng: &mut Pcg) -> Refract {
        let (normal, mut direction) = (sample::direction(rng), sample::direction(rng));
        // Steep rays are refracted, flat ones are often not: most are to be refracted.
        if rng.random_bool(0.5) {
            let steeper = *direction + direction.dot(*normal).signum() * *normal;
            direction = Dir3::new_or(steeper, direction);
        }
        Refract {
            direction,
            normal,
            outside: sample::number(rng, 1.0, 1.7),
            inside: sample::number(rng, 1.0, 2.4),
        }
    }

    fn judge(_q: &Refract, golden: &Option<Vec3>, got: &Option<Vec3>) -> Verdict {
        let (golden, got) = (golden.as_ref(), got.as_ref());
        judge::option("a refracted ray", golden, got, |golden, got| {
            judge::direction("the refracted ray", *golden, *got)
        })
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "never turns the normal",
            hint: "On which side of the surface does a ray start that leaves the glass? Your formula needs the normal on that side.",
            answer: |q| bent(q, |how| how.normal = |q| *q.normal),
        },
        Mistake {
            name: "turns the cosine, but not the normal, where the ray leaves",
            hint: "On which side of the surface does a ray start that leaves the glass? What is added along the normal must go to the other side.",
            answer: |q| {
                bent(q, |how| {
                    how.normal = |q| *q.normal;
                    how.cosine = |q, n| q.direction.dot(n).abs();
                })
            },
        },
        Mistake {
            name: "takes the same ratio for entering and leaving",
            hint: "A ray that leaves the glass comes from the inside: which index is then n1?",
            answer: |q| bent(q, |how| how.ratio = |q| q.outside / q.inside),
        },
        Mistake {
            name: "has the ratio of the indices upside down",
            hint: "Into a denser medium a ray bends towards the normal: does yours?",
            answer: |q| bent(q, |how| how.ratio = |q| 1.0 / ratio(q)),
        },
        Mistake {
            name: "has the sign of the cosine wrong",
            hint: "The ray runs against the normal: what is the sign of their dot product?",
            answer: |q| bent(q, |how| how.cosine = |q, n| q.direction.dot(n)),
        },
        Mistake {
            name: "mirrors the ray where it is totally reflected",
            hint: "This function is asked for the ray behind the surface only: is there one?",
            answer: |q| {
                let n = facing(q);
                let mirrored = *q.direction - 2.0 * q.direction.dot(n) * n;
                Some(Refract::right(q).unwrap_or(mirrored))
            },
        },
        Mistake {
            name: "lets the ray graze the surface where it is totally reflected",
            hint: "What does it mean if the sine of an angle would be larger than 1?",
            answer: |q| {
                let n = facing(q);
                let along = *q.direction - q.direction.dot(n) * n;
                Refract::right(q).or(Some(along.normalize_or_zero()))
            },
        },
        Mistake {
            name: "forgets the square root",
            hint: "You have the square of a cosine: how long is your answer at 45°?",
            answer: |q| {
                bent(q, |how| {
                    how.second = |cos1, eta| Some(square(cos1, eta)).filter(|square| *square > 0.0);
                })
            },
        },
        Mistake {
            name: "sends the ray to the wrong side",
            hint: "Does your ray go on behind the surface, or come back?",
            answer: |q| {
                bent(q, |how| {
                    how.ray = |i, n, eta, cos1, cos2| snell(i, n, eta, cos1, -cos2);
                })
            },
        },
        Mistake {
            name: "goes straight on",
            hint: "Where are the two indices in your formula?",
            answer: |q| Refract::right(q).map(|_| *q.direction),
        },
        Mistake {
            name: "takes the incoming ray's cosine for the refracted ray's",
            hint: "Two angles, two cosines: which of them belongs to the ray behind the surface?",
            answer: |q| bent(q, |how| how.second = first_again),
        },
        Mistake {
            name: "takes the angles for their sines in Snell's law",
            hint: "n₁ sin θ₁ = n₂ sin θ₂: which function of the angle do you multiply? Try 60°.",
            answer: |q| {
                let (angle, refracted) = by_angles(q);
                is_surely_below_90_degrees(angle).then_some(refracted)
            },
        },
        Mistake {
            name: "takes the root of the absolute value, so that it does not see total reflection",
            hint: "What does it mean if the square of a cosine is negative?",
            answer: |q| {
                bent(q, |how| {
                    how.second = |cos1, eta| Some(square(cos1, eta).abs().sqrt());
                })
            },
        },
        Mistake {
            name: "takes 0 for the root of what is negative, and lets the ray graze the surface where it is totally reflected",
            hint: "What does it mean if the square of a cosine is negative?",
            answer: |q| {
                bent(q, |how| {
                    how.second = |cos1, eta| Some(square(cos1, eta).max(0.0).sqrt());
                })
            },
        },
        Mistake {
            name: "takes the angles for their sines in Snell's law, but multiplies the direction by the ratio",
            hint: "n₁ sin θ₁ = n₂ sin θ₂: which function of the angle do you multiply? Try 60°.",
            answer: |q| {
                let (angle, refracted) = by_angles_and_ratio(q);
                is_surely_below_90_degrees(angle).then_some(refracted)
            },
        },
        Mistake {
            name: "goes straight on where it is totally reflected",
            hint: "What does it mean if the sine of an angle would be larger than 1?",
            answer: |q| Refract::right(q).or(Some(*q.direction)),
        },
        Mistake {
            name: "turns round the part of the direction along the surface",
            hint: "Seen from above, does a ray turn back where it enters the glass?",
            answer: |q| {
                bent(q, |how| {
                    how.ray = |i, n, eta, cos1, cos2| -eta * (i + cos1 * n) - cos2 * n;
                })
            },
        },
        Mistake {
            name: "takes the incoming ray's cosine for the refracted ray's, and normalises",
            hint: "When your ray is brought to length 1, its sine is divided by that length: is it still n₁/n₂ times the sine of the incoming ray?",
            answer: |q| {
                bent(q, |how| {
                    how.second = first_again;
                    how.ray =
                        |i, n, eta, cos1, cos2| snell(i, n, eta, cos1, cos2).normalize_or_zero();
                })
            },
        },
        Mistake {
            name: "takes every ray into a thinner medium for totally reflected",
            hint: "Look out of the water, straight up: do you see the sky?",
            answer: |q| Refract::right(q).filter(|_| ratio(q) <= 1.0),
        },
        Mistake {
            name: "divides the smaller index by the larger, whichever way the ray goes",
            hint: "Into a denser medium a ray bends towards the normal, and out of it?",
            answer: |q| {
                bent(q, |how| {
                    how.ratio = |q| q.outside.min(q.inside) / q.outside.max(q.inside);
                })
            },
        },
        Mistake {
            name: "multiplies the cosine, not the sine, by n₁/n₂ to see whether the ray is totally reflected",
            hint: "Snell's law is about the angles' sines: which rays are totally reflected, the steep or the flat ones?",
            answer: |q| {
                bent(q, |how| {
                    how.second = |cos1, eta| {
                        let root = square(cos1, eta).max(0.0).sqrt();
                        (eta * cos1 <= 1.0).then_some(root)
                    };
                    how.ray =
                        |i, n, eta, cos1, cos2| snell(i, n, eta, cos1, cos2).normalize_or_zero();
                })
            },
        },
        Mistake {
            name: "takes 1 − sin θ₂ for the cosine, and normalises",
            hint: "sin² + cos² = 1: where are the squares, and the root?",
            answer: |q| {
                bent(q, |how| {
                    how.second = |cos1, eta| {
                        let square = square(cos1, eta);
                        (square > 0.0).then(|| 1.0 - (1.0 - square).sqrt())
                    };
                    how.ray =
                        |i, n, eta, cos1, cos2| snell(i, n, eta, cos1, cos2).normalize_or_zero();
                })
            },
        },
        Mistake {
            name: "takes the cosine before it turns the normal",
            hint: "A ray leaves the glass: which sign has your cosine, and which has it after the normal is turned?",
            answer: |q| bent(q, |how| how.cosine = |q, _| -q.direction.dot(*q.normal)),
        },
        Mistake {
            name: "asks for total reflection only where the ray leaves",
            hint: "Glass surrounds a bubble, and outside is the denser: may a ray on its way in be totally reflected?",
            answer: |q| {
                let n = facing(q);
                let (cos1, eta) = (-q.direction.dot(n), ratio(q));
                let enters = q.direction.dot(*q.normal) < 0.0;
                let is_total = eta * eta * (1.0 - cos1 * cos1) > 1.0;
                if enters && is_total {
                    Some(eta * *q.direction + eta * cos1 * n)
                } else {
                    Self::right(q)
                }
            },
        },
        Mistake {
            name: "takes the angles for their sines in Snell's law, but asks by the sines for total reflection",
            hint: "n₁ sin θ₁ = n₂ sin θ₂: which function of the angle do you multiply, where you ask for total reflection, and after that? Try 60°.",
            answer: |q| along(q).map(|_| by_angles(q).1),
        },
        Mistake {
            name: "takes the angles for their sines in Snell's law, and never asks for total reflection",
            hint: "n₁ sin θ₁ = n₂ sin θ₂: which function of the angle do you multiply? And what if the angle behind the surface would be more than 90°?",
            answer: |q| Some(by_angles(q).1),
        },
        Mistake {
            name: "takes the angles for their sines in Snell's law, and lets a ray at exactly 90° through",
            hint: "n₁ sin θ₁ = n₂ sin θ₂: which function of the angle do you multiply? Try 60°.",
            answer: |q| {
                let (angle, refracted) = by_angles(q);
                (angle <= FRAC_PI_2 + ROUNDING).then_some(refracted)
            },
        },
        Mistake {
            name: "takes the angles for their sines in Snell's law, and lets a ray at exactly 90° through, but multiplies the direction by the ratio",
            hint: "n₁ sin θ₁ = n₂ sin θ₂: which function of the angle do you multiply? Try 60°.",
            answer: |q| {
                let (angle, refracted) = by_angles_and_ratio(q);
                (angle <= FRAC_PI_2 + ROUNDING).then_some(refracted)
            },
        },
    ];
}

/// The normal on the ray's side.
fn facing(q: &Refract) -> Vec3 {
    -q.direction.dot(*q.normal).signum() * *q.normal
}

/// n₁/n₂.
fn ratio(q: &Refract) -> f32 {
    if q.direction.dot(*q.normal) < 0.0 {
        q.outside / q.inside
    } else {
        q.inside / q.outside
    }
}

/// How a ray is bent; one field wrong is a mistake.
#[derive(Clone, Copy)]
struct How {
    /// The normal on the ray's side.
    normal: fn(&Refract) -> Vec3,
    /// The cosine of the incoming ray with the normal `n`.
    cosine: fn(&Refract, n: Vec3) -> f32,
    /// n₁/n₂.
    ratio: fn(&Refract) -> f32,
    /// The cosine of the refracted ray, where that of the incoming one is `cos1`; none where the ray is totally reflected.
    second: fn(cos1: f32, eta: f32) -> Option<f32>,
    /// The refracted ray of the direction `i`.
    ray: fn(i: Vec3, n: Vec3, eta: f32, cos1: f32, cos2: f32) -> Vec3,
}

/// As it should be.
const WELL: How = How {
    normal: facing,
    cosine: |q, n| -q.direction.dot(n),
    ratio,
    second: |cos1, eta| {
        let square = square(cos1, eta);
        (square >= 0.0).then(|| square.sqrt())
    },
    ray: snell,
};

/// The refracted ray, rightly but for what is changed.
fn bent(q: &Refract, change: fn(&mut How)) -> Option<Vec3> {
    let how = changed(WELL, change);
    let (n, eta) = ((how.normal)(q), (how.ratio)(q));
    let cos1 = (how.cosine)(q, n);
    let cos2 = (how.second)(cos1, eta)?;
    Some((how.ray)(*q.direction, n, eta, cos1, cos2))
}

/// cos²θ₂ = 1 − η²(1 − cos²θ₁): negative where the ray is totally reflected.
fn square(cos1: f32, eta: f32) -> f32 {
    1.0 - eta * eta * (1.0 - cos1 * cos1)
}

/// η i + (η cos θ₁ − cos θ₂) n.
fn snell(i: Vec3, n: Vec3, eta: f32, cos1: f32, cos2: f32) -> Vec3 {
    eta * i + (eta * cos1 - cos2) * n
}

/// The first cosine once more, unless the ray is totally reflected.
fn first_again(cos1: f32, eta: f32) -> Option<f32> {
    (square(cos1, eta) > 0.0).then_some(cos1)
}

/// The part of the refracted ray along the surface, unless it is totally reflected.
fn along(q: &Refract) -> Option<Vec3> {
    let n = facing(q);
    let along = ratio(q) * (*q.direction - q.direction.dot(n) * n);
    (along.length_squared() < 1.0).then_some(along)
}

/// n₁/n₂ times the angle of the incoming ray, and the ray at this angle behind the surface.
fn by_angles(q: &Refract) -> (f32, Vec3) {
    let n = facing(q);
    let flat = *q.direction - q.direction.dot(n) * n;
    let angle = flat.length().min(1.0).asin() * ratio(q);
    (
        angle,
        angle.sin() * flat.normalize_or_zero() - angle.cos() * n,
    )
}

/// The same angle, and η i + (η cos θ₁ − cos θ₂) n with it.
fn by_angles_and_ratio(q: &Refract) -> (f32, Vec3) {
    let (n, eta) = (facing(q), ratio(q));
    let cos1 = (-q.direction.dot(n)).clamp(-1.0, 1.0);
    let angle = eta * cos1.acos();
    (angle, eta * *q.direction + (eta * cos1 - angle.cos()) * n)
}

/// Whether an angle is below 90°, and not 90° but for rounding, as that of a ray out of glass of index 1.5 at 60°.
fn is_surely_below_90_degrees(angle: f32) -> bool {
    angle < FRAC_PI_2 - ROUNDING
}

//! `geodesic_step`: judged by the bend of the ray, so any method that is good enough is right.

use crate::upon::changed;
use crate::{Graded, Mistake, Verdict, sample};
use glam::{DVec3, Vec3};
use raybook::math::pcg::Pcg;
use raybook::render::curved::Photon;
use raybook_workbook::exercises::ch21_black_hole::{GeodesicStep, GeodesicStepAnswer};

impl Graded for GeodesicStep {
    /// A bend is a small part of a position: what is alike must be so in the bend, which the judge sees to.
    const ALIKE: f32 = 1e-6;

    fn random(rng: &mut Pcg) -> GeodesicStep {
        let radius = sample::number(rng, 1.5, 10.0);
        let speed = sample::number(rng, 0.5, 2.0);
        GeodesicStep {
            position: radius * *sample::direction(rng),
            velocity: speed * *sample::direction(rng),
            step: sample::number(rng, 0.03, 0.05) * radius / speed,
        }
    }

    fn judge(q: &GeodesicStep, golden: &GeodesicStepAnswer, got: &GeodesicStepAnswer) -> Verdict {
        let straight = q.position + q.step * q.velocity;
        let (after, size) = (golden.position, q.position.length());
        bend("position", straight, after, got.position, size)?;
        let (after, size) = (golden.velocity, q.velocity.length());
        bend("velocity", q.velocity, after, got.velocity, size)
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "divides the unit vector by the fifth power",
            hint: "x/|x|⁵ has the length 1/|x|⁴: how long is yours at |x| = 2?",
            answer: |q| stepped(q, |how| how.power = 6),
        },
        Mistake {
            name: "divides by the fourth power",
            hint: "x/|x|⁵ has the length 1/|x|⁴: how long is yours at |x| = 2?",
            answer: |q| stepped(q, |how| how.power = 4),
        },
        Mistake {
            name: "forgets the factor 3/2",
            hint: "A ray at |x| = 3/2, perpendicular to the radius, goes around in a circle: does yours?",
            answer: |q| stepped(q, |how| how.factor = -1.0),
        },
        Mistake {
            name: "pulls twice as strongly, as if 1 were the hole's mass and not its radius",
            hint: "Here the radius is 1, and the mass is half of it. If the velocity turns in two halves of the step, is each of them half a step?",
            answer: |q| stepped(q, |how| how.factor = -3.0),
        },
        Mistake {
            name: "takes h for h²",
            hint: "Twice the velocity and half the step give the same ray: do they in your formula?",
            answer: |q| stepped(q, |how| how.h2 = |x, v| x.cross(v).length()),
        },
        Mistake {
            name: "pushes the light away",
            hint: "Does gravity pull or push?",
            answer: |q| stepped(q, |how| how.factor = 1.5),
        },
        Mistake {
            name: "takes the dot product for the cross product",
            hint: "A ray that aims at the middle is not bent: what is its h?",
            answer: |q| stepped(q, |how| how.h2 = |x, v| x.dot(v).powi(2)),
        },
        Mistake {
            name: "takes |x||v| for |x × v|",
            hint: "A ray that aims at the middle is not bent: what is its h?",
            answer: |q| {
                stepped(q, |how| {
                    how.h2 = |x, v| x.length_squared() * v.length_squared();
                })
            },
        },
        Mistake {
            name: "lets light fall as a stone does, by Newton's law",
            hint: "Is your light pulled less when it goes slower?",
            answer: |q| stepped(q, |how| (how.factor, how.newton) = (0.0, 0.5)),
        },
        Mistake {
            name: "goes straight on for the whole step (Euler's method)",
            hint: "Where the velocity turns during the step, the position must notice it.",
            answer: |q| {
                stepped(q, |how| {
                    how.step = |x, v, step, pull| [x + step * v, v + step * pull(x, v)];
                })
            },
        },
        Mistake {
            name: "turns the velocity for half of the step only",
            hint: "In the middle of the step the velocity has turned half of its way: what is missing until the end of the step?",
            answer: |q| {
                stepped(q, |how| {
                    how.step = |x, v, step, pull| {
                        let half = v + 0.5 * step * pull(x, v);
                        [x + step * half, half]
                    };
                })
            },
        },
        Mistake {
            name: "moves with the velocity after the step",
            hint: "During the step the velocity is neither what it was nor what it will be.",
            answer: |q| {
                stepped(q, |how| {
                    how.step = |x, v, step, pull| {
                        let v = v + step * pull(x, v);
                        [x + step * v, v]
                    };
                })
            },
        },
        Mistake {
            name: "goes straight on, as if there were no hole",
            hint: "Does your velocity change at all?",
            answer: |q| stepped(q, |how| how.factor = 0.0),
        },
        Mistake {
            name: "gives the four slopes the same weight, and divides by 6",
            hint: "The weights of the slopes must add up to 1: what are they, of the slopes in the middle of the step?",
            answer: |q| {
                stepped(q, |how| {
                    how.step = |x, v, step, pull| by_slopes(x, v, step, pull, [1.0 / 6.0; 4], 1.0);
                })
            },
        },
        Mistake {
            name: "leaves the fourth slope out of the sum",
            hint: "The weights of the slopes must add up to 1: is the one at the end of the step among them?",
            answer: |q| {
                stepped(q, |how| {
                    how.step = |x, v, step, pull| {
                        let weights = [1.0, 2.0, 2.0, 0.0].map(|w| w / 6.0);
                        by_slopes(x, v, step, pull, weights, 1.0)
                    };
                })
            },
        },
        Mistake {
            name: "divides the weighted sum of the slopes by 3 instead of 6",
            hint: "The weights of the slopes must add up to 1: do yours?",
            answer: |q| {
                stepped(q, |how| {
                    how.step = |x, v, step, pull| {
                        by_slopes(x, v, step, pull, WEIGHTS.map(|w| 2.0 * w), 1.0)
                    };
                })
            },
        },
        Mistake {
            name: "takes the fourth slope in the middle of the step",
            hint: "Two of the four slopes belong to the middle of the step: where does the fourth one belong?",
            answer: |q| {
                stepped(q, |how| {
                    how.step = |x, v, step, pull| by_slopes(x, v, step, pull, WEIGHTS, 0.5);
                })
            },
        },
        Mistake {
            name: "pulls along the velocity, not towards the hole",
            hint: "To which point does the hole pull, and which of the two vectors points there?",
            answer: |q| stepped(q, |how| how.along = |_, v| v),
        },
        Mistake {
            name: "divides by the third power",
            hint: "x/|x|⁵ has the length 1/|x|⁴: how long is yours at |x| = 2?",
            answer: |q| stepped(q, |how| how.power = 3),
        },
        Mistake {
            name: "squares h² once more",
            hint: "Do you square the length of x × v, or its square?",
            answer: |q| stepped(q, |how| how.h2 = |x, v| h2(x, v).powi(2)),
        },
        Mistake {
            name: "keeps the length of the velocity",
            hint: "Light has always the same speed, but v is dx/dλ: is dv/dλ perpendicular to v?",
            answer: |q| {
                let after = Self::right(q);
                GeodesicStepAnswer {
                    velocity: q.velocity.length() * after.velocity.normalize_or_zero(),
                    ..after
                }
            },
        },
        Mistake {
            name: "does not divide the weighted sum of the slopes by 6",
            hint: "The weights of the slopes must add up to 1: do yours?",
            answer: |q| {
                stepped(q, |how| {
                    how.step = |x, v, step, pull| {
                        by_slopes(x, v, step, pull, WEIGHTS.map(|w| 6.0 * w), 1.0)
                    };
                })
            },
        },
        Mistake {
            name: "turns the velocity for a whole step by the pull at the start, and for a whole step by that at the end",
            hint: "How many steps does the velocity turn in all: is it one?",
            answer: |q| {
                stepped(q, |how| {
                    how.step = |x, v, step, pull| {
                        let first = pull(x, v);
                        let end = x + step * v + 0.5 * step * step * first;
                        [end, v + step * (first + pull(end, v))]
                    };
                })
            },
        },
        Mistake {
            name: "pulls by Newton's law too, and adds Einstein's term to it",
            hint: "A ray that aims at the middle is not pulled at all: is yours?",
            answer: |q| stepped(q, |how| how.newton = 0.5),
        },
        Mistake {
            name: "takes the z component of x × v for its length",
            hint: "A ray that goes past the hole above it, not beside it: what is z of its x × v?",
            answer: |q| stepped(q, |how| how.h2 = |x, v| x.cross(v).z.powi(2)),
        },
        Mistake {
            name: "takes |x|²|v|² − x·v for h², without squaring x·v",
            hint: "A ray that aims at the middle is not bent: what is its h²?",
            answer: |q| {
                stepped(q, |how| {
                    how.h2 = |x, v| x.length_squared() * v.length_squared() - x.dot(v);
                })
            },
        },
        Mistake {
            name: "takes |x|² for |x|, and so divides by the tenth power",
            hint: "x/|x|⁵ has the length 1/|x|⁴: how long is yours at |x| = 2?",
            answer: |q| stepped(q, |how| how.power = 10),
        },
        Mistake {
            name: "moves with the velocity before the step, and turns it by the pull after that",
            hint: "Where the velocity turns during the step, the position must notice it.",
            answer: |q| {
                stepped(q, |how| {
                    how.step = |x, v, step, pull| {
                        let end = x + step * v;
                        [end, v + step * pull(end, v)]
                    };
                })
            },
        },
        Mistake {
            name: "takes h for h², and divides the unit vector by the fifth power",
            hint: "Twice the velocity and half the step give the same ray: do they in your formula? And x/|x|⁵ has the length 1/|x|⁴: how long is yours at |x| = 2?",
            answer: |q| {
                stepped(q, |how| {
                    how.h2 = |x, v| x.cross(v).length();
                    how.power = 6;
                })
            },
        },
        Mistake {
            name: "takes h for h², and divides by the fourth power",
            hint: "Twice the velocity and half the step give the same ray: do they in your formula? And x/|x|⁵ has the length 1/|x|⁴: how long is yours at |x| = 2?",
            answer: |q| {
                stepped(q, |how| {
                    how.h2 = |x, v| x.cross(v).length();
                    how.power = 4;
                })
            },
        },
        Mistake {
            name: "moves by half the step times the pull, not by half the square of the step",
            hint: "In which unit is a pull, and in which is a way: how often must it be multiplied by the step?",
            answer: |q| {
                stepped(q, |how| {
                    how.step = |x, v, step, pull| {
                        let [_, after] = by_slopes(x, v, step, pull, WEIGHTS, 1.0);
                        [x + step * v + 0.5 * step * pull(x, v), after]
                    };
                })
            },
        },
    ];
}

/// Compares by how much a vector is bent away from where a straight ray would have it; `size` says how large its roundings are.
fn bend(name: &str, straight: Vec3, golden: Vec3, got: Vec3, size: f32) -> Verdict {
    /// Of the bend.
    const SHARE: f32 = 0.1;
    /// Of the size of the vector: some roundings of `f32`.
    const ROUNDING: f32 = 2e-6;
    if !got.is_finite() {
        return Err(format!(
            "the {name} is {got}, which is not a vector of numbers"
        ));
    }
    let (bent, off) = (golden.distance(straight), got.distance(golden));
    if off <= SHARE * bent + ROUNDING * size {
        return Ok(());
    }
    if bent <= ROUNDING * size {
        return Err(format!(
            "the {name} is off by {off:.1e}: this ray should go straight on"
        ));
    }
    let share = off / bent;
    let share = if share < 10.0 {
        format!("{:.0} %", 100.0 * share)
    } else {
        format!("{share:.0} times the size")
    };
    Err(format!(
        "the {name} is off by {off:.1e}, which is {share} of the bend"
    ))
}

/// By which the velocity changes, of a position and a velocity.
type Pull<'a> = &'a dyn Fn(DVec3, DVec3) -> DVec3;

/// How a step is gone; one field wrong is a mistake.
#[derive(Clone, Copy)]
struct How {
    /// The factor of Einstein's term.
    factor: f64,
    /// The square of h.
    h2: fn(x: DVec3, v: DVec3) -> f64,
    /// The power of |x| by which it is divided.
    power: i32,
    /// The vector along which it pulls.
    along: fn(x: DVec3, v: DVec3) -> DVec3,
    /// The factor of a pull by Newton's law besides.
    newton: f64,
    /// The position and the velocity after a step.
    step: fn(x: DVec3, v: DVec3, step: f64, pull: Pull<'_>) -> [DVec3; 2],
}

/// As it should be: a good step (the classical fourth-order one).
const WELL: How = How {
    factor: -1.5,
    h2,
    power: 5,
    along: |x, _| x,
    newton: 0.0,
    step: |x, v, step, pull| by_slopes(x, v, step, pull, WEIGHTS, 1.0),
};

/// The weights of its four slopes.
const WEIGHTS: [f64; 4] = [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0];

fn h2(x: DVec3, v: DVec3) -> f64 {
    x.cross(v).length_squared()
}

/// What is after the step, gone rightly but for what is changed.
fn stepped(q: &GeodesicStep, change: fn(&mut How)) -> GeodesicStepAnswer {
    let how = changed(WELL, change);
    let pull = |x: DVec3, v: DVec3| {
        let einstein = how.factor * (how.h2)(x, v) / x.length().powi(how.power);
        einstein * (how.along)(x, v) - how.newton * x / x.length().powi(3)
    };
    let (x, v) = (q.position.as_dvec3(), q.velocity.as_dvec3());
    let [x, v] = (how.step)(x, v, f64::from(q.step), &pull);
    GeodesicStepAnswer {
        position: x.as_vec3(),
        velocity: v.as_vec3(),
    }
}

/// A step by four slopes, with these weights; the fourth of them is taken at this share of the step.
fn by_slopes(
    x: DVec3,
    v: DVec3,
    step: f64,
    pull: Pull<'_>,
    weights: [f64; 4],
    fourth: f64,
) -> [DVec3; 2] {
    let slope = |p: Photon| Photon {
        x: p.v,
        v: pull(p.x, p.v),
    };
    let p = Photon { x, v };
    let k1 = slope(p);
    let k2 = slope(p + k1 * (step / 2.0));
    let k3 = slope(p + k2 * (step / 2.0));
    let k4 = slope(p + k3 * (fourth * step));
    let [w1, w2, w3, w4] = weights;
    let end = p + (k1 * w1 + k2 * w2 + k3 * w3 + k4 * w4) * step;
    [end.x, end.v]
}

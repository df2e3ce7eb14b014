//! `shadow_ray`: random questions, judge and mistakes.

use super::way::{aimed_anew, ends_before, next_to_nothing, starts_off};
use crate::{Flaw, Graded, Mistake, Relation, Verdict, judge, sample};
use glam::Vec3;
use rand::RngExt;
use raybook::math::{dir3::Dir3, interval::Interval, pcg::Pcg};
use raybook_workbook::exercise::Exercise;
use raybook_workbook::exercises::ch15_shadows::{ShadowRay, Way};

/// What moves the start to the light, by whatever step.
const ALONG: &str = "moves the start along the ray, not along the normal";
const ALONG_HINT: &str =
    "A lamp just above the horizon: how far above the surface does your ray start?";

/// What leads to a step along one axis of the world.
const ONE_AXIS_HINT: &str =
    "A surface askew to all axes: how far off it does a step along one of them lead?";

/// What leads to an error that is a length, and no share of one.
const RELATIVE_HINT: &str = "The error is in metres already: is a point that is far from the world's origin wrong by more than that?";

/// What leads to a step that goes with the error.
const FIXED_HINT: &str = "Is your step much on a grain of sand, and on a planet? Which number in the question says how far is enough?";

/// What leads to a step that is at least as long as the error.
const NEARER_HINT: &str = "The true surface may be as far from the point as the error says: can your ray still start below it?";

/// Where a way ends that is as long as the light is far from the point, or a little less: as a share of that.
const JUST_BEFORE: f32 = 0.9995;

/// The right answer, with another start.
fn starting(q: &ShadowRay, origin: Vec3, min: f32) -> Way {
    let right = ShadowRay::right(q);
    let within = Interval::new(min, right.within.max);
    Way {
        origin,
        within,
        ..right
    }
}

/// The right answer, with a start as far off as if the error were `times` times as large.
fn relative(q: &ShadowRay, times: f32) -> Way {
    let step = (2.0 * times * q.error).copysign(q.normal.dot(*q.toward));
    starting(q, q.position + step * *q.normal, 0.0)
}

/// The right answer, with a start this many metres off the surface, whatever the error is.
fn fixed(q: &ShadowRay, step: f32) -> Way {
    let side = ShadowRay::right(q).direction.dot(*q.normal).signum();
    starting(q, q.position + step * side * *q.normal, 0.0)
}

/// The right answer, with another end.
fn ending(q: &ShadowRay, max: f32) -> Way {
    let right = ShadowRay::right(q);
    Way {
        within: right.within.before(max),
        ..right
    }
}

/// The right answer, with another direction.
fn along(q: &ShadowRay, direction: Vec3) -> Way {
    let right = ShadowRay::right(q);
    Way { direction, ..right }
}

impl Graded for ShadowRay {
    /// A start on the surface itself, and one at a small part of the error off it, are two mistakes.
    const ALIKE: f32 = 2e-5;

    fn random(rng: &mut Pcg) -> ShadowRay {
        let scale = 10.0_f32.powf(sample::number(rng, -1.5, 3.0));
        let (normal, toward) = loop {
            let (normal, toward) = (sample::direction(rng), sample::direction(rng));
            if normal.dot(*toward).abs() > 0.1 {
                break (normal, toward);
            }
        };
        let distance = if rng.random_bool(0.15) {
            f32::INFINITY
        } else {
            scale * sample::number(rng, 2.0, 6.0)
        };
        ShadowRay {
            position: scale * sample::point(rng, 3.0),
            error: scale * sample::number(rng, 0.01, 0.03),
            normal,
            toward,
            distance,
        }
    }

    fn judge(q: &ShadowRay, golden: &Way, got: &Way) -> Verdict {
        let given = judge::direction("the ray", golden.direction, got.direction);
        given.or_else(|why| aimed_anew(q, got).ok_or(why))?;
        starts_off(q, got)?;
        ends_before(q, got)
    }

    /// What is right of a ray, its start, its direction or its end, as the reference has it: how far off the surface a ray starts, and
    /// how long before the light it ends, is everybody's own choice. A ray that goes elsewhere starts and ends as if the light were there.
    fn canonical(q: &ShadowRay, got: Way) -> Way {
        let given = judge::direction("the ray", *q.toward, got.direction);
        let is_aimed = given.is_ok() || aimed_anew(q, &got).is_some();
        let elsewhere = Dir3::new(got.direction).filter(|_| !is_aimed);
        let toward = elsewhere.unwrap_or(q.toward);
        let asked = ShadowRay {
            toward,
            ..q.clone()
        };
        let right = ShadowRay::answer(&asked);
        let starts = starts_off(&asked, &got).is_ok();
        let mirrored = Way {
            origin: 2.0 * q.position - got.origin,
            ..got.clone()
        };
        // On the wrong side the step is everybody's own choice too.
        let is_mirrored = !starts && starts_off(&asked, &mirrored).is_ok();
        // An end that is right for a right start is everybody's own choice, also where the start is wrong.
        let from_right = Way {
            origin: right.origin,
            ..got.clone()
        };
        let ends = ends_before(&asked, &got).is_ok()
            || !starts && ends_before(&asked, &from_right).is_ok();
        // So is how much before the light a way ends that is measured from the point.
        let just_before = (2.0 * JUST_BEFORE - 1.0) * q.distance..=q.distance;
        Way {
            origin: if starts {
                right.origin
            } else if is_mirrored {
                2.0 * q.position - right.origin
            } else {
                next_to_nothing(&asked, &got).unwrap_or(got.origin)
            },
            direction: if is_aimed {
                right.direction
            } else {
                got.direction
            },
            within: Interval {
                min: if starts {
                    right.within.min
                } else {
                    got.within.min
                },
                max: if ends {
                    right.within.max
                } else if just_before.contains(&got.within.max) {
                    JUST_BEFORE * q.distance
                } else {
                    got.within.max
                },
            },
        }
    }

    const FLAWS: &'static [Flaw] = &[
        Flaw {
            complaint: "along its way",
            name: ALONG,
            hint: ALONG_HINT,
        },
        Flaw {
            complaint: "along one axis of the world",
            name: "steps along one axis of the world only, which is not far enough off the surface",
            hint: ONE_AXIS_HINT,
        },
        Flaw {
            complaint: "starts nowhere",
            name: "starts the ray nowhere: a number is missing or infinite",
            hint: "Print the place where your ray starts.",
        },
        Flaw {
            complaint: "on the wrong side of the point",
            name: "starts on the side of the surface away from the light",
            hint: "On which side of the surface is the light, and to which side do you step?",
        },
        Flaw {
            complaint: "m behind the ray's origin",
            name: "begins the interval behind the ray's origin",
            hint: "Which points of the ray does a negative distance name?",
        },
        Flaw {
            complaint: "m off the point",
            name: "does not step far enough off the surface",
            hint: "How far may the true surface be from the point?",
        },
        Flaw {
            complaint: "what is in between throws no shadow",
            name: "starts too far from the surface",
            hint: "What if a leaf lies on the surface, thinner than your step?",
        },
        Flaw {
            complaint: "and the interval ends at",
            name: "ends the interval before a light that is infinitely far away",
            hint: "Where does the way to the sun end?",
        },
        Flaw {
            complaint: "the interval does not end",
            name: "lets the interval go on behind the light",
            hint: "Can something behind the light throw a shadow?",
        },
        Flaw {
            complaint: "the light, and not before it",
            name: "ends the interval at the light or behind it",
            hint: "The light itself may be a surface in the scene: does the ray find it, if the interval ends behind it?",
        },
        Flaw {
            complaint: "before the light, too soon",
            name: "ends the interval too soon",
            hint: "How much of the way to the light does your ray look at?",
        },
        Flaw {
            complaint: "the ray points",
            name: "sends the ray in another direction than to the light",
            hint: "From where to where does the ray go?",
        },
    ];

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| ShadowRay {
        position: q.position + sample::METRE,
        ..q.clone()
    })];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "starts on the surface itself",
            hint: "The point is not exactly on the surface: it may lie a little below. What does a ray to the light meet first then?",
            answer: |q| starting(q, q.position, 0.0),
        },
        Mistake {
            name: ALONG,
            hint: ALONG_HINT,
            answer: |q| starting(q, q.position + 2.0 * q.error * *q.toward, 0.0),
        },
        Mistake {
            name: "starts a fixed millimetre along the ray",
            hint: "Is a millimetre much on a grain of sand, and on a planet? Which number in the question says how far is enough?",
            answer: |q| starting(q, q.position, 1e-3),
        },
        Mistake {
            name: "steps a fixed millimetre along the normal",
            hint: "Is a millimetre much on a grain of sand, and on a planet? Which number in the question says how far is enough?",
            answer: |q| fixed(q, 1e-3),
        },
        Mistake {
            name: "steps a fixed centimetre along the normal",
            hint: FIXED_HINT,
            answer: |q| fixed(q, 1e-2),
        },
        Mistake {
            name: "steps a fixed tenth of a millimetre along the normal",
            hint: FIXED_HINT,
            answer: |q| fixed(q, 1e-4),
        },
        Mistake {
            name: "steps a fixed hundredth of a millimetre along the normal",
            hint: FIXED_HINT,
            answer: |q| fixed(q, 1e-5),
        },
        Mistake {
            name: "steps to the normal's side, wherever the light is",
            hint: "A sheet may be lit from behind: on which side of it does the ray leave?",
            answer: |q| {
                let step = q.error * q.normal.abs().element_sum();
                starting(q, q.position + step * *q.normal, 0.0)
            },
        },
        Mistake {
            name: "steps the error itself along the normal, as if it were not that of each coordinate",
            hint: "Each coordinate may be off by the error: how far is that along a normal that is askew to all axes?",
            answer: |q| relative(q, 0.5),
        },
        Mistake {
            name: "steps half of the error off the surface",
            hint: NEARER_HINT,
            answer: |q| relative(q, 0.25),
        },
        Mistake {
            name: "steps a tenth of the error off the surface",
            hint: NEARER_HINT,
            answer: |q| relative(q, 0.05),
        },
        Mistake {
            name: "lets the interval begin a metre behind the ray's origin",
            hint: "Which points of the ray does a negative distance name?",
            answer: |q| starting(q, ShadowRay::right(q).origin, -1.0),
        },
        Mistake {
            name: "skips a quarter of the way",
            hint: "What stands close to the surface throws no shadow any more: how far off the surface must the ray start?",
            answer: |q| {
                let far = if q.distance.is_finite() {
                    q.distance
                } else {
                    100.0
                };
                starting(q, q.position, 0.25 * far)
            },
        },
        Mistake {
            name: "sets no end to the interval",
            hint: "There is a wall behind the lamp: does it throw a shadow on you?",
            answer: |q| ending(q, f32::INFINITY),
        },
        Mistake {
            name: "ends the interval at twice the light's distance",
            hint: "How far is the light, and how far does your interval reach?",
            answer: |q| ending(q, 2.0 * q.distance),
        },
        Mistake {
            name: "gives the ray the length of the whole way, and lets the interval end at 1",
            hint: "A direction has length 1, so t is in metres: at which t is the light?",
            answer: |q| {
                let right = ShadowRay::right(q);
                let far = if q.distance.is_finite() {
                    q.distance
                } else {
                    1.0
                };
                Way {
                    direction: far * right.direction,
                    within: Interval::new(0.0, 1.0),
                    ..right
                }
            },
        },
        Mistake {
            name: "ends the interval at 1, wherever the light is",
            hint: "The ray's direction has length 1: at which t is the light?",
            answer: |q| ending(q, 1.0),
        },
        Mistake {
            name: "ends the interval at the square of the light's distance",
            hint: "What is the length of the way, and what is its dot product with itself?",
            answer: |q| {
                let right = ShadowRay::right(q);
                let square = q.distance * q.distance;
                Way {
                    within: Interval::new(right.within.min, square),
                    ..right
                }
            },
        },
        Mistake {
            name: "goes away from the light",
            hint: "From the surface to the light: in which direction?",
            answer: |q| {
                let away = ShadowRay {
                    toward: -q.toward,
                    ..q.clone()
                };
                ShadowRay::right(&away)
            },
        },
        Mistake {
            name: "sends the ray from the light to the point",
            hint: "Where is the surface that must not be found again: at the ray's beginning, or at its end?",
            answer: |q| {
                let right = ShadowRay::right(q);
                // The sun has no place to start from.
                let start = q.position + q.distance * *q.toward;
                Way {
                    origin: if start.is_finite() {
                        start
                    } else {
                        right.origin
                    },
                    direction: -right.direction,
                    ..right
                }
            },
        },
        Mistake {
            name: "shortens the way by a share as large as the error",
            hint: "The error is in metres: is it multiplied by the distance, or taken from it?",
            answer: |q| ending(q, q.distance * (1.0 - q.error)),
        },
        Mistake {
            name: "steps off along the ray instead of along the normal",
            hint: "A ray that grazes the surface stays close to it for long: in which direction is it soonest clear of it?",
            answer: |q| starting(q, q.position, q.error),
        },
        Mistake {
            name: "starts a tenth of a metre off the surface",
            hint: "What stands close to the surface throws no shadow any more: which number in the question says how far is far enough?",
            answer: |q| {
                starting(
                    q,
                    q.position + 0.1 * q.normal.dot(*q.toward).signum() * *q.normal,
                    0.0,
                )
            },
        },
        Mistake {
            name: "turns the direction to the light where the normal faces away from it",
            hint: "A sheet that is lit from behind: which of the two must be turned, the normal or the direction to the light?",
            answer: |q| {
                Self::misread(q, |q| {
                    if q.normal.dot(*q.toward) < 0.0 {
                        q.toward = -q.toward;
                    }
                })
            },
        },
        Mistake {
            name: "ends the interval at the light's distance from the point, or at a share just below, as if the ray began there",
            hint: "Your ray begins off the point: how far is the light from where it begins?",
            answer: |q| ending(q, JUST_BEFORE * q.distance),
        },
        Mistake {
            name: "chooses the side of the surface by whether the light is above the horizon",
            hint: "A ceiling faces down: on which side of it is a lamp that stands in the room?",
            answer: |q| {
                let step = q.error * q.normal.abs().element_sum();
                let side = 1.0_f32.copysign(q.toward.y);
                starting(q, q.position + side * step * *q.normal, 0.0)
            },
        },
        Mistake {
            name: "steps up by the error along +y, wherever the surface is",
            hint: "A wall is left sideways: which vector in the question tells to which side?",
            answer: |q| starting(q, q.position + q.error * Vec3::Y, 0.0),
        },
        Mistake {
            name: "adds the error to each coordinate",
            hint: "In which direction do you step, and on which side of the surface is the light?",
            answer: |q| starting(q, q.position + Vec3::splat(q.error), 0.0),
        },
        Mistake {
            name: "sends the ray along the normal",
            hint: "From the surface to the light: which of the two directions is that?",
            answer: |q| along(q, q.normal.dot(*q.toward).signum() * *q.normal),
        },
        Mistake {
            name: "mirrors the direction to the light at the normal",
            hint: "A shadow ray goes to the light: what is a mirror direction for?",
            answer: |q| along(q, 2.0 * q.normal.dot(*q.toward) * *q.normal - *q.toward),
        },
        Mistake {
            name: "ends the interval at nine tenths of the way",
            hint: "What hangs close below the lamp throws a shadow too: how much before the light must the ray end?",
            answer: |q| ending(q, 0.9 * q.distance),
        },
        Mistake {
            name: "ends the interval a twentieth of the way before the light",
            hint: "What hangs close below the lamp throws a shadow too: how much before the light must the ray end?",
            answer: |q| ending(q, 0.95 * q.distance),
        },
        Mistake {
            name: "ends the interval a fixed millimetre before the light's distance from the point",
            hint: "Your ray begins off the point: how far is the light from where it begins? And is a millimetre much on a grain of sand, and on a planet?",
            answer: |q| ending(q, q.distance - 1e-3),
        },
        Mistake {
            name: "steps along the axis that is nearest to the normal, not along the normal",
            hint: ONE_AXIS_HINT,
            answer: |q| {
                let axis = q.normal.abs().max_position();
                let side = q.normal[axis] * q.normal.dot(*q.toward);
                let mut origin = q.position;
                origin[axis] += (2.0 * q.error).copysign(side);
                starting(q, origin, 0.0)
            },
        },
        Mistake {
            name: "multiplies the error by the point's largest coordinate, or by 1 if that is more",
            hint: RELATIVE_HINT,
            answer: |q| relative(q, q.position.abs().max_element().max(1.0)),
        },
        Mistake {
            name: "multiplies the error by the point's largest coordinate, even if that is less than 1",
            hint: RELATIVE_HINT,
            answer: |q| relative(q, q.position.abs().max_element()),
        },
        Mistake {
            name: "multiplies the error by the point's distance from the world's origin, or by 1 if that is more",
            hint: RELATIVE_HINT,
            answer: |q| relative(q, q.position.length().max(1.0)),
        },
        Mistake {
            name: "multiplies the error by the point's distance from the world's origin, even if that is less than 1",
            hint: RELATIVE_HINT,
            answer: |q| relative(q, q.position.length()),
        },
        Mistake {
            name: "ends the interval at 0.99, wherever the light is",
            hint: "The ray's direction has length 1: at which t is the light?",
            answer: |q| ending(q, 0.99),
        },
    ];
}

//! `deflection_angle`: by quadrature, by stepping the ray, by series where they are good enough.

mod cut;
mod sums;

use crate::{Flaw, Graded, Mistake, Verdict, judge, sample};
use cut::{begun_at, distance_of, followed, left_out};
use rand::RngExt;
use raybook::math::pcg::Pcg;
use raybook::render::curved::CRITICAL;
use raybook_workbook::exercises::ch21_black_hole::DeflectionAngle;
use std::f32::consts::PI;
use sums::{count_that_loses, sum};

/// An angle this near to the right one is the result of a right method that is not exact enough.
const NEARLY: f32 = 0.1;

/// What is said of such an angle.
const COARSE: &str = "that is nearly right, but not to a part in a thousand";

/// What is wrong with a sum of equal steps up to the turning point, and what leads to it.
const UNBOUNDED: &str = "sums equal steps up to the turning point, where the integrand grows without end, and loses a part of it";
const UNBOUNDED_HINT: &str = "Halve your steps: is the angle off by half as much? Which other variable than 1/r keeps the integrand finite where the ray turns?";

/// What leads from a ray that is followed from a fixed distance on to the whole ray.
const CUT_HINT: &str = "Begin twice as far away, and end there: does the angle of a ray with a large b change? How far away must a ray begin, compared with its b?";

/// What is wrong with a ray that begins at some times its impact parameter, and what leads to what is missing.
const LEFT_OUT: &str = "begins, or ends, at a distance of some times b, and leaves out the angle that the ray sweeps between there and infinity";
const LEFT_OUT_HINT: &str = "Is every angle too small by the same? How large an angle does a straight ray sweep before it comes to your first distance, as seen from the hole?";

impl Graded for DeflectionAngle {
    fn random(rng: &mut Pcg) -> DeflectionAngle {
        let impact_parameter = if rng.random_bool(0.2) {
            sample::number(rng, 0.1, 2.58)
        } else {
            (sample::number(rng, 2.61_f32.ln(), 300.0_f32.ln())).exp()
        };
        DeflectionAngle { impact_parameter }
    }

    fn judge(_q: &DeflectionAngle, golden: &Option<f32>, got: &Option<f32>) -> Verdict {
        let (golden, got) = (golden.as_ref(), got.as_ref());
        judge::option("a ray that gets away", golden, got, |golden, got| {
            let tolerance = judge::RELATIVE * golden;
            judge::number_within("the angle", "rad", *golden, *got, tolerance)
        })
    }

    fn complaint(
        q: &DeflectionAngle,
        golden: &Option<f32>,
        got: &Option<f32>,
        why: String,
    ) -> String {
        let (Some(golden), Some(got)) = (*golden, *got) else {
            return why;
        };
        let b = f64::from(q.impact_parameter);
        let lost = f64::from(golden - got);
        let distance = || distance_of(b, f64::from(got)).filter(|_| got < golden);
        if let Some(steps) = count_that_loses(b, lost) {
            format!("{why}: it is the sum of {steps} equal steps of 1/r up to the turning point")
        } else if let Some(times) = left_out(b, lost) {
            format!(
                "{why}: as much is missing as a straight ray sweeps on its way from infinity to the distance of {times} b"
            )
        } else if lost.abs() <= f64::from(NEARLY * golden) {
            format!("{why}: {COARSE}")
        } else if let Some(distance) = distance() {
            format!(
                "{why}: a ray that starts {distance} radii before the hole and ends as far behind is turned by as much"
            )
        } else {
            why
        }
    }

    const FLAWS: &'static [Flaw] = &[
        Flaw {
            complaint: COARSE,
            name: "comes near to the angle, but not to a part in a thousand",
            hint: "Is your formula an approximation? If not, halve your steps: does the angle change by more than a part in a thousand? And if you begin twice as far away?",
        },
        Flaw {
            complaint: "equal steps of 1/r up to the turning point",
            name: UNBOUNDED,
            hint: UNBOUNDED_HINT,
        },
        Flaw {
            complaint: "sweeps on its way from infinity",
            name: LEFT_OUT,
            hint: LEFT_OUT_HINT,
        },
        Flaw {
            complaint: "radii before the hole and ends as far behind",
            name: "follows the ray only from a fixed distance before the hole to the same distance behind",
            hint: CUT_HINT,
        },
    ];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "follows the orbit of a stone, by Newton's law",
            hint: "Newton's orbit is a hyperbola, and nothing in it falls in: which term of u″ is only Einstein's?",
            answer: |q| Some(2.0 * (0.5 / q.impact_parameter).atan()),
        },
        Mistake {
            name: "takes 2/b, which is right far away only",
            hint: "At b = 10 the ray is turned by 18 % more than 2/b: what is missing in yours?",
            answer: |q| escapes(q).map(|b| 2.0 / b),
        },
        Mistake {
            name: "takes 2/b, and lets no ray fall in",
            hint: "What becomes of a ray that aims at the middle?",
            answer: |q| Some(2.0 / q.impact_parameter),
        },
        Mistake {
            name: "takes two terms of the series",
            hint: "The series in 1/b has many more terms, and near the photon sphere they all count.",
            answer: |q| escapes(q).map(|b| 2.0 / b + 15.0 * PI / 16.0 / (b * b)),
        },
        Mistake {
            name: "bends light half as much, as Newton would, or only on its way in",
            hint: "In 1919 an eclipse decided between two theories by a factor of two. And the hole bends a ray on its way in and on its way out: is your angle that of both?",
            answer: |q| DeflectionAngle::right(q).map(|angle| 0.5 * angle),
        },
        Mistake {
            name: "takes 1 for the hole's mass, not for its radius",
            hint: "Here the radius is 1, and the mass is half of it: which rays does your hole swallow?",
            answer: |q| deflection(0.5 * q.impact_parameter),
        },
        Mistake {
            name: "returns the whole angle that the ray sweeps",
            hint: "A straight ray sweeps an angle too, as seen from the middle: which one?",
            answer: |q| DeflectionAngle::right(q).map(|angle| angle + PI),
        },
        Mistake {
            name: "takes the angle from infinity to the turning point only",
            hint: "The ray comes, and then goes away again: which of the two ways is in your angle?",
            answer: |q| DeflectionAngle::right(q).map(|angle| 0.5 * (angle - PI)),
        },
        Mistake {
            name: "returns degrees",
            hint: "How many radians has a full turn?",
            answer: |q| DeflectionAngle::right(q).map(f32::to_degrees),
        },
        Mistake {
            name: "folds an angle above π back below π",
            hint: "A ray may go around the hole before it leaves: the angle may be more than π.",
            answer: |q| {
                let angle = DeflectionAngle::right(q)?;
                Some(if angle > PI { 2.0 * PI - angle } else { angle })
            },
        },
        Mistake {
            name: "returns an angle for rays that fall in",
            hint: "Which is the smallest impact parameter of a ray that comes back?",
            answer: |q| DeflectionAngle::right(q).or(Some(PI)),
        },
        Mistake {
            name: "lets rays fall in up to b = 3",
            hint: "Between the rays that fall in and those that get away lies a ray that circles for ever: what is its b?",
            answer: |q| DeflectionAngle::right(q).filter(|_| q.impact_parameter >= 3.0),
        },
        Mistake {
            name: "leaves out whole turns: returns the rest of a division by 2π",
            hint: "A ray may go around the hole before it leaves: is that a part of the angle by which it is turned?",
            answer: |q| DeflectionAngle::right(q).map(|angle| angle % (2.0 * PI)),
        },
        Mistake {
            name: "leaves out half turns: returns the rest of a division by π",
            hint: "A ray may come back to where it came from, and go on around the hole: may the angle be more than π?",
            answer: |q| DeflectionAngle::right(q).map(|angle| angle % PI),
        },
        Mistake {
            name: "takes 1/b, as Newton would far away",
            hint: "In 1919 an eclipse decided between two theories by a factor of two.",
            answer: |q| escapes(q).map(|b| 1.0 / b),
        },
        Mistake {
            name: "takes the angle between the first and the last direction, which is never more than π",
            hint: "A ray may go around the hole before it leaves: which angle does the arc cosine give of a turn and a half?",
            answer: |q| Self::right(q).map(|angle| f64::from(angle).cos().acos() as f32),
        },
        Mistake {
            name: "lets rays fall in that come nearer to the middle than 3√3/2, which is an impact parameter and not a radius",
            hint: "Is the smallest impact parameter of a ray that comes back also how near the ray comes?",
            answer: |q| outside(q, CRITICAL as f32),
        },
        Mistake {
            name: "lets rays fall in that come nearer to the middle than 2, as if 1 were the hole's mass",
            hint: "From how near to the middle can a ray still come back: where is the photon sphere?",
            answer: |q| outside(q, 2.0),
        },
        Mistake {
            name: "lets rays fall in that come nearer to the middle than 3, the radius of the innermost stable circular orbit",
            hint: "From how near to the middle can a ray still come back: where is the photon sphere?",
            answer: |q| outside(q, 3.0),
        },
        Mistake {
            name: "lets rays fall in up to b = 3√3, as if 1 were the hole's mass",
            hint: "Here the radius is 1, and the mass is half of it: which rays does the hole swallow?",
            answer: |q| Self::right(q).filter(|_| f64::from(q.impact_parameter) > 2.0 * CRITICAL),
        },
        Mistake {
            name: "takes b for how near the ray comes to the middle",
            hint: "The hole pulls the ray: does it come as near as a straight one, or nearer?",
            answer: |q| {
                let b = q.impact_parameter;
                if b > 1.5 {
                    deflection(with_nearest(b))
                } else {
                    None
                }
            },
        },
        Mistake {
            name: "takes 4/b, as if 1 were the hole's mass",
            hint: "Here the radius is 1, and the mass is half of it: how large is 4 M/b?",
            answer: |q| escapes(q).map(|b| 4.0 / b),
        },
        Mistake {
            name: "takes twice the angle of a stone",
            hint: "Twice the angle of Newton's law is right far away: is it near the hole?",
            answer: |q| escapes(q).map(|b| 4.0 * (0.5 / b).atan()),
        },
        Mistake {
            name: UNBOUNDED,
            hint: UNBOUNDED_HINT,
            answer: |q| escapes(q).map(|b| sum(b.into(), 1000) as f32),
        },
        Mistake {
            name: LEFT_OUT,
            hint: LEFT_OUT_HINT,
            answer: |q| begun_at(q, 30.0),
        },
        Mistake {
            name: "follows the ray only from 10 radii before the hole to the same distance behind",
            hint: CUT_HINT,
            answer: |q| followed(q, 10.0),
        },
        Mistake {
            name: "follows the ray only from 20 radii before the hole to the same distance behind",
            hint: CUT_HINT,
            answer: |q| followed(q, 20.0),
        },
        Mistake {
            name: "follows the ray only from 30 radii before the hole to the same distance behind",
            hint: CUT_HINT,
            answer: |q| followed(q, 30.0),
        },
        Mistake {
            name: "follows the ray only from 50 radii before the hole to the same distance behind",
            hint: CUT_HINT,
            answer: |q| followed(q, 50.0),
        },
        Mistake {
            name: "follows the ray only from 100 radii before the hole to the same distance behind",
            hint: CUT_HINT,
            answer: |q| followed(q, 100.0),
        },
        Mistake {
            name: "follows the ray only from 1000 radii before the hole to the same distance behind",
            hint: CUT_HINT,
            answer: |q| followed(q, 1000.0),
        },
    ];
}

/// The impact parameter of a ray that does not fall in.
fn escapes(q: &DeflectionAngle) -> Option<f32> {
    Some(q.impact_parameter).filter(|&b| f64::from(b) > CRITICAL)
}

/// The impact parameter of a ray that comes as near to the middle as this: b² = r³/(r − 1).
fn with_nearest(r: f32) -> f32 {
    r / (1.0 - 1.0 / r).sqrt()
}

/// The right angle of a ray that comes no nearer to the middle than this.
fn outside(q: &DeflectionAngle, r: f32) -> Option<f32> {
    DeflectionAngle::right(q).filter(|_| q.impact_parameter > with_nearest(r))
}

fn deflection(impact_parameter: f32) -> Option<f32> {
    DeflectionAngle::right(&DeflectionAngle { impact_parameter })
}

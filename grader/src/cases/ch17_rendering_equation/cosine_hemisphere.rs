//! `cosine_hemisphere`: judged by what its directions have in common.

mod distribution;
mod maps;

use super::farthest;
use crate::cases::ch16_soft_shadows::crossed;
use crate::examine::RANDOM_CASES;
use crate::together::Bounds;
use crate::{Flaw, Graded, Mistake, Verdict, judge, sample, traits};
use distribution::{
    HALVES, MANY, TOO_FLAT, TOO_STEEP, by_equal_steps, crowd, distributed, fills, leans, steps_off,
};
use glam::{Vec3, Vec3Swizzles, vec3};
use maps::{
    chosen, half_crossed, leaning, leaning_back, rather_x, rather_y, rather_z, sine, take_sphere,
    unscaled,
};
use rand::RngExt;
use raybook::math::{basis::Basis, dir3::Dir3, pcg::Pcg};
use raybook_workbook::exercises::ch17_rendering_equation::CosineHemisphere;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

impl Graded for CosineHemisphere {
    fn random(rng: &mut Pcg) -> CosineHemisphere {
        CosineHemisphere {
            normal: sample::direction(rng),
            n: rng.random_range(48..=96),
        }
    }

    /// By what the directions have in common, whichever number makes the radius and from wherever the angle is counted.
    ///
    /// The bounds are errors of the lattice, not of chance. Measured for n from 48 to 96, with the numbers exchanged or
    /// not, any turn around the normal, the disc by rings or by squares (Shirley and Chiu 1997): all means and shares are right to 0.026. A
    /// point of the sphere added to the normal, whose poles lie anywhere, is the worst right method: of 40,000 random normals the
    /// shares are right to 0.071. The nearest mistakes, which spread the angle evenly and which use a number twice, are off by 0.095 in a
    /// share, and by 0.12 in a mean.
    fn judge(q: &CosineHemisphere, _golden: &Vec<Vec3>, got: &Vec<Vec3>) -> Verdict {
        let expected = q.n as usize;
        if got.len() != expected {
            return Err(format!(
                "there are {} directions; {expected} were asked",
                got.len()
            ));
        }
        let basis = Basis::around(q.normal);
        let local = |d: &Vec3| vec3(d.dot(*basis.x), d.dot(*basis.y), d.dot(*basis.z));
        let local: Vec<_> = got.iter().map(local).collect();
        for (d, i) in local.iter().zip(1..) {
            let length = d.length();
            if length.is_nan() || (length - 1.0).abs() > judge::LENGTH {
                return Err(format!(
                    "direction {i} has length {length:.4}; a direction has length 1"
                ));
            }
            if d.z < -judge::LENGTH {
                let below = (-d.z).min(1.0).asin().to_degrees();
                return Err(format!("direction {i} points {below:.1}° into the surface"));
            }
        }
        by_equal_steps(&local)?;
        distributed(&local).map_err(|why| crowd(q, got).unwrap_or(why))
    }

    /// In many answers the errors of their lattices cancel, behind which another power of the cosine hides in each.
    ///
    /// Measured for 8,000 students with 34 cases each and six right methods, the mean of cos θ is at most 0.0046 off, and that of cos²θ
    /// 0.0050. A density of cos^1.1 or cos^0.9 is at least 0.0065 and 0.0076 off.
    fn together(answers: &[(CosineHemisphere, Vec<Vec3>)], _: Bounds) -> Verdict {
        if answers.len() < RANDOM_CASES {
            return Ok(());
        }
        if let Some(why) = answers.iter().find_map(|(q, got)| crowd(q, got)) {
            return Err(why);
        }
        let of_one = |(q, got): &(CosineHemisphere, Vec<Vec3>)| -> Vec<f64> {
            got.iter().map(|d| q.normal.dot(*d).into()).collect()
        };
        let cosines: Vec<f64> = answers.iter().flat_map(of_one).collect();
        let mean = |f: fn(f64) -> f64| {
            cosines.iter().map(|cosine| f(*cosine)).sum::<f64>() / cosines.len() as f64
        };
        let half = |off: &f64| (off.abs() - 0.5).abs() < 0.1;
        if let Some(off) = steps_off(answers).filter(half) {
            let how = if off > 0.0 { "steep" } else { "flat" };
            return Err(format!(
                "all heights are half a step of the lattice too {how}: the sums of cos²θ are {off:.1} off, whatever n is"
            ));
        }
        for (what, mean, exact, bound) in [
            ("cos θ", mean(|cosine| cosine), 2.0 / 3.0, 0.006),
            ("cos²θ", mean(|cosine| cosine * cosine), 0.5, 0.007),
        ] {
            if (mean - exact).abs() > bound {
                return Err(format!(
                    "over all answers, the mean of {what} is {mean:.4} and should be {exact:.4}"
                ));
            }
        }
        answers
            .iter()
            .filter(|(q, _)| q.n >= MANY)
            .try_for_each(|(q, got)| fills(q, got))
    }

    /// Eight questions of n = 1000 directions, whose gaps tell more than their means.
    fn further(rng: &mut Pcg) -> Vec<CosineHemisphere> {
        let normals = (0..8).map(|_| sample::direction(rng));
        normals
            .map(|normal| CosineHemisphere { normal, n: MANY })
            .collect()
    }

    fn traits(q: &CosineHemisphere, got: &Vec<Vec3>) -> Vec<f64> {
        let mut traits = traits::of_directions(got, *q.normal);
        traits.extend(Vec3::AXES.map(|axis| leans(q, got, axis)));
        traits
    }

    const FLAWS: &'static [Flaw] = &[
        Flaw {
            complaint: "directions; ",
            name: "makes another number of directions than asked",
            hint: "Where does your loop begin, and where does it end?",
        },
        Flaw {
            complaint: "has length",
            name: "does not return directions of length 1",
            hint: "How long is a direction? What makes z of x and y?",
        },
        Flaw {
            complaint: "into the surface",
            name: "points into the surface",
            hint: "Is your third axis the normal, or something else? Is your height along the normal positive?",
        },
        Flaw {
            complaint: "at one height",
            name: "puts many directions at one height, as if a number were clamped there",
            hint: "Every point of the square has a height of its own: is your radius or your cosine kept below a limit, or above one? What becomes of the points beyond it?",
        },
        Flaw {
            complaint: "a square of i",
            name: "makes the second number of the square, or the angle, of i² and not of i itself",
            hint: "By how much does the second number of the square grow from one i to the next: always by the same?",
        },
        Flaw {
            complaint: "round the normal",
            name: "leaves wedges round the normal in which there is no direction",
            hint: "From where to where does your angle go? Does every point of the square have an angle of its own, by the number of the task?",
        },
        Flaw {
            complaint: "the mean to",
            name: "leans to one side: seen from above, the directions do not balance around the normal",
            hint: "Has one side more directions, or wider ones? From where to where does your angle go, does the height hang on it, and are your axes perpendicular to the normal?",
        },
        Flaw {
            complaint: "the mean of xy",
            name: "does not go evenly round the normal",
            hint: "Seen from above, are there as many directions to each side?",
        },
        Flaw {
            complaint: "the mean of (x²",
            name: "does not go evenly round the normal",
            hint: "Seen from above, are there as many directions to each side? Are your axes of length 1, and perpendicular?",
        },
        Flaw {
            complaint: "lattice too steep",
            name: TOO_STEEP,
            hint: HALVES,
        },
        Flaw {
            complaint: "lattice too flat",
            name: TOO_FLAT,
            hint: HALVES,
        },
        Flaw {
            complaint: "over all answers, the mean of cos",
            name: "makes directions a little too steep or too flat on average",
            hint: "Which power of the cosine is your density? How long are the two axes beside the normal, whatever the normal is? Has each number of the lattice its ½?",
        },
        Flaw {
            complaint: "the mean of cos",
            name: "makes directions too steep or too flat on average",
            hint: "Points spread evenly over the unit disc and lifted to the sphere: how is the radius made from a number from 0 to 1?",
        },
        Flaw {
            complaint: "above the surface",
            name: "chooses some heights above the surface too often, and others too seldom",
            hint: "Points spread evenly over the unit disc and lifted to the sphere: how is the radius made from a number from 0 to 1? Are your numbers those of the task, or random ones?",
        },
    ];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "takes all directions for equally likely",
            hint: "How many of your directions are less than 30° above the horizon? By the cosine it is a quarter, and uniformly it is a half.",
            answer: |q| chosen(q, |how| how.radius = |u| sine(1.0 - u)),
        },
        Mistake {
            name: "takes a uniform number itself for the radius on the disc",
            hint: "The inner half of a disc's radius holds only a quarter of its area: does it get only a quarter of your points?",
            answer: |q| chosen(q, |how| how.radius = |u| u),
        },
        Mistake {
            name: "spreads the angle to the normal evenly",
            hint: "A ring around the normal gets larger with its angle: do your points crowd where it is small?",
            answer: |q| chosen(q, |how| how.radius = |u| (FRAC_PI_2 * u).sin()),
        },
        Mistake {
            name: "ignores the normal",
            hint: "Try a normal that points down: do your directions follow it?",
            answer: |q| Self::misread(q, |q| q.normal = Dir3::Z),
        },
        Mistake {
            name: "goes only half way round",
            hint: "Add up all your directions: does the sum point along the normal?",
            answer: |q| chosen(q, |how| how.turn = |u| PI * u.y),
        },
        Mistake {
            name: "leaves the disc at a height of 1 − r",
            hint: "How long are your directions? What is the height of a sphere above the point at r?",
            answer: |q| unscaled(q, |how| how.height = |_, r| 1.0 - r),
        },
        Mistake {
            name: "fills the whole sphere",
            hint: "Which of your directions point into the surface?",
            answer: |q| chosen(q, |how| take_sphere(how, |u, _| 1.0 - 2.0 * u)),
        },
        Mistake {
            name: "uses one of the two numbers twice",
            hint: "Draw your directions on the disc: do they fill it, or do they make a spiral?",
            answer: |q| chosen(q, |how| how.turn = |u| TAU * u.x),
        },
        Mistake {
            name: "has a density in proportion to cos²θ",
            hint: "Which power of u is the cosine, if the density shall be cos θ/π?",
            answer: |q| chosen(q, |how| how.radius = |u| sine((1.0 - u).cbrt())),
        },
        Mistake {
            name: "forgets the root in the height over the disc",
            hint: "r² and the height's square add up to 1: how long are your directions?",
            answer: |q| unscaled(q, |how| how.height = |_, r| 1.0 - r * r),
        },
        Mistake {
            name: "forgets the root in the height over the disc, and normalises",
            hint: "r² and the height's square add up to 1: how high is the sphere over the disc at r?",
            answer: |q| chosen(q, |how| how.height = |_, r| 1.0 - r * r),
        },
        Mistake {
            name: "leaves the disc at a height of 1 − r, and normalises",
            hint: "What is the height of a sphere above the point at r?",
            answer: |q| chosen(q, |how| how.height = |_, r| 1.0 - r),
        },
        Mistake {
            name: "adds a point of the unit sphere to twice the normal",
            hint: "Where must the middle of the sphere be, so that the surface touches it?",
            answer: |q| chosen(q, |how| take_sphere(how, |u, _| 3.0 - 2.0 * u)),
        },
        Mistake {
            name: "adds a point of the unit ball, not of its surface, to the normal",
            hint: "Are the points that you add to the normal all one unit long?",
            answer: |q| {
                chosen(q, |how| {
                    how.radius = |u| u.cbrt() * sine(1.0 - 2.0 * u);
                    how.height = |u, _| u.cbrt() * (1.0 - 2.0 * u) + 1.0;
                })
            },
        },
        Mistake {
            name: "goes only a quarter of the way round",
            hint: "Add up all your directions: does the sum point along the normal?",
            answer: |q| chosen(q, |how| how.turn = |u| FRAC_PI_2 * u.y),
        },
        Mistake {
            name: "takes the world's x and y for the two axes beside the normal",
            hint: "Are your three axes perpendicular to each other, whatever the normal is?",
            answer: |q| chosen(q, |how| how.axes = |_| [Vec3::X, Vec3::Y]),
        },
        Mistake {
            name: "does not normalise the axes beside the normal, made by cross products with +y",
            hint: "How long is the cross product of two vectors of length 1 that are not perpendicular?",
            answer: |q| chosen(q, |how| how.axes = |n| crossed(n, rather_y(n))),
        },
        Mistake {
            name: "does not normalise the axes beside the normal, made by cross products with +z",
            hint: "How long is the cross product of two vectors of length 1 that are not perpendicular?",
            answer: |q| chosen(q, |how| how.axes = |n| crossed(n, rather_z(n))),
        },
        Mistake {
            name: "does not normalise the axes beside the normal, made by cross products with +x",
            hint: "How long is the cross product of two vectors of length 1 that are not perpendicular?",
            answer: |q| chosen(q, |how| how.axes = |n| crossed(n, rather_x(n))),
        },
        Mistake {
            name: "does not normalise the axes beside the normal, made by cross products with +y, even close to it",
            hint: "How long is the cross product of two vectors of length 1 that are nearly parallel?",
            answer: |q| {
                chosen(q, |how| {
                    how.axes = |n| crossed(n, if n.y.abs() > 0.99 { Vec3::X } else { Vec3::Y });
                })
            },
        },
        Mistake {
            name: "does not normalise the axes beside the normal, made by cross products with +z, even close to it",
            hint: "How long is the cross product of two vectors of length 1 that are nearly parallel?",
            answer: |q| {
                chosen(q, |how| {
                    how.axes = |n| crossed(n, if n.z.abs() > 0.99 { Vec3::X } else { Vec3::Z });
                })
            },
        },
        Mistake {
            name: "takes +z itself for one of the two axes beside the normal",
            hint: "Are your three axes perpendicular to each other, whatever the normal is?",
            answer: |q| chosen(q, |how| how.axes = |n| leaning(n, rather_z(n))),
        },
        Mistake {
            name: "takes +y itself for one of the two axes beside the normal",
            hint: "Are your three axes perpendicular to each other, whatever the normal is?",
            answer: |q| chosen(q, |how| how.axes = |n| leaning(n, rather_y(n))),
        },
        Mistake {
            name: "adds a point of the upper half of the unit sphere to the normal",
            hint: "Do the points that you add come from all sides? Which of your directions are the flattest?",
            answer: |q| chosen(q, |how| how.radius = |u| (0.5 - 0.5 * u).sqrt()),
        },
        Mistake {
            name: "adds a point of the unit sphere to the normal, and forgets to normalise",
            hint: "How long is the sum of two vectors of length 1?",
            answer: |q| unscaled(q, |how| take_sphere(how, |u, _| 2.0 - 2.0 * u)),
        },
        Mistake {
            name: "takes u for the radius on the disc and √(1 − u) for the height, and normalises",
            hint: "r² and the height's square add up to 1: do they in yours?",
            answer: |q| {
                chosen(q, |how| {
                    how.radius = |u| u;
                    how.height = |u, _| (1.0 - u).sqrt();
                })
            },
        },
        Mistake {
            name: "takes 1 − u² for the cosine",
            hint: "A number itself for the radius, or its root? And where is the root of the height?",
            answer: |q| chosen(q, |how| how.radius = |u| sine(1.0 - u * u)),
        },
        Mistake {
            name: "takes the root of the same number for radius and height, and normalises",
            hint: "r² and the height's square add up to 1: do they in yours?",
            answer: |q| chosen(q, |how| how.height = |u, _| u.sqrt()),
        },
        Mistake {
            name: "takes +y for the normal",
            hint: "Try a normal that points down: do your directions follow it?",
            answer: |q| Self::misread(q, |q| q.normal = Dir3::Y),
        },
        Mistake {
            name: "makes directions around +z, and turns those round that point into the surface",
            hint: "By the cosine of which angle are directions to be chosen: that to +z?",
            answer: |q| {
                let mut all = Self::misread(q, |q| q.normal = Dir3::Z);
                for d in all.iter_mut().filter(|d| d.dot(*q.normal) < 0.0) {
                    *d = -*d;
                }
                all
            },
        },
        Mistake {
            name: "takes the normal for the second axis, where the directions are made around the third",
            hint: "Which of your three axes is up: y, or z?",
            answer: |q| chosen(q, |how| how.taken = |d| d.xzy()),
        },
        Mistake {
            name: "does not normalise the axes beside the normal, made by cross products with the world's axis farthest from it",
            hint: "How long is the cross product of two vectors of length 1 that are not perpendicular?",
            answer: |q| chosen(q, |how| how.axes = |n| crossed(n, farthest(n))),
        },
        Mistake {
            name: "normalises only one of the two axes beside the normal, made by cross products with +y",
            hint: "Each of the three axes has length 1: which of your cross products has it by itself, and which must be normalised?",
            answer: |q| chosen(q, |how| how.axes = |n| half_crossed(n, rather_y(n))),
        },
        Mistake {
            name: "normalises only one of the two axes beside the normal, made by cross products with +z",
            hint: "Each of the three axes has length 1: which of your cross products has it by itself, and which must be normalised?",
            answer: |q| chosen(q, |how| how.axes = |n| half_crossed(n, rather_z(n))),
        },
        Mistake {
            name: "takes +x itself for one of the two axes beside the normal",
            hint: "Are your three axes perpendicular to each other, whatever the normal is?",
            answer: |q| chosen(q, |how| how.axes = |n| leaning(n, rather_x(n))),
        },
        Mistake {
            name: "takes +x itself for one of the two axes beside the normal, and does not normalise",
            hint: "Are your three axes perpendicular to each other, whatever the normal is?",
            answer: |q| unscaled(q, |how| how.axes = |n| leaning_back(n, rather_x(n))),
        },
        Mistake {
            name: "takes +y itself for one of the two axes beside the normal, and does not normalise",
            hint: "Are your three axes perpendicular to each other, whatever the normal is?",
            answer: |q| unscaled(q, |how| how.axes = |n| leaning_back(n, rather_y(n))),
        },
        Mistake {
            name: "takes +z itself for one of the two axes beside the normal, and does not normalise",
            hint: "Are your three axes perpendicular to each other, whatever the normal is?",
            answer: |q| unscaled(q, |how| how.axes = |n| leaning_back(n, rather_z(n))),
        },
        Mistake {
            name: "normalises neither the axes beside the normal, made by cross products, nor the directions",
            hint: "How long is the cross product of two vectors of length 1 that are not perpendicular?",
            answer: |q| unscaled(q, |how| how.axes = |n| crossed(n, rather_x(n))),
        },
        Mistake {
            name: "takes the world's x and y for the two axes beside the normal, and does not normalise",
            hint: "Are your three axes perpendicular to each other, whatever the normal is?",
            answer: |q| unscaled(q, |how| how.axes = |_| [Vec3::X, Vec3::Y]),
        },
        Mistake {
            name: "adds a point of the unit sphere to a vector that is a little longer than the normal, such as 1.1 normals",
            hint: "Where must the middle of the sphere be, so that the surface touches it? How flat is your flattest direction?",
            answer: |q| chosen(q, |how| take_sphere(how, |u, _| 2.1 - 2.0 * u)),
        },
        Mistake {
            name: "adds a point of the unit sphere to a vector between one normal and two, such as 1.5 normals",
            hint: "Where must the middle of the sphere be, so that the surface touches it? How flat is your flattest direction?",
            answer: |q| chosen(q, |how| take_sphere(how, |u, _| 2.5 - 2.0 * u)),
        },
        Mistake {
            name: "adds a point of the unit sphere to a vector that is a little shorter than the normal, such as 0.9 normals",
            hint: "Where must the middle of the sphere be, so that the surface touches it? Which points of yours lie below the surface?",
            answer: |q| chosen(q, |how| take_sphere(how, |u, _| 1.9 - 2.0 * u)),
        },
        Mistake {
            name: "keeps the radius on the disc at 0.9 or below it",
            hint: "Which of your directions are the flattest? What becomes of the points of the disc near its rim?",
            answer: |q| chosen(q, |how| how.radius = |u| u.sqrt().min(0.9)),
        },
        Mistake {
            name: "takes the fourth root of a uniform number for the cosine",
            hint: "Which power of u is the cosine, if the density shall be cos θ/π?",
            answer: |q| chosen(q, |how| how.radius = |u| sine((1.0 - u).powf(0.25))),
        },
    ];
}

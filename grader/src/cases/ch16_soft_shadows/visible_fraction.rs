//! `visible_fraction`: random questions, judge and mistakes.

mod fractions;
mod leanings;
mod misread;

use crate::together::Bounds;
use crate::{Flaw, Graded, Mistake, Verdict, judge, sample, traits};
use fractions::{FINE, exact, finely, hides, sampled, seen, to_the_corners};
use glam::{Vec2, Vec3, vec3};
use misread::{by_balls, less_each, past_each, turned};
use rand::RngExt;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch16_soft_shadows::{Ball, VisibleFraction};
use std::f32::consts::{SQRT_2, TAU};
use std::ops::RangeInclusive;

/// How many samples are asked for: nearly always a number that is no square.
const SAMPLES: RangeInclusive<u32> = 900..=1150;

/// How much smaller a light is that is beside a ball's border.
const TINY: f32 = 0.003;

/// How near a ball's border may be to the way to a light, in radii, with no doubt on which side the way is.
const BESIDE: f32 = 0.01;

impl Graded for VisibleFraction {
    /// The share of a whole light has no edges at which a last digit decides.
    const ULPS: i32 = 0;

    /// Estimates scatter: of 1000 samples a fraction of a half by 3 % of itself, one of a twentieth by 14 %.
    const ALIKE: f32 = 0.25;

    fn random(rng: &mut Pcg) -> VisibleFraction {
        let [width, depth] = [(); 2].map(|()| sample::number(rng, 1.0, 3.0));
        let height = sample::number(rng, 3.0, 5.0);
        let balls = (0..3).map(|i| Ball {
            center: vec3(
                sample::number(rng, -1.0, 1.0),
                // The third is above the light or below the points, where it is in nobody's way, or behind the light and reaches through it.
                if i == 2 {
                    let behind = [height + 1.5, -1.5, height + 0.2];
                    behind[rng.random_range(0..behind.len())]
                } else {
                    sample::number(rng, 0.9, 0.7 * height)
                },
                sample::number(rng, -1.0, 1.0),
            ),
            radius: sample::number(rng, 0.3, 0.8),
        });
        let mut balls: Vec<_> = balls.collect();
        let on_floor = |_| {
            let p = sample::point(rng, 1.8);
            vec3(p.x, 0.0, p.z)
        };
        let mut points: Vec<_> = (0..4).map(on_floor).collect();
        if rng.random_bool(0.15) {
            // Just behind the light, which turns its back there.
            points[3].y = height + sample::number(rng, 0.02, 0.5);
        }
        let [width, depth] = if rng.random_bool(0.25) {
            // Just all or just nothing of a tiny light is seen from the first point: a radius that is 5 % wrong shows.
            just_beside(&mut balls[0], points[0], height, rng.random_bool(0.5));
            [width, depth].map(|side| TINY * side)
        } else {
            [width, depth]
        };
        VisibleFraction {
            corner: vec3(-0.5 * width, height, -0.5 * depth),
            a: width * Vec3::X,
            b: depth * Vec3::Z,
            points,
            balls,
            samples: rng.random_range(SAMPLES),
        }
    }

    /// By Bernstein's inequality, the mean of n samples that are 0 or 1 is off by more than √(2 f(1 − f) L/n) + 2L/(3n)
    /// with a probability below 2 e^(−L): with L = 21 once in 10⁹ points, in a class of 500 less than once in 10⁴ times. Where all of the
    /// light is seen, or nothing of it, chance has no say: there half a sample is too much. And where a part of it is seen, all samples are alike
    /// with the probability (1 − f)ⁿ or fⁿ.
    fn judge(q: &VisibleFraction, _golden: &Vec<f32>, got: &Vec<f32>) -> Verdict {
        const L: f32 = 21.0;
        /// What the lattice that stands for the exact value may be off.
        const LATTICE: f32 = 0.01;
        if got.len() != q.points.len() {
            return Err(format!(
                "there are {} fractions, and should be {}, one per point",
                got.len(),
                q.points.len()
            ));
        }
        let exact = exact(q);
        // A small one hides between the points of a lattice, and the edge of another bulges between two of them by (apart/r)²/8 radii.
        let apart = q.a.length().max(q.b.length()) / FINE as f32;
        let least = q
            .balls
            .iter()
            .map(|ball| ball.radius)
            .fold(f32::INFINITY, f32::min);
        let are_large = least > apart;
        let beside = BESIDE + (apart / least).powi(2) / 8.0;
        let few = of_fewer(got, q.samples);
        for (i, (&f, &fraction)) in exact.iter().zip(got).enumerate() {
            let n = q.samples as f32;
            let at_the_corners = |scale| to_the_corners(q, i, scale);
            let is_certain = || match f {
                1.0 => at_the_corners(1.0 + beside) == 1.0,
                0.0 => at_the_corners(1.0 - beside) == 0.0,
                _ => false,
            };
            let bound = if are_large && fraction != f && is_certain() {
                0.5 / n
            } else {
                (2.0 * f * (1.0 - f) * L / n).sqrt() + 2.0 * L / (3.0 * n) + LATTICE
            };
            let name = format!("the fraction of point {i}");
            // The logarithm of the probability that all samples are alike.
            let alike = n * (1.0 - (f - fraction).abs() + LATTICE).ln();
            let is_part = 0.0 < f && f < 1.0;
            let judged = if is_part && [0.0, 1.0].contains(&fraction) && alike < -L {
                let exactly = if few.is_some() { "" } else { "exactly " };
                Err(format!(
                    "{name} is {exactly}{fraction}, and should be about {f:.2}"
                ))
            } else {
                judge::number_within(&name, "", f, fraction, bound)
            };
            judged.map_err(|why| match few {
                Some(few) => format!("{why}: all fractions are whole parts of {few}, as of {few} samples instead of {n}"),
                None => why,
            })?;
            if !(-1e-4..=1.0 + 1e-4).contains(&fraction) {
                return Err(format!(
                    "{name} is {fraction}, and a fraction is from 0 to 1"
                ));
            }
        }
        Ok(())
    }

    fn together(answers: &[(VisibleFraction, Vec<f32>)], bounds: Bounds) -> Verdict {
        leanings::together(answers, bounds)
    }

    /// One question again and again; then others, for who is in doubt, of which the fractions tell much of the light's edges.
    fn further(rng: &mut Pcg) -> Vec<VisibleFraction> {
        let mut questions = leanings::again();
        questions.resize_with(64, || leanings::telling(|| Self::random(rng)));
        questions
    }

    const FLAWS: &'static [Flaw] = &[
        Flaw {
            complaint: "were left out",
            name: "chooses places near to an edge of the light never or too seldom, at one edge, at two or on all sides, which no single answer shows",
            hint: "From where to where do your two random numbers go: do they come close to 0, and to 1? By what are they multiplied, and what is added to them?",
        },
        Flaw {
            complaint: "near to the point",
            name: "counts samples near to the point more than others, or less, which no single answer shows",
            hint: "The fraction is one of the light's area: does each sample count the same, whatever its distance and its angle at the light?",
        },
        Flaw {
            complaint: "of the light",
            name: "does not choose all places of the light equally often, which no single answer shows",
            hint: "From where to where do your two random numbers go, and is one of them changed afterwards: squared, shifted, or multiplied by something that is nearly 1?",
        },
        Flaw {
            complaint: "chance does not explain",
            name: "sees a few percent too much of the light, or too little, which no single answer shows",
            hint: "How many samples do you take, and by which number do you divide? Is a sample ever counted that is hidden, or left out though it is seen?",
        },
        Flaw {
            complaint: "samples instead of",
            name: "takes fewer samples than are asked for",
            hint: "How many samples do you take for each point, and by how many do you divide? Is a lattice of n by n places n samples, or n · n?",
        },
        Flaw {
            complaint: "times as much as those of so many samples may",
            name: "takes fewer samples than are asked for, or some of them again, which no single answer shows",
            hint: "How many samples do you take for each point, and does each of them have random numbers of its own?",
        },
        Flaw {
            complaint: "is exactly",
            name: "returns exactly 0 or exactly 1 at points from which a part of the light is seen",
            hint: "Is every sample asked at each point, or do you stop early when the first ones are all seen, or all hidden? Are the places spread over all of the light, and is your division one of whole numbers?",
        },
    ];

    fn traits(q: &VisibleFraction, got: &Vec<f32>) -> Vec<f64> {
        let exact = seen(q, 12, |u| u);
        let pairs = || {
            exact
                .iter()
                .zip(got)
                .map(|(a, b)| (f64::from(*a), f64::from(*b)))
        };
        let n = exact.len().max(1) as f64;
        let mean = |f: &dyn Fn(f64, f64) -> f64| pairs().map(|(a, b)| f(a, b)).sum::<f64>() / n;
        vec![
            mean(&|a, b| b - a),
            mean(&|a, b| (b - a).abs()),
            mean(&|a, b| a * b),
            mean(&|_, b| b),
            mean(&|_, b| b * b),
            mean(&|_, b| f64::from(b == 0.0)),
            mean(&|_, b| f64::from(b == 1.0)),
            mean(&|a, b| if a == 0.0 { b } else { 0.0 }),
            traits::distinct(pairs().map(|(_, b)| b)),
            traits::log(1.0 + mean(&|_, b| b.abs())),
        ]
    }

    const EFFORT: usize = 100;

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "samples the middle of the light only",
            hint: "What is the width of your penumbra?",
            answer: |q| sampled(q, |how| how.along = [|_| 0.5; 2]),
        },
        Mistake {
            name: "returns the fraction that is in the dark",
            hint: "How much of the light is seen where nothing is in the way?",
            answer: |q| VisibleFraction::right(q).iter().map(|f| 1.0 - f).collect(),
        },
        Mistake {
            name: "lets the shadow ray go on behind the light",
            hint: "A ball behind the light throws no shadow: where does your ray end?",
            answer: |q| sampled(q, |how| how.end = |_| f32::INFINITY),
        },
        Mistake {
            name: "samples one quarter of the light only",
            hint: "Which points of the light do the numbers from 0 to 1 reach?",
            answer: |q| sampled(q, |how| how.along = [|u| 0.5 * u; 2]),
        },
        Mistake {
            name: "samples one diagonal of the light only",
            hint: "Does each sample have two random numbers of its own?",
            answer: |q| {
                sampled(q, |how| {
                    how.pair = |u| Vec2::splat(u.x + (u.y - 0.5) / 16.0);
                })
            },
        },
        Mistake {
            name: "samples the light's four corners only",
            hint: "In the penumbra, how many different fractions do you get?",
            answer: |q| sampled(q, |how| how.along = [f32::round; 2]),
        },
        Mistake {
            name: "takes every penumbra for full shadow: by one sample in the dark, or by a division of whole numbers",
            hint: "Something in the way of one sample is not in the way of all. And what does your language make of 512/1024, or of 512 // 1024?",
            answer: |q| {
                let all = VisibleFraction::right(q);
                all.iter()
                    .map(|f| if *f < 1.0 { 0.0 } else { 1.0 })
                    .collect()
            },
        },
        Mistake {
            name: "lets a light shine backwards",
            hint: "Where does a × b point, and on which side of the light is the point?",
            answer: |q| {
                let (front, back) = (
                    VisibleFraction::right(q),
                    VisibleFraction::right(&turned(q)),
                );
                front
                    .iter()
                    .zip(back)
                    .map(|(front, back)| front + back)
                    .collect()
            },
        },
        Mistake {
            name: "lets the wrong side of the light shine",
            hint: "Where does a × b point, and on which side of the light is the point?",
            answer: |q| VisibleFraction::right(&turned(q)),
        },
        Mistake {
            name: "returns half of the fraction",
            hint: "How much of the light is seen where nothing is in the way? Do you take as many samples as you divide by?",
            answer: |q| VisibleFraction::right(q).iter().map(|f| 0.5 * f).collect(),
        },
        Mistake {
            name: "returns a count instead of a fraction",
            hint: "From 0, all hidden, to 1, all seen: by what do you divide?",
            answer: |q| finely(q, |how| how.divisor = |_| 1.0),
        },
        Mistake {
            name: "adds two uniform numbers for a place on the light",
            hint: "Is the light's border chosen as often as its middle?",
            answer: |q| {
                sampled(q, |how| {
                    how.along = [|u| {
                        if u < 0.5 {
                            (0.5 * u).sqrt()
                        } else {
                            1.0 - (0.5 * (1.0 - u)).sqrt()
                        }
                    }; 2];
                })
            },
        },
        Mistake {
            name: "asks whether any ball lets the light through, not all",
            hint: "Two balls, one of them in the way: does the light arrive?",
            answer: |q| past_each(q, |_, alone| alone.iter().copied().fold(0.0, f32::max)),
        },
        Mistake {
            name: "asks the first ball only",
            hint: "Any of the balls may be in the way: do you ask them all?",
            answer: |q| Self::misread(q, |q| q.balls.truncate(1)),
        },
        Mistake {
            name: "asks the last ball only",
            hint: "Any of the balls may be in the way: is the answer overwritten by each?",
            answer: |q| {
                Self::misread(q, |q| {
                    q.balls = q.balls.last().cloned().into_iter().collect();
                })
            },
        },
        Mistake {
            name: "forgets the last ball",
            hint: "Where does your loop over the balls end?",
            answer: |q| Self::misread(q, |q| q.balls.truncate(q.balls.len().saturating_sub(1))),
        },
        Mistake {
            name: "samples one half of the light only, along a",
            hint: "Which points of the light do the numbers from 0 to 1 reach, along each side?",
            answer: |q| sampled(q, |how| how.along[0] = |u| 0.5 * u),
        },
        Mistake {
            name: "samples one half of the light only, along b",
            hint: "Which points of the light do the numbers from 0 to 1 reach, along each side?",
            answer: |q| sampled(q, |how| how.along[1] = |u| 0.5 * u),
        },
        Mistake {
            name: "squares the random number along a",
            hint: "Is every part of the light chosen as often as every other?",
            answer: |q| sampled(q, |how| how.along[0] = |u| u * u),
        },
        Mistake {
            name: "squares the random number along b",
            hint: "Is every part of the light chosen as often as every other?",
            answer: |q| sampled(q, |how| how.along[1] = |u| u * u),
        },
        Mistake {
            name: "squares both random numbers",
            hint: "Is every part of the light chosen as often as every other?",
            answer: |q| sampled(q, |how| how.along = [|u| u * u; 2]),
        },
        Mistake {
            name: "lets the random numbers go from −1 to 1",
            hint: "From where to where must your numbers go, so that the corner and the opposite corner are their ends?",
            answer: |q| sampled(q, |how| how.along = [|u| 2.0 * u - 1.0; 2]),
        },
        Mistake {
            name: "looks at the first metre of the way only",
            hint: "The light is farther away than a metre: where does your interval end, and how long is the direction that it belongs to?",
            answer: |q| sampled(q, |how| how.end = |_| 1.0),
        },
        Mistake {
            name: "does not normalise the direction to the light",
            hint: "How long is the vector from the point to the light? Does your sphere take a direction of length 1 for granted?",
            answer: |q| {
                sampled(q, |how| {
                    how.blocks = |ball, from, r, within| {
                        let to_center = ball.center - from;
                        let middle = to_center.dot(r);
                        let free = to_center.length_squared() - ball.radius * ball.radius;
                        let half = (middle * middle - free).sqrt(); // NaN where it misses
                        within.contains(middle - half) || within.contains(middle + half)
                    };
                })
            },
        },
        Mistake {
            name: "takes twice the radius of each ball",
            hint: "You compare a distance from the centre with a number: is that number a radius or a diameter?",
            answer: |q| by_balls(q, |r| 2.0 * r),
        },
        Mistake {
            name: "forgets the first ball",
            hint: "Where does your loop over the balls begin?",
            answer: |q| {
                Self::misread(q, |q| {
                    q.balls = q.balls.split_off(1.min(q.balls.len()));
                })
            },
        },
        Mistake {
            name: "takes the balls for a few percent larger than they are",
            hint: "Which number do you compare with the radius, and is it a distance from the ball's centre? Is anything added to it for safety?",
            answer: |q| by_balls(q, |r| 1.05 * r),
        },
        Mistake {
            name: "takes the balls for a few percent smaller than they are",
            hint: "Which number do you compare with the radius, and is it a distance from the ball's centre? Is anything subtracted from it for safety?",
            answer: |q| by_balls(q, |r| 0.95 * r),
        },
        Mistake {
            name: "takes half the radius of each ball",
            hint: "You compare a distance from the centre with a number: is that number a radius or a diameter?",
            answer: |q| by_balls(q, |r| 0.5 * r),
        },
        Mistake {
            name: "takes the square of a ball's radius for its radius",
            hint: "What do you compare: two lengths, or their squares?",
            answer: |q| by_balls(q, |r| r * r),
        },
        Mistake {
            name: "takes balls behind the point for obstacles",
            hint: "A hit at a negative t is not between the point and the light.",
            answer: |q| sampled(q, |how| how.begin = f32::NEG_INFINITY),
        },
        Mistake {
            name: "does not begin to count anew at each point",
            hint: "The second point's count begins where the first one's ended: how large can its fraction become?",
            answer: |q| {
                let mut sum = 0.0;
                let counted = |f: &f32| {
                    sum += f;
                    sum
                };
                VisibleFraction::right(q).iter().map(counted).collect()
            },
        },
        Mistake {
            name: "takes the light's corner for its middle",
            hint: "From where to where must your numbers go, so that the corner and the opposite corner are their ends?",
            answer: |q| sampled(q, |how| how.along = [|u| u - 0.5; 2]),
        },
        Mistake {
            name: "takes the light's corner for its middle, along a",
            hint: "From where to where must your numbers go, so that the corner and the opposite corner are their ends?",
            answer: |q| sampled(q, |how| how.along[0] = |u| u - 0.5),
        },
        Mistake {
            name: "takes the light's corner for its middle, along b",
            hint: "From where to where must your numbers go, so that the corner and the opposite corner are their ends?",
            answer: |q| sampled(q, |how| how.along[1] = |u| u - 0.5),
        },
        Mistake {
            name: "leaves out a ball whose middle is farther away than the place on the light",
            hint: "A ball's middle is just behind the light: may its surface be before it?",
            answer: |q| {
                finely(q, |how| {
                    how.blocks = |ball, from, r, within| {
                        let is_nearer = from.distance(ball.center) <= r.length();
                        is_nearer && hides(ball, from, r, within)
                    };
                })
            },
        },
        Mistake {
            name: "leaves out a ball whose middle is not beside the way, but before its beginning or behind its end",
            hint: "A ball's middle is just behind the light: may its surface be before it?",
            answer: |q| {
                finely(q, |how| {
                    how.blocks = |ball, from, r, within| {
                        let share = (ball.center - from).dot(r) / r.length_squared();
                        (0.0..=1.0).contains(&share) && hides(ball, from, r, within)
                    };
                })
            },
        },
        Mistake {
            name: "leaves out a ball in which the place on the light is",
            hint: "A place on the light is inside a ball: can it be seen from outside of the ball?",
            answer: |q| {
                finely(q, |how| {
                    how.blocks = |ball, from, r, within| {
                        let is_outside = ball.center.distance(from + r) >= ball.radius;
                        is_outside && hides(ball, from, r, within)
                    };
                })
            },
        },
        Mistake {
            name: "takes twice the square of a ball's radius for its square",
            hint: "What do you compare with the square of the radius, and is there a factor of 2 on one side only?",
            answer: |q| by_balls(q, |r| SQRT_2 * r),
        },
        Mistake {
            name: "takes no more samples at a point when one of them is hidden",
            hint: "One sample is hidden: what do you know of the next ones?",
            answer: |q| {
                // As many in a row as are seen before the first that is not: a whole number.
                let before = |f: f32| ((f / (1.0 - f)).floor() / q.samples as f32).min(1.0);
                let all = VisibleFraction::right(q).into_iter();
                all.map(|f| if f < 1.0 { before(f) } else { f }).collect()
            },
        },
        Mistake {
            name: "takes the root of the random number along a",
            hint: "Is every part of the light chosen as often as every other?",
            answer: |q| sampled(q, |how| how.along[0] = f32::sqrt),
        },
        Mistake {
            name: "takes the root of the random number along b",
            hint: "Is every part of the light chosen as often as every other?",
            answer: |q| sampled(q, |how| how.along[1] = f32::sqrt),
        },
        Mistake {
            name: "takes the root of both random numbers",
            hint: "Is every part of the light chosen as often as every other?",
            answer: |q| sampled(q, |how| how.along = [f32::sqrt; 2]),
        },
        Mistake {
            name: "looks at the first half of the way only",
            hint: "A ball close to the light is in the way too: where does your ray end?",
            answer: |q| sampled(q, |how| how.end = |distance| 0.5 * distance),
        },
        Mistake {
            name: "samples one corner of the light only",
            hint: "In the penumbra, how many different fractions do you get?",
            answer: |q| sampled(q, |how| how.along = [|_| 0.0; 2]),
        },
        Mistake {
            name: "returns twice the fraction",
            hint: "How much of the light is seen where nothing is in the way?",
            answer: |q| finely(q, |how| how.divisor = |samples| 0.5 * samples),
        },
        Mistake {
            name: "takes the middle of the light along b",
            hint: "Does each sample have two random numbers of its own?",
            answer: |q| sampled(q, |how| how.along[1] = |_| 0.5),
        },
        Mistake {
            name: "takes the middle of the light along a",
            hint: "Does each sample have two random numbers of its own?",
            answer: |q| sampled(q, |how| how.along[0] = |_| 0.5),
        },
        Mistake {
            name: "takes the root of a ball's radius for its radius",
            hint: "What do you compare: two lengths, or their squares?",
            answer: |q| by_balls(q, f32::sqrt),
        },
        Mistake {
            name: "divides by one sample more than it takes",
            hint: "Where nothing is in the way, is your fraction exactly 1? How many samples do you take, and by which number do you divide?",
            answer: |q| finely(q, |how| how.divisor = |samples| samples + 1.0),
        },
        Mistake {
            name: "asks from the first point, for all of them",
            hint: "Which point do the ways of the second fraction begin at?",
            answer: |q| {
                Self::misread(q, |q| {
                    let first = q.points.first().copied().unwrap_or_default();
                    q.points.fill(first);
                })
            },
        },
        Mistake {
            name: "multiplies the fractions that each ball alone would leave",
            hint: "A ball within the shadow of another takes no more light away: is a sample hidden twice?",
            answer: |q| past_each(q, |free, alone| free * alone.iter().product::<f32>()),
        },
        Mistake {
            name: "subtracts the share that each ball alone would hide",
            hint: "Where two shadows overlap, how often do you count what is hidden there?",
            answer: |q| past_each(q, less_each),
        },
        Mistake {
            name: "takes the least of the fractions that each ball alone would leave",
            hint: "Two balls may hide two parts of the light: what is left then?",
            answer: |q| past_each(q, |free, alone| alone.iter().copied().fold(free, f32::min)),
        },
        Mistake {
            name: "takes the mean of the fractions that each ball alone would leave",
            hint: "Two balls, one of which hides all of the light: is half of it seen?",
            answer: |q| {
                past_each(q, |free, alone| match alone.len() {
                    0 => free,
                    n => alone.iter().sum::<f32>() / n as f32,
                })
            },
        },
        Mistake {
            name: "returns the mean of all points' fractions for each of them",
            hint: "Is it as dark at every point? Where does your count begin anew, and by what do you divide?",
            answer: |q| {
                let all = Self::right(q);
                let mean = all.iter().sum::<f32>() / all.len().max(1) as f32;
                vec![mean; all.len()]
            },
        },
        Mistake {
            name: "samples one half of the light only, a triangle",
            hint: "The light has four corners: into which of them do your places come?",
            answer: |q| {
                sampled(q, |how| {
                    how.pair = |u| if u.element_sum() > 1.0 { 1.0 - u } else { u }
                })
            },
        },
        Mistake {
            name: "chooses places on a disc inside the light",
            hint: "Do your places come into the light's corners?",
            answer: |q| {
                sampled(q, |how| {
                    how.pair = |u| 0.5 + 0.5 * u.x.sqrt() * Vec2::from_angle(TAU * u.y);
                })
            },
        },
        Mistake {
            name: "multiplies each sample by the cosine at the light",
            hint: "The fraction is one of the light's area: how large is it where nothing is in the way?",
            answer: |q| {
                finely(q, |how| {
                    how.weight = |r, normal| -r.normalize_or_zero().dot(normal.normalize_or_zero());
                })
            },
        },
        Mistake {
            name: "divides by one sample less than it takes",
            hint: "Where nothing is in the way, is your fraction exactly 1? How many samples do you take, and by which number do you divide?",
            answer: |q| finely(q, |how| how.divisor = |samples| (samples - 1.0).max(1.0)),
        },
        Mistake {
            name: "begins to count the samples that are seen at 1",
            hint: "Where nothing of the light is seen, is your fraction exactly 0? Which number do you begin with?",
            answer: |q| finely(q, |how| how.count_from = 1.0),
        },
        Mistake {
            name: "takes any ball on the line to the light for an obstacle, behind the point and behind the light too",
            hint: "A line has no ends: between which two points of it are obstacles?",
            answer: |q| {
                sampled(q, |how| {
                    (how.begin, how.end) = (f32::NEG_INFINITY, |_| f32::INFINITY);
                })
            },
        },
        Mistake {
            name: "subtracts the share that each ball alone would hide, and takes 0 where less is left",
            hint: "Where two shadows overlap, how often do you count what is hidden there?",
            answer: |q| past_each(q, |free, alone| less_each(free, alone).max(0.0)),
        },
        Mistake {
            name: "takes n · n samples, where n is the root of the number that is asked for, rounded down, and divides by the number itself",
            hint: "If 1000 samples are asked for, how many places has your lattice, and by which number do you divide?",
            answer: |q| {
                finely(q, |how| {
                    how.taken = |samples| samples.sqrt().floor().powi(2);
                })
            },
        },
        Mistake {
            name: "takes n · n samples, where n is the root of the number that is asked for, rounded up, and divides by the number itself",
            hint: "If 1000 samples are asked for, how many places has your lattice, and by which number do you divide?",
            answer: |q| finely(q, |how| how.taken = |samples| samples.sqrt().ceil().powi(2)),
        },
        Mistake {
            name: "leaves out a border of the light, such as a tenth on each side",
            hint: "From where to where must your random numbers go, so that all of the light is reached?",
            answer: |q| finely(q, |how| how.along = [|u| 0.1 + 0.8 * u; 2]),
        },
        Mistake {
            name: "leaves out a wide border of the light, such as a fifth on each side",
            hint: "From where to where must your random numbers go, so that all of the light is reached?",
            answer: |q| finely(q, |how| how.along = [|u| 0.2 + 0.6 * u; 2]),
        },
        Mistake {
            name: "goes along a by both random numbers, and never along b",
            hint: "Which side of the light belongs to each of your two random numbers?",
            answer: |q| sampled(q, |how| how.pair = |u| Vec2::new(u.element_sum(), 0.0)),
        },
        Mistake {
            name: "goes along b by both random numbers, and never along a",
            hint: "Which side of the light belongs to each of your two random numbers?",
            answer: |q| sampled(q, |how| how.pair = |u| Vec2::new(0.0, u.element_sum())),
        },
    ];
}

/// The least denominator by which all `fractions` are quotients of whole numbers, if it is so far below `samples` that chance does not
/// explain it: by chance, a fraction that is neither none nor all has it with the probability of the denominator over `samples`.
fn of_fewer(fractions: &[f32], samples: u32) -> Option<u32> {
    /// By chance, all are whole parts of one of these numbers with a probability below this.
    const CHANCE: f32 = 1e-4;
    /// A whole number of samples is as near to one as this.
    const ROUNDING: f32 = 1e-3;
    let between = fractions.iter().filter(|f| **f > 0.0 && **f < 1.0).count();
    let is_of = |few: &u32| {
        let share = *few as f32 / samples as f32;
        if share.powi(between as i32) > CHANCE {
            return false;
        }
        let count = |f: &f32| f * *few as f32;
        let is_whole = |f: &f32| (count(f) - count(f).round()).abs() < ROUNDING;
        fractions.iter().all(is_whole)
    };
    (2..=samples / 8).find(is_of)
}

/// Moves a ball sideways until its border is beside the way from a point to the middle of a tiny light above the origin.
fn just_beside(ball: &mut Ball, from: Vec3, height: f32, is_free: bool) {
    let way = height * Vec3::Y - from;
    let on_the_way = from + ball.center.y / height * way;
    // At the ball, at most 0.7 times as high as the light, the way to a corner is at most 0.7 times half a diagonal away from that to the middle.
    let apart = 1.5 * BESIDE * ball.radius + 0.7 * 0.5 * TINY * 3.0 * SQRT_2;
    let sign = if is_free { 1.0 } else { -1.0 };
    let side = way.cross(Vec3::X).normalize_or(Vec3::Z);
    ball.center = on_the_way + (ball.radius + sign * apart) * side;
}

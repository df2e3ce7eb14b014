//! `concentric_disk`: judged by how its points fill the disc.

mod maps;

use crate::examine::RANDOM_CASES;
use crate::together::{Bounds, widest_gap};
use crate::{Flaw, Graded, Mistake, Relation, Verdict, judge, sample, traits};
use glam::{Vec2, vec2};
use maps::{by_angle, by_quotients, by_sides, half_chord, in_disc, mapped, remainder, shifted};
use rand::RngExt;
use raybook::math::pcg::Pcg;
use raybook::sample::disk::concentric_disk;
use raybook_workbook::exercises::ch19_depth_of_field::ConcentricDisk;
use std::f32::consts::{FRAC_1_SQRT_2, FRAC_PI_2, FRAC_PI_4, TAU};

/// Points that tell how evenly the disc is filled; fewer tell it less well.
const ENOUGH: usize = 200;

/// Whether a disc of radius r has the share r² of the points, but for `bound`.
fn evenly_outwards<'a>(points: impl Iterator<Item = &'a Vec2>, bound: f32) -> Verdict {
    let mut shares: Vec<_> = points.map(|p| p.length_squared()).collect();
    shares.sort_by(f32::total_cmp);
    let n = shares.len() as f32;
    for (i, share) in shares.iter().enumerate() {
        let (below, up_to) = (i as f32 / n, (i + 1) as f32 / n);
        if below - share > bound || share - up_to > bound {
            return Err(format!(
                "the points are not evenly spread: {i} of {n} are nearer to the middle than {:.3}, and about {:.1} should be",
                share.sqrt(),
                n * share
            ));
        }
    }
    Ok(())
}

/// What is wrong if points fill a smaller disc as evenly as they should fill the unit disc.
fn is_smaller<'a>(points: impl Iterator<Item = &'a Vec2> + Clone, bound: f32) -> Option<String> {
    let radius = points.clone().map(|p| p.length()).fold(0.0, f32::max);
    if 1.0 - radius * radius <= bound {
        return None;
    }
    let larger: Vec<_> = points.map(|p| *p / radius).collect();
    let is_even = evenly_outwards(larger.iter(), bound).is_ok();
    is_even.then(|| {
        format!("no point is more than {radius:.3} from the middle: the rim of the unit disc is not reached")
    })
}

/// Whether an arc between any two angles has its share of the points, but for `bound` (Kuiper 1960: wherever angles count from).
fn evenly_round<'a>(points: impl Iterator<Item = &'a Vec2>, bound: f32) -> Verdict {
    let turn = |p: &Vec2| (p.to_angle() / TAU).rem_euclid(1.0);
    let mut turns: Vec<_> = points.map(turn).collect();
    turns.sort_by(f32::total_cmp);
    let n = turns.len() as f32;
    let ahead = |(i, turn): (usize, &f32)| (i + 1) as f32 / n - turn;
    let most = turns.iter().enumerate().map(ahead).fold(0.0, f32::max);
    let least = turns.iter().enumerate().map(ahead).fold(0.0, f32::min);
    if most - least <= bound {
        return Ok(());
    }
    Err(format!(
        "the points are not evenly spread all the way round: an arc of the disc has {:.1} of the {n} points too many",
        n * (most - least)
    ))
}

/// Whether no wedge of the disc is empty, nor a ring of it, of more than this share of its area.
fn fills<'a>(points: impl Iterator<Item = &'a Vec2> + Clone, bound: f64) -> Verdict {
    let turns = || {
        points
            .clone()
            .map(|p| f64::from(p.to_angle()) / f64::from(TAU))
    };
    let again = turns().map(|turn| turn + 1.0);
    let [from, to] = widest_gap(turns().chain(again));
    if to - from > bound {
        return Err(format!(
            "the points are not evenly spread all the way round: none of them is between {:.1}° and {:.1}° from +x",
            360.0 * from,
            360.0 * to
        ));
    }
    let shares = points.map(|p| p.length_squared().min(1.0).into());
    let [from, to] = widest_gap(shares.chain([0.0, 1.0]));
    if to - from > bound {
        return Err(format!(
            "the points are not evenly spread: none that is farther away than {:.4} is nearer to the middle than {:.4}",
            from.sqrt(),
            to.sqrt()
        ));
    }
    Ok(())
}

impl Graded for ConcentricDisk {
    fn random(rng: &mut Pcg) -> ConcentricDisk {
        ConcentricDisk {
            n: rng.random_range(ENOUGH as u32..=256),
            shift: vec2(sample::number(rng, 0.0, 1.0), sample::number(rng, 0.0, 1.0)),
        }
    }

    /// By what the points have in common, whatever the map.
    ///
    /// The bounds are errors of the lattice, not of chance. Measured for 300 questions and eight right methods (the
    /// concentric map, turned and mirrored, and r = √u with either number first, from either end): at most 0.028. The nearest
    /// mistake, the map by arcs of ellipses, is 0.084 off in a share. Fewer points than ENOUGH may be off by more.
    fn judge(q: &ConcentricDisk, _golden: &Vec<Vec2>, got: &Vec<Vec2>) -> Verdict {
        const BOUND: f32 = 0.05;
        let n = q.n as usize;
        if got.len() != n {
            return Err(format!("there are {} points; {n} were asked", got.len()));
        }
        for (p, i) in got.iter().zip(1..) {
            if !p.is_finite() {
                return Err(format!(
                    "point {i} is ({}, {}): is 0 divided by 0?",
                    p.x, p.y
                ));
            }
            if p.length() > 1.0 + judge::LENGTH {
                let r = p.length();
                return Err(format!(
                    "point {i} is {r:.3} from the middle, outside the disc"
                ));
            }
        }
        if n < 2 {
            return Ok(()); // any place of the disc may be meant
        }
        judge::scattered("points", got)?;
        let bound = BOUND * (ENOUGH as f32 / n as f32).sqrt().max(1.0);
        // The radius first: with a wrong one no mean is right, however evenly the points go round.
        evenly_outwards(got.iter(), bound)
            .map_err(|why| is_smaller(got.iter(), bound).unwrap_or(why))?;
        let mean = |f: fn(Vec2) -> f32| got.iter().map(|p| f(*p)).sum::<f32>() / n as f32;
        // Of a few points, the squares and the angles tell nothing.
        let all = if n < ENOUGH { 2 } else { 7 };
        let means = [
            ("x", mean(|p| p.x), 0.0),
            ("y", mean(|p| p.y), 0.0),
            ("x²", mean(|p| p.x * p.x), 0.25),
            ("y²", mean(|p| p.y * p.y), 0.25),
            ("xy", mean(|p| p.x * p.y), 0.0),
            ("cos 4φ", mean(|p| (4.0 * p.to_angle()).cos()), 0.0),
            ("sin 4φ", mean(|p| (4.0 * p.to_angle()).sin()), 0.0),
        ];
        for (what, found, exact) in means.into_iter().take(all) {
            if (found - exact).abs() > bound {
                return Err(format!(
                    "the points are not evenly spread: the mean of {what} is {found:.3}, and should be {exact} (φ is the angle)"
                ));
            }
        }
        Ok(())
    }

    /// Other places in the square have other images in the disc, and the errors of the lattices, which hide a wrong power of the
    /// radius in each answer, cancel in all of them.
    ///
    /// Measured for 2,000 students and five right methods, shares within a radius are at most 0.0033 off, and shares of an arc
    /// 0.0098. A radius of u^0.51 or u^0.49 is at least 0.0068 off, an angle that ends at 0.98 of the whole turn 0.0201. No wedge or ring of
    /// 23 points' share is empty for 1,200 students and four methods; with 3 for π in the concentric map, four wedges of 87 points' share are.
    fn together(answers: &[(ConcentricDisk, Vec<Vec2>)], _: Bounds) -> Verdict {
        const OUTWARDS: f32 = 0.006;
        const ROUND: f32 = 0.018;
        const POINTS: f64 = 45.0;
        for (i, (one, points)) in answers.iter().enumerate() {
            let moved = |(other, others): &&(ConcentricDisk, Vec<Vec2>)| {
                other.n == one.n && other.shift != one.shift && others == points
            };
            if let Some((other, _)) = answers[..i].iter().find(moved) {
                return Err(format!(
                    "the shifts ({}) and ({}) give the same points: where does the shift come in?",
                    other.shift, one.shift
                ));
            }
        }
        let lattices = || answers.iter().filter(|(q, _)| q.n as usize >= ENOUGH);
        if lattices().count() < RANDOM_CASES {
            return Ok(());
        }
        let all = lattices().flat_map(|(_, points)| points);
        evenly_outwards(all.clone(), OUTWARDS)
            .map_err(|why| is_smaller(all.clone(), OUTWARDS).unwrap_or(why))?;
        evenly_round(all.clone(), ROUND)?;
        fills(all.clone(), POINTS / all.count() as f64)
    }

    fn traits(q: &ConcentricDisk, got: &Vec<Vec2>) -> Vec<f64> {
        let mut traits = traits::of_disc(got);
        traits.push(got.len() as f64 / f64::from(q.n.max(1)));
        traits
    }

    const FLAWS: &'static [Flaw] = &[
        Flaw {
            complaint: "where does the shift come in",
            name: "ignores the shift, or one of its coordinates",
            hint: "Change `shift` alone: do your points move?",
        },
        Flaw {
            complaint: "points; ",
            name: "makes another number of points than asked",
            hint: "Where does your loop begin, and where does it end?",
        },
        Flaw {
            complaint: "is 0 divided by 0",
            name: "returns points that are not made of numbers",
            hint: "What does your formula do in the very middle?",
        },
        Flaw {
            complaint: "outside the disc",
            name: "leaves the disc",
            hint: "How large may the radius be?",
        },
        Flaw {
            complaint: "rim of the unit disc is not reached",
            name: "makes a disc that is too small, so that a ring at the rim of the unit disc stays empty",
            hint: "How far from the middle is your farthest point? By what is your radius multiplied or divided?",
        },
        Flaw {
            complaint: "each is to be chosen by itself",
            name: "makes the same point several times",
            hint: "Which of the two numbers does each coordinate depend on?",
        },
        Flaw {
            complaint: "on one line along an axis",
            name: "puts all points on a line",
            hint: "Which of the two numbers does each coordinate depend on?",
        },
        Flaw {
            complaint: "the mean of",
            name: "leans to one side: the points do not balance around the middle",
            hint: "Has one side more points, or farther ones? From where to where does your angle go, and does the radius hang on it?",
        },
        Flaw {
            complaint: "all the way round",
            name: "does not go evenly all the way round",
            hint: "From where to where does your angle go?",
        },
        Flaw {
            complaint: "nearer to the middle than",
            name: "has too many points near the middle, or near the rim",
            hint: "Half of the radius is a quarter of the area: how many points belong there?",
        },
    ];

    const RELATIONS: &'static [Relation<Self>] = &[Relation {
        name: "moved by a thousandth of the square",
        question: |q| ConcentricDisk {
            shift: (q.shift + 0.001).fract(),
            ..q.clone()
        },
    }];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "takes a uniform number itself for the radius",
            hint: "The inner half of the radius holds a quarter of the area: how many of your points?",
            answer: |q| mapped(q, |u| u.x * Vec2::from_angle(TAU * u.y)),
        },
        Mistake {
            name: "returns the points of a square, from −1 to 1",
            hint: "How far from the middle are the square's corners?",
            answer: |q| mapped(q, |u| 2.0 * u - 1.0),
        },
        Mistake {
            name: "returns the square inside the disc",
            hint: "Do your points reach the disc's edge everywhere?",
            answer: |q| mapped(q, |u| FRAC_1_SQRT_2 * (2.0 * u - 1.0)),
        },
        Mistake {
            name: "keeps the angle of each point of the square from −1 to 1, and takes the larger of |x| and |y| for its distance from the middle",
            hint: "On a side of the square, are equal steps equal angles, seen from the middle?",
            answer: |q| {
                mapped(q, |u| {
                    let p = 2.0 * u - 1.0;
                    p.abs().max_element() * p.normalize_or_zero()
                })
            },
        },
        Mistake {
            name: "bends the square's rows and columns into arcs of ellipses, which does not keep areas",
            hint: "It is a disc, but count your points near its middle, and near its edge.",
            answer: |q| {
                mapped(q, |u| {
                    let p = 2.0 * u - 1.0;
                    p * (1.0 - 0.5 * vec2(p.y * p.y, p.x * p.x)).map(f32::sqrt)
                })
            },
        },
        Mistake {
            name: "fills a quarter of the disc",
            hint: "u goes from 0 to 1: from where to where goes a coordinate on the disc?",
            answer: |q| mapped(q, |u| concentric_disk(0.5 + 0.5 * u)),
        },
        Mistake {
            name: "has the wrong angle above and below",
            hint: "On the square's left and right sides your angle is correct: from which axis is the angle measured on the other two?",
            answer: |q| {
                mapped(q, |u| {
                    let (a, b) = (2.0 * u - 1.0).into();
                    let (r, phi) = by_sides(a, b);
                    let wrong = if r == a { phi } else { FRAC_PI_2 - phi };
                    r * Vec2::from_angle(wrong)
                })
            },
        },
        Mistake {
            name: "takes the absolute value for the radius, and fills only half of the disc",
            hint: "On the left and below, what does a negative radius do, or what must the angle do?",
            answer: |q| {
                mapped(q, |u| {
                    let (a, b) = (2.0 * u - 1.0).into();
                    let (r, phi) = by_sides(a, b);
                    if r == 0.0 {
                        Vec2::ZERO
                    } else {
                        r.abs() * Vec2::from_angle(phi)
                    }
                })
            },
        },
        Mistake {
            name: "divides 0 by 0 in the middle",
            hint: "Which angle has the middle of the square?",
            answer: |q| {
                mapped(q, |u| {
                    let (a, b) = (2.0 * u - 1.0).into();
                    let (r, phi) = by_sides(a, b);
                    r * Vec2::from_angle(phi)
                })
            },
        },
        Mistake {
            name: "makes a disc of half the radius",
            hint: "The unit disc has the radius 1: which points are at its edge?",
            answer: |q| mapped(q, |u| 0.5 * concentric_disk(u)),
        },
        Mistake {
            name: "takes the cube root for the radius",
            hint: "In a disc, how does the area within r grow: with r² or with r³?",
            answer: |q| mapped(q, |u| u.x.cbrt() * Vec2::from_angle(TAU * u.y)),
        },
        Mistake {
            name: "uses one number for radius and angle",
            hint: "Do your points fill the disc, or a spiral in it?",
            answer: |q| mapped(q, |u| u.x.sqrt() * Vec2::from_angle(TAU * u.x)),
        },
        Mistake {
            name: "goes only half way round",
            hint: "From where to where does your angle go?",
            answer: |q| mapped(q, |u| u.x.sqrt() * Vec2::from_angle(0.5 * TAU * u.y)),
        },
        Mistake {
            name: "has the quotients of both coordinates upside down in the angle",
            hint: "Near an axis the angle is near 0 there: which of the two coordinates is the small one?",
            answer: |q| {
                mapped(q, |u| {
                    let (a, b) = (2.0 * u - 1.0).into();
                    let quotient =
                        |over: f32, under: f32| if under == 0.0 { 0.0 } else { over / under };
                    if a.abs() > b.abs() {
                        a * Vec2::from_angle(FRAC_PI_4 * quotient(a, b))
                    } else {
                        b * Vec2::from_angle(FRAC_PI_2 - FRAC_PI_4 * quotient(b, a))
                    }
                })
            },
        },
        Mistake {
            name: "forgets π/2 in the angle above and below",
            hint: "Straight above the middle, how large is the angle from the x axis?",
            answer: |q| {
                mapped(q, |u| {
                    let (a, b) = (2.0 * u - 1.0).into();
                    if a.abs() > b.abs() {
                        a * Vec2::from_angle(FRAC_PI_4 * b / a)
                    } else if b == 0.0 {
                        Vec2::ZERO
                    } else {
                        b * Vec2::from_angle(FRAC_PI_4 * a / b)
                    }
                })
            },
        },
        Mistake {
            name: "does not bring back into the square what the shift moves out of it",
            hint: "The points are fractional parts: what becomes of a coordinate above 1?",
            answer: |q| {
                in_disc(q, |how| {
                    how.points = |q| shifted(q, |moved, right| vec2(moved.x, right.y));
                })
            },
        },
        Mistake {
            name: "clamps to the square what the shift moves out of it",
            hint: "Many of your points are at the edge of the square: on which side does a point come in that leaves it on the right?",
            answer: |q| {
                in_disc(q, |how| {
                    how.points =
                        |q| shifted(q, |moved, right| vec2(moved.x.clamp(0.0, 1.0), right.y));
                })
            },
        },
        Mistake {
            name: "clamps both coordinates to the square after the shift",
            hint: "Many of your points are at the edge of the square: on which side does a point come in that leaves it on the right?",
            answer: |q| {
                in_disc(q, |how| {
                    how.points = |q| shifted(q, |moved, _| moved.clamp(Vec2::ZERO, Vec2::ONE));
                })
            },
        },
        Mistake {
            name: "clamps both coordinates to the square after the shift (by radius and angle)",
            hint: "Many of your points are at the rim of the disc: on which side does a point come in that leaves the square on the right?",
            answer: |q| {
                in_disc(q, |how| {
                    how.points = |q| shifted(q, |moved, _| moved.clamp(Vec2::ZERO, Vec2::ONE));
                    how.map = by_angle;
                })
            },
        },
        Mistake {
            name: "clamps to the square what the shift moves out of it (by radius and angle)",
            hint: "Many of your points are at the rim of the disc: on which side does a point come in that leaves the square on the right?",
            answer: |q| {
                in_disc(q, |how| {
                    how.points =
                        |q| shifted(q, |moved, right| vec2(moved.x.clamp(0.0, 1.0), right.y));
                    how.map = by_angle;
                })
            },
        },
        Mistake {
            name: "does not bring back into the square what the shift moves out of it (by radius and angle)",
            hint: "The points are fractional parts: what becomes of a coordinate above 1, and of your radius?",
            answer: |q| {
                in_disc(q, |how| {
                    how.points = |q| shifted(q, |moved, right| vec2(moved.x, right.y));
                    how.map = by_angle;
                })
            },
        },
        Mistake {
            name: "leaves out the points that the shift moves out of the square on the right or on the left",
            hint: "How many points are asked? On which side does a point come in that leaves the square on the right?",
            answer: |q| {
                in_disc(q, |how| {
                    how.points = |q| {
                        let points = shifted(q, |moved, right| vec2(moved.x, right.y));
                        let is_inside = |u: &Vec2| (0.0..1.0).contains(&u.x);
                        points.into_iter().filter(is_inside).collect()
                    };
                })
            },
        },
        Mistake {
            name: "leaves out the points of the square from −1 to 1 that are outside of the disc",
            hint: "How many points are asked? Where in the disc does a corner of the square belong?",
            answer: |q| {
                in_disc(q, |how| {
                    how.points = |q| {
                        let is_inside = |u: &Vec2| (2.0 * *u - 1.0).length() <= 1.0;
                        q.points().filter(is_inside).collect()
                    };
                    how.map = |u| 2.0 * u - 1.0;
                })
            },
        },
        Mistake {
            name: "takes the square of a uniform number for the radius",
            hint: "The inner half of the radius holds a quarter of the area: how many of your points?",
            answer: |q| mapped(q, |u| u.x * u.x * Vec2::from_angle(TAU * u.y)),
        },
        Mistake {
            name: "normalises all points, and so puts them on the rim",
            hint: "How many of your points are nearer to the middle than half of the radius?",
            answer: |q| mapped(q, |u| (2.0 * u - 1.0).normalize_or_zero()),
        },
        Mistake {
            name: "moves the points of the square that are outside of the disc to its rim",
            hint: "How many of your points are on the rim itself?",
            answer: |q| mapped(q, |u| (2.0 * u - 1.0).clamp_length_max(1.0)),
        },
        Mistake {
            name: "takes a uniform number itself for the angle, without 2π",
            hint: "From where to where does your angle go?",
            answer: |q| mapped(q, |u| u.x.sqrt() * Vec2::from_angle(u.y)),
        },
        Mistake {
            name: "compares both coordinates with their signs, not by their absolute values",
            hint: "(−0.9, 0.1) is on the left: which of the two coordinates is its radius?",
            answer: |q| {
                mapped(q, |u| {
                    let (a, b) = (2.0 * u - 1.0).into();
                    let quotient =
                        |over: f32, under: f32| if under == 0.0 { 0.0 } else { over / under };
                    if a > b {
                        a * Vec2::from_angle(FRAC_PI_4 * quotient(b, a))
                    } else {
                        b * Vec2::from_angle(FRAC_PI_2 - FRAC_PI_4 * quotient(a, b))
                    }
                })
            },
        },
        Mistake {
            name: "chooses x evenly, and y evenly on the chord of the disc there",
            hint: "At the left and the right of the disc a chord is short: does it hold as many of your points as one through the middle?",
            answer: |q| {
                mapped(q, |u| {
                    let p = 2.0 * u - 1.0;
                    vec2(p.x, p.y * half_chord(p.x))
                })
            },
        },
        Mistake {
            name: "chooses y evenly, and x evenly on the chord of the disc there",
            hint: "At the top and the bottom of the disc a chord is short: does it hold as many of your points as one through the middle?",
            answer: |q| {
                mapped(q, |u| {
                    let p = 2.0 * u - 1.0;
                    vec2(p.x * half_chord(p.y), p.y)
                })
            },
        },
        Mistake {
            name: "makes circles of squircles along straight lines, which does not keep areas",
            hint: "It is a disc, but count your points near its middle, and near its edge.",
            answer: |q| {
                mapped(q, |u| {
                    let p = 2.0 * u - 1.0;
                    p.x.hypot(p.y * half_chord(p.x)) * p.normalize_or_zero()
                })
            },
        },
        Mistake {
            name: "takes a remainder that is negative for the fractional part",
            hint: "In your language, what is the remainder of −0.1 divided by 1? On which side does a point come in that leaves the square on the left?",
            answer: |q| {
                in_disc(q, |how| {
                    how.points = |q| shifted(q, |moved, _| remainder(moved));
                })
            },
        },
        Mistake {
            name: "takes a remainder for the fractional part, and 0 where it is negative",
            hint: "In your language, what is the remainder of −0.1 divided by 1? On which side does a point come in that leaves the square on the left?",
            answer: |q| {
                in_disc(q, |how| {
                    how.points = |q| shifted(q, |moved, _| remainder(moved).max(Vec2::ZERO));
                })
            },
        },
        Mistake {
            name: "takes a remainder for the fractional part, and 0 where it is negative (by radius and angle)",
            hint: "In your language, what is the remainder of −0.1 divided by 1? On which side does a point come in that leaves the square on the left?",
            answer: |q| {
                // Elsewhere it is one right answer or the other.
                if q.shift.x >= 0.0 && q.shift.y >= 0.0 {
                    return Self::right(q);
                }
                in_disc(q, |how| {
                    how.points = |q| shifted(q, |moved, _| remainder(moved).max(Vec2::ZERO));
                    how.map = by_angle;
                })
            },
        },
        Mistake {
            name: "squares the quotient in the angle above and below",
            hint: "On the square's upper side, are equal steps equal angles? What is the quotient a/b halfway to a corner, and the angle there?",
            answer: |q| mapped(q, |u| by_quotients(u, |v| v, |v| v * v.abs())),
        },
        Mistake {
            name: "squares the quotient in the angle on the left and on the right",
            hint: "On the square's right side, are equal steps equal angles? What is the quotient b/a halfway to a corner, and the angle there?",
            answer: |q| mapped(q, |u| by_quotients(u, |v| v * v.abs(), |v| v)),
        },
        Mistake {
            name: "squares the quotients in both angles",
            hint: "On a side of the square, are equal steps equal angles? What is the quotient halfway to a corner, and the angle there?",
            answer: |q| mapped(q, |u| by_quotients(u, |v| v * v.abs(), |v| v * v.abs())),
        },
        Mistake {
            name: "takes the quotient itself for the angle, without π/4",
            hint: "In a corner of the square the quotient is 1: which angle has the corner?",
            answer: |q| mapped(q, |u| by_quotients(u, |v| v / FRAC_PI_4, |v| v / FRAC_PI_4)),
        },
    ];
}

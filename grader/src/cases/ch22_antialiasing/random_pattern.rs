//! `random_pattern`: random questions, judge and mistakes.

use super::points;
use crate::together::Bounds;
use crate::{Flaw, Graded, Mistake, Verdict, judge, together, traits};
use glam::{Vec2, vec2};
use rand::RngExt;
use raybook::math::pcg::{self, Pcg};
use raybook::sample::pattern::{jittered, regular_grid, rows};
use raybook_workbook::exercises::ch22_antialiasing::RandomPattern;
use std::collections::HashSet;

/// n points, each from two numbers, which are those of a right point.
fn each(q: &RandomPattern, point: impl Fn(Vec2) -> Vec2) -> Vec<Vec2> {
    q.right().into_iter().map(point).collect()
}

/// n points, each from its number and two numbers.
fn along(q: &RandomPattern, point: impl Fn(usize, Vec2) -> Vec2) -> Vec<Vec2> {
    let all = q.right().into_iter().enumerate();
    all.map(|(i, u)| point(i, u)).collect()
}

/// Fewer points than these tell little of how they are distributed.
const ENOUGH: usize = 100;

/// As many points as show that a tenth of the square is left out: the deviation is 0.1, and may be 3.16/√n.
const LONG: usize = 1000;

/// Whether a number of a point comes again in the other coordinate of the next point.
fn uses_each_once(answers: &[(RandomPattern, Vec<Vec2>)]) -> Verdict {
    /// What single precision and printing round.
    const SAME: f32 = 2e-6;
    for (one, other) in [(1, 0), (0, 1)] {
        let pairs = || answers.iter().flat_map(|(_, points)| points.windows(2));
        let again = pairs().filter(|two| (two[0][one] - two[1][other]).abs() < SAME);
        // By chance it is one pair in 250,000.
        if 2 * again.count() > pairs().count() {
            let names = ["x", "y"];
            return Err(format!(
                "{} of most points is {} of the point after them: a random number is used in two points",
                names[one], names[other]
            ));
        }
    }
    Ok(())
}

impl Graded for RandomPattern {
    fn random(rng: &mut Pcg) -> RandomPattern {
        RandomPattern {
            n: rng.random_range(150..=400),
            seed: rng.random(),
        }
    }

    fn judge(q: &RandomPattern, _golden: &Vec<Vec2>, got: &Vec<Vec2>) -> Verdict {
        points::in_square(q.n as usize, got)?;
        if got.len() >= ENOUGH {
            few_places(got)?; // before equal points are taken for the same random numbers
        }
        judge::scattered("points", got)?;
        let bounds = if got.len() >= LONG {
            Bounds::LONG
        } else {
            Bounds::CHANCE
        };
        points::uniform("x", got.iter().map(|p| p.x), bounds)?;
        points::uniform("y", got.iter().map(|p| p.y), bounds)?;
        points::independent("x and y", got.iter().copied(), Bounds::CHANCE)?;
        if got.len() < ENOUGH {
            return Ok(()); // too few to tell more
        }
        points::by_chance("x", got.iter().map(|p| p.x))?;
        points::by_chance("y", got.iter().map(|p| p.y))?;
        crowds(got)
    }

    fn together(answers: &[(RandomPattern, Vec<Vec2>)], bounds: Bounds) -> Verdict {
        together::seeded(answers, |_, _| true, |q| q.seed)?;
        uses_each_once(answers)?;
        let lists: Vec<_> = answers.iter().map(|(_, points)| points).collect();
        points::together(&lists, ["x", "y"], "x and y", bounds)?;
        let names = [
            "x of one point",
            "y of one point",
            "a coordinate of one point",
        ];
        points::serial(&lists, names, "the next", bounds)
    }

    /// Within the visible cases' limit of n.
    fn further(rng: &mut Pcg) -> Vec<RandomPattern> {
        let seeds = together::seeds(rng, 512);
        seeds.map(|seed| RandomPattern { n: 1000, seed }).collect()
    }

    fn traits(q: &RandomPattern, got: &Vec<Vec2>) -> Vec<f64> {
        let points: Vec<_> = got.iter().map(|p| p.as_dvec2()).collect();
        let mut traits = traits::of_square(&points);
        traits.push(got.len() as f64 / f64::from(q.n.max(1)));
        // Even steps make narrow strips even, of which the eight parts of a side know nothing.
        let strips = q.n / 4;
        let uneven = [0, 1].map(|axis| {
            let along = points.iter().map(|p| p[axis]);
            0.5 * traits::unevenness(along, strips)
        });
        traits.extend(uneven);
        // Few places show in no part of the square: in how many different numbers there are.
        let different = [0, 1].map(|axis| {
            let numbers: HashSet<_> = got.iter().map(|p| p[axis].to_bits()).collect();
            numbers.len() as f64 / got.len().max(1) as f64
        });
        traits.extend(different);
        traits
    }

    const FIXED: &'static [&'static str] = &["seed"];

    const FLAWS: &'static [Flaw] = &[
        points::COUNT,
        points::OUTSIDE,
        points::SAME,
        points::LINE,
        points::UNEVEN,
        points::TOGETHER,
        Flaw {
            complaint: "its mirror image",
            name: "takes with each point its mirror image too, x to 1 − x or y to 1 − y",
            hint: "Independent points know nothing of each other: of how many random numbers do you make how many points?",
        },
        Flaw {
            complaint: "at even steps",
            name: "puts a coordinate at even steps: each number has a step of its own",
            hint: "Does a point know where the others are? Independent numbers make crowds and leave gaps.",
        },
        Flaw {
            complaint: "points have only",
            name: "chooses from a few places only",
            hint: "How many different values can each of your coordinates have?",
        },
        Flaw {
            complaint: "too even to be independent",
            name: "spreads the points more evenly than chance does",
            hint: "Does a point know where the others are? Independent points make crowds and leave gaps.",
        },
        Flaw {
            complaint: "do not fill the square",
            name: "crowds the points, though x and y by themselves are even: they depend on each other, or on the point before",
            hint: "Of how many random numbers do you make a point, and does any of them go into another coordinate or point too?",
        },
        Flaw {
            complaint: "in the square's corners",
            name: "leaves out the corners",
            hint: "May a point lie in a corner of the square?",
        },
        points::SEED,
        points::PART_OF_SEED,
        points::SEED_OR_PART,
        points::SEED_OF_ONE,
        Flaw {
            complaint: "is used in two points",
            name: "takes a coordinate of each point for the other coordinate of the next one: y for x, or x for y",
            hint: "How many random numbers do n points need, and how many do you draw?",
        },
        points::SERIAL,
    ];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "uses one number for both coordinates",
            hint: "Draw your points: do they fill the square, or lie on a line?",
            answer: |q| each(q, |u| vec2(u.x, u.x)),
        },
        Mistake {
            name: "makes a grid",
            hint: "Which of your points would be elsewhere with another seed?",
            answer: |q| rows::in_rows(q.n as usize, regular_grid::regular_grid),
        },
        Mistake {
            name: "jitters: puts a point into each cell of a grid",
            hint: "May each of your points fall anywhere, or only in its own cell? Independent points leave gaps and make crowds.",
            answer: |q| {
                let rng = &mut pcg::stream(22, q.seed.into());
                rows::in_rows(q.n as usize, |columns, rows| {
                    jittered::jittered(columns, rows, rng)
                })
            },
        },
        Mistake {
            name: "starts the generator again for every point",
            hint: "How many different points do you have?",
            answer: |q| {
                let all = q.right();
                vec![all.first().copied().unwrap_or_default(); all.len()]
            },
        },
        Mistake {
            name: "goes from −1 to 1",
            hint: "In which range are your numbers, and in which range is the square?",
            answer: |q| each(q, |u| 2.0 * u - 1.0),
        },
        Mistake {
            name: "takes the mean of two random numbers for each coordinate, which crowds in the middle",
            hint: "The sum of two uniform numbers is not uniform: how many of your points are in the middle ninth of the square?",
            answer: |q| {
                let twice_as_many = Self::misread(q, |q| q.n *= 2);
                let twos = twice_as_many.chunks_exact(2);
                twos.map(|two| two[0].midpoint(two[1])).collect()
            },
        },
        Mistake {
            name: "fills a disc",
            hint: "Is a corner of the square as likely as its middle?",
            answer: |q| {
                each(q, |u| {
                    0.5 + 0.5 * u.x.sqrt() * Vec2::from_angle(std::f32::consts::TAU * u.y)
                })
            },
        },
        Mistake {
            name: "takes one of sixteen places along each axis",
            hint: "How many different values do your coordinates have? Whole numbers divided by 16 are not all numbers.",
            answer: |q| each(q, |u| (16.0 * u).floor() / 16.0),
        },
        Mistake {
            name: "takes one of 256 places along each axis, as a byte tells them apart",
            hint: "How many different values do your coordinates have? Whole numbers divided by 256 are not all numbers.",
            answer: |q| each(q, |u| (256.0 * u).floor() / 256.0),
        },
        Mistake {
            name: "squares its numbers",
            hint: "Which share of your x is below a half?",
            answer: |q| each(q, |u| u * u),
        },
        Mistake {
            name: "fills nine tenths of the square",
            hint: "What is the largest of all your coordinates?",
            answer: |q| each(q, |u| 0.9 * u),
        },
        Mistake {
            name: "squares its numbers for x only",
            hint: "Which share of your x is below a half, and which of your y?",
            answer: |q| each(q, |u| vec2(u.x * u.x, u.y)),
        },
        Mistake {
            name: "squares its numbers for y only",
            hint: "Which share of your y is below a half, and which of your x?",
            answer: |q| each(q, |u| vec2(u.x, u.y * u.y)),
        },
        Mistake {
            name: "puts x at even steps, and only y at random",
            hint: "Is the x of a point known before it is chosen? Then it is not random.",
            answer: |q| along(q, |i, u| vec2((i as f32 + 0.5) / q.n as f32, u.y)),
        },
        Mistake {
            name: "puts y at even steps, and only x at random",
            hint: "Is the y of a point known before it is chosen? Then it is not random.",
            answer: |q| along(q, |i, u| vec2(u.x, (i as f32 + 0.5) / q.n as f32)),
        },
        Mistake {
            name: "makes one point too few",
            hint: "Where does your loop begin, and where does it end?",
            answer: |q| {
                let mut all = q.right();
                all.pop();
                all
            },
        },
        Mistake {
            name: "makes one point too many",
            hint: "Where does your loop begin, and where does it end?",
            answer: |q| Self::misread(q, |q| q.n += 1),
        },
        Mistake {
            name: "fills one half of the square only, along x",
            hint: "From where to where do your random numbers go, along each axis?",
            answer: |q| each(q, |u| vec2(0.5 * u.x, u.y)),
        },
        Mistake {
            name: "fills one half of the square only, along y",
            hint: "From where to where do your random numbers go, along each axis?",
            answer: |q| each(q, |u| vec2(u.x, 0.5 * u.y)),
        },
        Mistake {
            name: "takes the root of its numbers",
            hint: "Which share of your x is below a half?",
            answer: |q| each(q, |u| vec2(u.x.sqrt(), u.y.sqrt())),
        },
        Mistake {
            name: "takes the root of its numbers for x only",
            hint: "Which share of your x is below a half, and which of your y?",
            answer: |q| each(q, |u| vec2(u.x.sqrt(), u.y)),
        },
        Mistake {
            name: "takes the root of its numbers for y only",
            hint: "Which share of your y is below a half, and which of your x?",
            answer: |q| each(q, |u| vec2(u.x, u.y.sqrt())),
        },
        Mistake {
            name: "refuses points that are near others",
            hint: "Independent points know nothing of each other: may two of them be close together?",
            answer: |q| {
                let rng = &mut pcg::stream(22, q.seed.into());
                let least = 0.5 / (q.n as f32).sqrt();
                let mut points: Vec<Vec2> = Vec::new();
                while points.len() < q.n as usize {
                    let p = vec2(rng.random(), rng.random());
                    if points.iter().all(|other| other.distance(p) >= least) {
                        points.push(p);
                    }
                }
                points
            },
        },
        Mistake {
            name: "takes whole numbers, 0 or 1",
            hint: "In how many different places of the square are your points?",
            answer: |q| each(q, Vec2::round),
        },
        Mistake {
            name: "takes one of a hundred places along each axis",
            hint: "How many different values do your coordinates have? Numbers that are rounded to two digits are not all numbers.",
            answer: |q| each(q, |u| (100.0 * u).floor() / 100.0),
        },
        Mistake {
            name: "fills a triangle: one half of the square, up to its diagonal",
            hint: "Is a point near the corner (1, 1) as likely as one near (0, 0)?",
            answer: |q| each(q, |u| if u.element_sum() > 1.0 { 1.0 - u } else { u }),
        },
        Mistake {
            name: "takes 1 − x for y",
            hint: "Draw your points: do they fill the square, or lie on a line?",
            answer: |q| each(q, |u| vec2(u.x, 1.0 - u.x)),
        },
    ];
}

/// Equal coordinates are a coincidence of one in millions; but of numbers that are used again there may be any number.
fn few_places(points: &[Vec2]) -> Verdict {
    /// Fewer different values are a single point that comes again; whoever rounds leaves more of them.
    const VALUES: usize = 4;
    for (axis, name) in ["x", "y"].into_iter().enumerate() {
        let mut all: Vec<_> = points.iter().map(|p| p[axis]).collect();
        all.sort_by(f32::total_cmp);
        all.dedup();
        // 1000 points of which many print only four digits have still nine different ones in ten.
        if all.len() >= VALUES && 4 * all.len() < 3 * points.len() {
            return Err(format!(
                "the {} points have only {} different {name}",
                points.len(),
                all.len()
            ));
        }
    }
    Ok(())
}

/// Independent points make crowds and leave gaps: of √n × √n cells, a share of 1/e is empty, and as many have two or more
/// points. And a corner is as good a place as any.
///
/// The number of empty cells has the standard deviation √(n (1/e − 2/e²)) = 0.31 √n: the bounds are 6.5 of them.
fn crowds(points: &[Vec2]) -> Verdict {
    let side = (points.len() as f32).sqrt().floor();
    let mut counts = vec![0_u32; (side * side) as usize];
    for p in points {
        let cell = (side * *p).floor().min(Vec2::splat(side - 1.0));
        counts[(cell.y * side + cell.x) as usize] += 1;
    }
    let empty = counts.iter().filter(|&&count| count == 0).count() as f32;
    let cells = side * side;
    let expected = cells * (-(points.len() as f32) / cells).exp();
    let bound = 6.5 * 0.31 * side;
    if empty < expected - bound {
        return Err(format!(
            "of {cells} cells only {empty} are empty, where chance would leave about {expected:.0}: the points are too even to be independent"
        ));
    }
    if empty > expected + bound {
        return Err(format!(
            "of {cells} cells {empty} are empty, where chance would leave about {expected:.0}: the points do not fill the square"
        ));
    }
    // Outside the inscribed circle is the share 1 − π/4 = 0.215; of 150 points 32, and less than five with a probability of 1e-10.
    let corner = |p: &&Vec2| p.distance(Vec2::splat(0.5)) > 0.5;
    let found = points.iter().filter(corner).count() as f32;
    let share = 0.215 * points.len() as f32;
    if found < 0.15 * share {
        return Err(format!(
            "only {found} points are in the square's corners, outside the circle in it, where chance would put about {share:.0}"
        ));
    }
    Ok(())
}

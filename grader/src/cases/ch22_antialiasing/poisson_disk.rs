//! `poisson_disk`: random questions, judge and mistakes.

use super::points;
use crate::together::Bounds;
use crate::upon::changed;
use crate::{Flaw, Graded, Mistake, Verdict, together, traits};
use glam::{UVec2, Vec2, vec2};
use rand::RngExt;
use raybook::inside::{Neighbours, Space};
use raybook::math::pcg::{self, Pcg};
use raybook::sample::pattern::{jittered, random_pattern};
use raybook_workbook::exercises::ch22_antialiasing::PoissonDisk;

/// Two points may be nearer by this share of the distance: what `f32` and printing round.
const ROUNDING: f32 = 1e-4;

/// So large a share of the square may have room for another point. Bridson's method with 30 tries leaves up to 4 %; darts thrown until a
/// thousand in a row miss leave less than 1 %.
const ROOM: f32 = 0.10;

/// And so large a one beside this number of points, where chance has less to say: Bridson's method leaves 0.3 % there on average, with 10 tries
/// 1.5 %, and 2/d² darts, of which most miss, 5.6 %.
const ROOM_BESIDE_MANY: f32 = 0.04;
const MANY: usize = 100;

/// Places that are probed for room, along each side.
const PROBES: u32 = 96;

/// More points than this, times (1 + d)²/d², are a lattice: chance finds 0.6 of that, squares 1, and a honeycomb 1.15.
const CROWDED: f32 = 0.85;

/// Darts that are thrown in vain before a mistaken program ends, and points after which it does.
const PATIENCE: u32 = 1000;
const MOST: usize = 2000;

/// How points are chosen; one field wrong is a mistake.
#[derive(Clone, Copy)]
struct How {
    /// How far apart points are kept.
    distance: f32,
    /// How many darts in a row must miss before it ends.
    patience: u32,
    /// No dart is kept that is nearer to an edge of the square than this.
    border: f32,
    /// Whether a dart has room among the points before; without it, their distance decides.
    has_room: Option<HasRoom>,
}

/// Whether a dart may stay beside the points before, where a distance is asked.
type HasRoom = fn(dart: Vec2, points: &[Vec2], distance: f32) -> bool;

/// Darts, rightly but for what is changed.
fn darts(q: &PoissonDisk, change: impl FnOnce(&mut How)) -> Vec<Vec2> {
    let well = How {
        distance: q.distance,
        patience: PATIENCE,
        border: 0.0,
        has_room: None,
    };
    thrown(q, &changed(well, change))
}

fn thrown(q: &PoissonDisk, how: &How) -> Vec<Vec2> {
    let rng = &mut pcg::stream(22, q.seed.into());
    let (mut near, mut points) = (
        Neighbours::new(how.distance.into(), Space::Square),
        Vec::new(),
    );
    let mut misses = 0;
    while misses < how.patience && points.len() < MOST {
        let dart = vec2(rng.random(), rng.random());
        let has_room = || match how.has_room {
            Some(has_room) => has_room(dart, &points, how.distance),
            None => near.has_room(dart, how.distance.into()),
        };
        if dart.min(1.0 - dart).min_element() >= how.border && has_room() {
            if how.has_room.is_none() {
                near.push(dart);
            }
            points.push(dart);
            misses = 0;
        } else {
            misses += 1;
        }
    }
    points
}

/// Whether a dart is far enough from every point, by a rule for the way between them.
fn is_far(dart: Vec2, points: &[Vec2], is_far: impl Fn(Vec2) -> bool) -> bool {
    points.iter().all(|point| is_far(dart - *point))
}

/// The cell of a grid in which a place is; the diagonal of the cells is the distance.
fn cell(place: Vec2, distance: f32) -> Vec2 {
    (place * std::f32::consts::SQRT_2 / distance).floor()
}

/// Whether a dart has room where of two points in a cell as wide as the distance only the later is remembered.
fn has_room_beside_the_last(dart: Vec2, points: &[Vec2], distance: f32) -> bool {
    let cell = |p: Vec2| (p / distance).floor();
    let is_forgotten = |i: usize| points[i + 1..].iter().any(|o| cell(*o) == cell(points[i]));
    let mut near = (0..points.len()).filter(|i| dart.distance(points[*i]) < distance);
    near.all(is_forgotten)
}

/// Darts as far apart as asked, of which none comes nearer to an edge of the square than `border`. A little is left of the square, however wide its border is.
fn inside(q: &PoissonDisk, border: f32) -> Vec<Vec2> {
    let border = border.min(0.45);
    let within = |p: Vec2| border + (1.0 - 2.0 * border) * p;
    let darts = darts(q, |how| how.distance /= 1.0 - 2.0 * border);
    darts.into_iter().map(within).collect()
}

impl Graded for PoissonDisk {
    /// Whatever keeps its distance is right, so no last digit of it decides.
    const ULPS: i32 = 0;

    fn random(rng: &mut Pcg) -> PoissonDisk {
        PoissonDisk {
            distance: 0.05 * 5.0_f32.powf(rng.random()),
            seed: rng.random(),
        }
    }

    fn judge(q: &PoissonDisk, _golden: &Vec<Vec2>, got: &Vec<Vec2>) -> Verdict {
        points::all_inside(got)?;
        let d = q.distance;
        for (i, p) in got.iter().enumerate() {
            for (j, other) in got[..i].iter().enumerate() {
                let apart = p.distance(*other);
                if apart < d * (1.0 - ROUNDING) {
                    return Err(format!(
                        "points {} and {} are {apart:.4} apart; {d:.4} is the least",
                        j + 1,
                        i + 1
                    ));
                }
            }
        }
        let most = CROWDED * ((1.0 + d) / d).powi(2);
        if got.len() as f32 > most.max(4.0) {
            return Err(format!(
                "{} points have room only in a regular lattice; of random points about {:.0} have room",
                got.len(),
                0.7 * most
            ));
        }
        let room = room(got, d);
        let most = if got.len() < MANY {
            ROOM
        } else {
            ROOM_BESIDE_MANY
        };
        if room > most {
            let nearest = nearest(got) / d;
            let apart = if nearest.is_finite() {
                format!("; your nearest two are {nearest:.2} times the distance apart")
            } else {
                String::new()
            };
            return Err(format!(
                "in {:.0} % of the square there is still room for another point{apart}",
                100.0 * room
            ));
        }
        Ok(())
    }

    /// Chance brings many points nearly as close as they may be: of darts thrown for the visible cases, the closest two are 1.0003 times
    /// the distance apart, and of a thousand points none is 1.03 times it with a probability below 1e-20. So of n points, none is
    /// 1 + 15/n times it with one of e^−23 = 1e-10. And it brings as many points near to the border as anywhere else, or more: that all
    /// of n keep 21/n away from one of the four edges has a probability of 4 e^−21 = 3e-9. A border of half the distance that is left empty leaves room for
    /// more points, as the task does not allow: measured for distances of 0.06, 0.1 and 0.2, 8 % to 80 % more fit in.
    fn together(answers: &[(PoissonDisk, Vec<Vec2>)], _: Bounds) -> Verdict {
        let same = |a: &PoissonDisk, b: &PoissonDisk| a.distance == b.distance;
        together::seeded(answers, same, |q| q.seed)?;
        let many: Vec<_> = answers.iter().filter(|(_, got)| got.len() >= 20).collect();
        let all: usize = many.iter().map(|(_, got)| got.len()).sum();
        if all < 1000 {
            return Ok(()); // too few to tell more
        }
        let nearest = many.iter().map(|(q, got)| nearest(got) / q.distance);
        let nearest = nearest.fold(f32::INFINITY, f32::min);
        if nearest > 1.0 + 15.0 / all as f32 {
            return Err(format!(
                "no two points are nearer to each other than {nearest:.3} times the distance: more would have room"
            ));
        }
        let (close, within) = close_pairs(&many);
        if close >= 300 && within == 0 {
            return Err(
                "no two points are nearer than the distance along both x and y: two points aslant of each other may be that near"
                    .to_owned(),
            );
        }
        let points = || many.iter().flat_map(|(_, got)| got);
        let least = points().fold(Vec2::ONE, |least, p| least.min(*p));
        let most = points().fold(Vec2::ZERO, |most, p| most.max(*p));
        let free = least.max(1.0 - most).max_element();
        if free > 21.0 / all as f32 {
            return Err(format!(
                "no point is within {free:.4} of one of the square's edges, and others would fit in there: may your points lie there?"
            ));
        }
        let (mut near, mut expected) = (0, 0.0);
        for (q, got) in &many {
            let margin = 0.25 * q.distance;
            let inner = |p: &Vec2| p.min(1.0 - *p).min_element() > margin;
            near += got.iter().filter(|p| !inner(p)).count();
            expected += got.len() as f32 * (1.0 - (1.0 - 2.0 * margin).powi(2));
        }
        if (near as f32) < 0.25 * expected {
            return Err(format!(
                "{near} points are within a quarter of the distance of the square's border, where about {expected:.0} are expected and others would fit in: may your points lie there?"
            ));
        }
        // Behind the border: where that is empty, no two points are near to each other over the edges.
        let (over_edges, expected) = pairs_over_edges(&many);
        if expected >= 40.0 && over_edges.min_element() == 0 {
            return Err(
                "no two points would be too near to each other if the square were repeated: nothing is repeated beyond its edges"
                    .to_owned(),
            );
        }
        Ok(())
    }

    fn traits(q: &PoissonDisk, got: &Vec<Vec2>) -> Vec<f64> {
        let points: Vec<_> = got.iter().map(|p| p.as_dvec2()).collect();
        let least = |(i, p): (usize, &Vec2)| {
            let others = got.iter().enumerate().filter(|(j, _)| *j != i);
            f64::from(others.map(|(_, o)| p.distance(*o)).fold(2.0, f32::min) / q.distance)
        };
        let near: Vec<_> = got.iter().enumerate().map(least).collect();
        let mut traits = traits::shares(near.iter().copied(), 0.0, 2.0);
        traits.push(traits::log(
            f64::from(q.distance * q.distance) * got.len() as f64,
        ));
        traits.push(near.iter().copied().fold(2.0, f64::min));
        let inside = |p: &&Vec2| p.cmpge(Vec2::ZERO).all() && p.cmple(Vec2::ONE).all();
        let inside: Vec<_> = got.iter().filter(inside).copied().collect();
        traits.push(room(&inside, q.distance).into());
        traits.extend(traits::of_square(&points));
        traits
    }

    const EFFORT: usize = 100;

    const ALLOWS: &'static str = "Room for one more point may be left in 10 % of the square, and in 4 % of it from 100 points on.";

    const FLAWS: &'static [Flaw] = &[
        Flaw {
            complaint: "is not in the unit square",
            name: "puts points outside of the unit square",
            hint: "A point around another may fall over the edge: what becomes of it?",
        },
        Flaw {
            complaint: "is the least",
            name: "puts points nearer to each other than the distance",
            hint: "With which of the points before do you compare a new one, and what do you compare: the way's length, its square, half of it?",
        },
        Flaw {
            complaint: "only in a regular lattice",
            name: "makes a regular lattice",
            hint: "Would another seed give other points?",
        },
        Flaw {
            complaint: "there is still room",
            name: "ends while there is still room for more points, or keeps them too far apart",
            hint: "How often in a row may a new point be refused before you give up? Do two points that are just as far apart as asked both stay?",
        },
        points::SEED,
        points::PART_OF_SEED,
        points::SEED_OR_PART,
        points::SEED_OF_ONE,
        Flaw {
            complaint: "more would have room",
            name: "keeps the points farther apart than asked",
            hint: "With which number do you compare the distance of two points?",
        },
        Flaw {
            complaint: "two points aslant of each other",
            name: "compares the larger of the steps along x and along y with the distance",
            hint: "How far is it from (0, 0) to (1, 1)?",
        },
        Flaw {
            complaint: "if the square were repeated",
            name: "keeps the distance over the square's edges too, as if it were repeated",
            hint: "What lies beyond an edge: may a point at the left edge and one at the right be at the same height?",
        },
        Flaw {
            complaint: "may your points lie there",
            name: "keeps the points away from the border",
            hint: "May a point lie on the very edge of the square?",
        },
    ];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "compares the squared distance with the distance",
            hint: "Below 1, a square is smaller than its root: what do you compare with what?",
            answer: |q| darts(q, |how| how.distance = how.distance.sqrt()),
        },
        Mistake {
            name: "keeps the points only half of the distance apart",
            hint: "How near may two points come: half of the distance, or the whole? What do you compare?",
            answer: |q| darts(q, |how| how.distance *= 0.5),
        },
        Mistake {
            name: "keeps the points twice the distance apart",
            hint: "How near may two points come: once the distance, or twice?",
            answer: |q| darts(q, |how| how.distance *= 2.0),
        },
        Mistake {
            name: "compares with the last point only",
            hint: "To which of the points must a new one keep its distance?",
            answer: |q| {
                darts(q, |how| {
                    how.has_room = Some(|dart, points, distance| {
                        let is_far = |last: &Vec2| dart.distance(*last) >= distance;
                        points.last().is_none_or(is_far) && points.len() < 600
                    });
                })
            },
        },
        Mistake {
            name: "adds the distances along x and y",
            hint: "Which figure do the points make that have your distance from a point: a circle?",
            answer: |q| {
                darts(q, |how| {
                    how.has_room = Some(|dart, points, distance| {
                        is_far(dart, points, |way| way.abs().element_sum() >= distance)
                    });
                })
            },
        },
        Mistake {
            name: "keeps the points half the distance away from the border",
            hint: "May a point lie on the very edge of the square?",
            answer: |q| darts(q, |how| how.border = 0.5 * q.distance),
        },
        Mistake {
            name: "compares with the points in the cells next to its own only, where cells are smaller than the distance",
            hint: "A cell holds one point if its diagonal is the distance: how many cells away may a point be that is too near?",
            answer: |q| {
                darts(q, |how| {
                    how.has_room = Some(|dart, points, distance| {
                        points.iter().all(|point| {
                            let cells = cell(dart, distance) - cell(*point, distance);
                            cells.abs().max_element() > 1.0 || dart.distance(*point) >= distance
                        })
                    });
                })
            },
        },
        Mistake {
            name: "gives up too early",
            hint: "Look at your points: are there gaps in which another one would have room? How many darts may miss before you stop?",
            answer: |q| {
                let n = (0.15 / (q.distance * q.distance)).ceil() as usize;
                let mut points = darts(q, |_| ());
                points.truncate(n);
                points
            },
        },
        Mistake {
            name: "jitters: puts a point into each cell of a grid",
            hint: "Can two of your points lie close to each other, on the two sides of a cell's edge?",
            answer: |q| {
                let cells = (0.8 / q.distance).ceil() as usize;
                jittered::jittered(cells, cells, &mut pcg::stream(22, q.seed.into()))
            },
        },
        Mistake {
            name: "puts points anywhere without comparing them",
            hint: "How near are your nearest two points?",
            answer: |q| {
                let n = (0.65 / (q.distance * q.distance)).ceil() as usize;
                random_pattern::random_pattern(n, &mut pcg::stream(22, q.seed.into()))
            },
        },
        Mistake {
            name: "remembers one point for each cell, where cells are so wide that two fit in",
            hint: "A cell of which two corners are farther apart than the distance may hold two points: which of them do you still compare with?",
            answer: |q| darts(q, |how| how.has_room = Some(has_room_beside_the_last)),
        },
        Mistake {
            name: "gives up after about three points in a row that are too near",
            hint: "Where most of the square is taken, nearly all new points are refused: how many refusals in a row tell that there is no room left?",
            answer: |q| darts(q, |how| how.patience = 3),
        },
        Mistake {
            name: "gives up after about five points in a row that are too near",
            hint: "Where most of the square is taken, nearly all new points are refused: how many refusals in a row tell that there is no room left?",
            answer: |q| darts(q, |how| how.patience = 5),
        },
        Mistake {
            name: "gives up after about ten points in a row that are too near",
            hint: "Where most of the square is taken, nearly all new points are refused: how many refusals in a row tell that there is no room left?",
            answer: |q| darts(q, |how| how.patience = 10),
        },
        Mistake {
            name: "gives up after about twenty points in a row that are too near",
            hint: "Where most of the square is taken, nearly all new points are refused: how many refusals in a row tell that there is no room left?",
            answer: |q| darts(q, |how| how.patience = 20),
        },
        Mistake {
            name: "gives up after about thirty points in a row that are too near",
            hint: "Where most of the square is taken, nearly all new points are refused: how many refusals in a row tell that there is no room left?",
            answer: |q| darts(q, |how| how.patience = 30),
        },
        Mistake {
            name: "keeps the points √2 times the distance apart",
            hint: "How near may two points come: once the distance, or once the diagonal of a square of that side?",
            answer: |q| darts(q, |how| how.distance *= std::f32::consts::SQRT_2),
        },
        Mistake {
            name: "refuses a point if one of the steps along x and along y is below the distance",
            hint: "Two points in the same column: how far apart may they be?",
            answer: |q| {
                darts(q, |how| {
                    how.has_room = Some(|dart, points, distance| {
                        is_far(dart, points, |way| way.abs().min_element() >= distance)
                    });
                })
            },
        },
        Mistake {
            name: "keeps the points the whole distance away from the border",
            hint: "May a point lie on the very edge of the square?",
            answer: |q| darts(q, |how| how.border = q.distance),
        },
        Mistake {
            name: "gives up at the first point that is too near",
            hint: "A new point is refused: does that mean that no other one has room?",
            answer: |q| darts(q, |how| how.patience = 1),
        },
        Mistake {
            name: "puts points on a lattice of squares whose sides are the distance",
            hint: "Would another seed give other points?",
            answer: |q| {
                let side = (1.0 / q.distance).ceil() as u32;
                let place = |i: u32| i as f32 * q.distance;
                let row = |y| (0..side).map(move |x| vec2(place(x), place(y)));
                (0..side).flat_map(row).collect()
            },
        },
        Mistake {
            name: "chooses points from a smaller square, the whole distance inside the edges",
            hint: "May a point lie on the very edge of the square? Where at its border would another point have room?",
            answer: |q| inside(q, q.distance),
        },
        Mistake {
            name: "compares with the point in its own cell only",
            hint: "Two points on the two sides of a cell's edge: how near to each other may they be?",
            answer: |q| {
                darts(q, |how| {
                    how.has_room = Some(|dart, points, distance| {
                        let own = cell(dart, distance);
                        points.iter().all(|point| own != cell(*point, distance))
                    });
                })
            },
        },
    ];
}

/// The distance of the two points that are closest to each other.
fn nearest(points: &[Vec2]) -> f32 {
    let pairs = points
        .iter()
        .enumerate()
        .flat_map(|(i, p)| points[..i].iter().map(|other| p.distance(*other)));
    pairs.fold(f32::INFINITY, f32::min)
}

/// The share of the square that is farther than d from all points, also from those of the same squares around it: methods that are
/// right leave more room at the border, and it is not counted.
fn room(points: &[Vec2], d: f32) -> f32 {
    let d = f64::from(d.min(1.0)); // nothing in the square is that far from a point
    let mut near = Neighbours::new(d, Space::Torus);
    for p in points {
        near.push(*p);
    }
    let middle = |i: u32| (i as f32 + 0.5) / PROBES as f32;
    let probes = (0..PROBES).flat_map(|y| (0..PROBES).map(move |x| vec2(middle(x), middle(y))));
    probes.filter(|p| near.has_room(*p, d)).count() as f32 / (PROBES * PROBES) as f32
}

/// How many pairs of points are nearer to each other than 1.2 times the distance; and of how many of them both the step along x and that along
/// y are below the distance. By chance it is more than half of them.
fn close_pairs(answers: &[&(PoissonDisk, Vec<Vec2>)]) -> (usize, usize) {
    let (mut close, mut within) = (0, 0);
    for (q, got) in answers {
        for (i, p) in got.iter().enumerate() {
            let ways = got[..i].iter().map(|other| (*p - *other).abs());
            for way in ways.filter(|way| way.length() < 1.2 * q.distance) {
                close += 1;
                within += usize::from(way.max_element() < 0.99 * q.distance);
            }
        }
    }
    (close, within)
}

/// How many pairs of points would be nearer to each other than the distance if the square were repeated along x, and how many along
/// y; and about how many each is by chance: (2/3) n² d³, where n d² is about 0.7.
fn pairs_over_edges(answers: &[&(PoissonDisk, Vec<Vec2>)]) -> (UVec2, f32) {
    let (mut over, mut expected) = (UVec2::ZERO, 0.0);
    for (q, got) in answers {
        expected += 0.3 / q.distance;
        for (i, p) in got.iter().enumerate() {
            for way in got[..i].iter().map(|other| (*p - *other).abs()) {
                let is_near = |way: Vec2| u32::from(way.length() < 0.99 * q.distance);
                over.x += is_near(vec2(1.0 - way.x, way.y));
                over.y += is_near(vec2(way.x, 1.0 - way.y));
            }
        }
    }
    (over, expected)
}

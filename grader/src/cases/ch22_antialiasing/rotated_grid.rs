//! `rotated_grid`: random questions, judge and mistakes.

mod lattices;

use self::lattices::{
    before_half_of_side, clockwise, half_of_side, inside_twice, is_inside, lattice, of_a_piece,
    of_four, one_cosine_wrong, points, to_half_of_side, turned, within_half_of_diagonal,
    within_half_of_side,
};
use super::points::same_places;
use crate::{Flaw, Graded, Mistake, Verdict, sample};
use glam::{Mat2, Vec2, mat2, vec2};
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch22_antialiasing::RotatedGrid;
use std::cmp::Ordering;
use std::f32::consts::{FRAC_PI_3, FRAC_PI_4, FRAC_PI_6};

/// What leads to equal signs of the rotation's cosines.
const COSINES_HINT: &str = "A rotation keeps as much of x in x as of y in y, with the same sign: are your rows and columns still at right angles?";

/// How far a point may be from its place; one as near to the square's edge may be there or not.
const TOLERANCE: f32 = 1e-3;

/// Degrees by which rounded points, or points of four digits, turn a lattice at most.
const LITTLE: f32 = 0.05;

/// Rounding moves points by less than this.
const ROUNDING: f32 = 1e-5;

/// What is wrong where [`not_wrapped`] complains, and what leads to it.
const WRAPPED: &str = "lets points that leave the square come in again on its other side";
const WRAPPED_HINT: &str = "A rotated lattice does not go on at the left edge as it ends at the right one: what becomes of a point outside of the square?";

impl Graded for RotatedGrid {
    fn random(rng: &mut Pcg) -> RotatedGrid {
        RotatedGrid {
            spacing: sample::number(rng, 0.1, 0.5),
            offset: vec2(sample::number(rng, 0.0, 1.0), sample::number(rng, 0.0, 1.0)),
        }
    }

    /// Either sense of rotation is right; what is nearly on the square's edge may be there or not.
    fn judge(q: &RotatedGrid, _golden: &Vec<Vec2>, got: &Vec<Vec2>) -> Verdict {
        if got.iter().any(|p| !p.is_finite()) {
            return Err("a point is not made of numbers".into());
        }
        let surely = |p: &Vec2| (*p - 0.5).abs().max_element() < 0.5 - TOLERANCE;
        let nearly = |p: &Vec2| (*p - 0.5).abs().max_element() < 0.5 + TOLERANCE;
        if let Some(p) = got.iter().find(|p| !nearly(p)) {
            return Err(format!(
                "the point ({:.4}, {:.4}) is outside the square",
                p.x, p.y
            ));
        }
        let sense = |sense: f32| {
            let all = lattice(q, |p| turned(p, sense));
            let of_edge: Vec<_> = all.iter().filter(|p| nearly(p) && !surely(p)).collect();
            let on_edge = |p: &Vec2| of_edge.iter().any(|q| q.distance(*p) < 2.0 * TOLERANCE);
            let golden: Vec<_> = all.iter().copied().filter(surely).collect();
            let got: Vec<_> = got.iter().copied().filter(|p| !on_edge(p)).collect();
            same_places(&golden, &got, TOLERANCE)
        };
        sense(1.0).or_else(|_| sense(-1.0)).or_else(|_| {
            not_wrapped(q, got)?;
            angle(q, got)?;
            shift(q, got)?;
            sense(1.0)
        })
    }

    /// Points of a lattice lie above each other, and rounding decides which of them is the first along x: all of them get the same x.
    fn canonical(_q: &RotatedGrid, mut answer: Vec<Vec2>) -> Vec<Vec2> {
        answer.sort_by(|p, other| p.x.total_cmp(&other.x));
        let (mut column, mut before) = (f32::NAN, f32::NAN);
        for p in &mut answer {
            if (p.x - before).abs() < ROUNDING {
                before = p.x;
                p.x = column;
            } else {
                (column, before) = (p.x, p.x);
            }
        }
        answer
    }

    const POSITIVE: &'static [&'static str] = &["spacing"];

    const FLAWS: &'static [Flaw] = &[
        Flaw {
            complaint: "not made of numbers",
            name: "returns points that are not made of numbers",
            hint: "Print the cosine and the sine of your angle.",
        },
        Flaw {
            complaint: "is outside the square",
            name: "keeps what is outside",
            hint: "Are all your points in the square?",
        },
        Flaw {
            complaint: "by whole sides of the square",
            name: WRAPPED,
            hint: WRAPPED_HINT,
        },
        Flaw {
            complaint: "on this lattice it would be",
            name: "does not keep the points as far apart as asked",
            hint: "A rotation moves no point nearer to another: are its rows as long as those of (cos, −sin) and (sin, cos), and is each step along the lattice one spacing?",
        },
        Flaw {
            complaint: "the lattice is turned by",
            name: "turns the lattice by another angle",
            hint: "Which angle has the tangent ½? In which unit does your language's cosine want it?",
        },
        Flaw {
            complaint: "not on one lattice of squares",
            name: "shears or stretches the lattice instead of rotating it",
            hint: "A rotation moves x by y and y by x, with opposite signs: are your rows and columns still at right angles, and equally long?",
        },
        Flaw {
            complaint: "as if there were no offset",
            name: "ignores the offset",
            hint: "Change `offset` alone: do your points move?",
        },
        Flaw {
            complaint: "as if the offset were subtracted",
            name: "subtracts the offset",
            hint: "Let `offset` be small: to which side should your points move?",
        },
        Flaw {
            complaint: "steps, and should be",
            name: "puts the lattice in the wrong place",
            hint: "Which point of the square stays where it is when you rotate, and is the offset added to i and j, or to the place?",
        },
        Flaw {
            complaint: "points are missing",
            name: "leaves out points of the lattice that are in the square",
            hint: "Over which i and j do you go? How far is it from the middle of the square to its corners, and how far does the offset move the lattice?",
        },
        Flaw {
            complaint: "points are there twice",
            name: "returns points twice",
            hint: "Does each pair of i and j come once?",
        },
    ];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "does not rotate",
            hint: "Do two of your points lie side by side, at the same height?",
            answer: |q| points(q, |how| how.turn = Mat2::IDENTITY),
        },
        Mistake {
            name: "rotates by 45°",
            hint: "An edge at 45° is also common in pictures. Which angle has the tangent ½?",
            answer: |q| points(q, |how| how.turn = Mat2::from_angle(FRAC_PI_4)),
        },
        Mistake {
            name: "takes ½ for the angle",
            hint: "½ is the tangent: what is the angle, in radians?",
            answer: |q| points(q, |how| how.turn = Mat2::from_angle(0.5)),
        },
        Mistake {
            name: "takes degrees for radians",
            hint: "In which unit does your language's cosine want its angle?",
            answer: |q| points(q, |how| how.turn = Mat2::from_angle(26.565)),
        },
        Mistake {
            name: "rotates without the root of 5",
            hint: "A right triangle has the sides 2 and 1: how long is its third side? Are your points as far apart as asked?",
            answer: |q| points(q, |how| how.turn *= 5.0_f32.sqrt() / 2.0),
        },
        Mistake {
            name: "shears instead of rotating",
            hint: "A rotation moves x by y and y by x, with opposite signs: are your rows and columns still at right angles?",
            answer: |q| points(q, |how| how.turn = mat2(vec2(1.0, 0.5), Vec2::Y)),
        },
        Mistake {
            name: "keeps only four points",
            hint: "A fine lattice has many points in the square: over which i and j do you go?",
            answer: |q| points(q, |how| how.takes = of_four),
        },
        Mistake {
            name: "lets i and j go only as far as half of the square's side, and does not come into its corners",
            hint: "How far is it from the middle of the square to its corners? A lattice that is turned, or moved, must reach further still.",
            answer: |q| points(q, |how| how.takes = to_half_of_side),
        },
        Mistake {
            name: "takes no negative steps along the lattice",
            hint: "Where i = j = 0 lies the middle: which points lie on the other side of it?",
            answer: |q| points(q, |how| how.takes = |_, step| step.min_element() >= 0.0),
        },
        Mistake {
            name: "rotates about the corner",
            hint: "Which point of the square stays where it is when you rotate?",
            answer: |q| points(q, |how| how.centre = -half_of_side(q)),
        },
        Mistake {
            name: "begins the lattice at the square's corner, not in its middle",
            hint: "Which point of the square has i = j = 0 if there is no offset? What do you add at last?",
            answer: |q| points(q, |how| how.after -= half_of_side(q)),
        },
        Mistake {
            name: "begins the lattice at the square's corner, not in its middle (in a lattice turned clockwise)",
            hint: "Which point of the square has i = j = 0 if there is no offset? What do you add at last?",
            answer: |q| clockwise(q, |how| how.after -= half_of_side(q)),
        },
        Mistake {
            name: "keeps what is outside",
            hint: "Are all your points in the square?",
            answer: |q| points(q, |how| how.keeps = |_, _, _| true),
        },
        Mistake {
            name: "has one sign of the rotation's sines wrong",
            hint: "A rotation moves x by y and y by x, with opposite signs: are your rows and columns still at right angles?",
            answer: |q| {
                points(q, |how| {
                    how.turn = mat2(vec2(2.0, 1.0), vec2(1.0, 2.0)) / 5.0_f32.sqrt();
                })
            },
        },
        Mistake {
            name: "has one sign of the rotation's cosines wrong",
            hint: COSINES_HINT,
            answer: |q| points(q, one_cosine_wrong),
        },
        Mistake {
            name: "has one sign of the rotation's cosines wrong (in a lattice turned clockwise)",
            hint: COSINES_HINT,
            answer: |q| clockwise(q, one_cosine_wrong),
        },
        Mistake {
            name: "has both signs of the rotation's sines wrong in the same way",
            hint: "A rotation moves x by y and y by x, with opposite signs: are your rows and columns still at right angles?",
            answer: |q| {
                points(q, |how| {
                    how.turn = mat2(vec2(2.0, -1.0), vec2(-1.0, 2.0)) / 5.0_f32.sqrt();
                })
            },
        },
        Mistake {
            name: "takes ½ for the angle (in a lattice turned clockwise)",
            hint: "½ is the tangent: what is the angle, in radians?",
            answer: |q| clockwise(q, |how| how.turn = Mat2::from_angle(0.5)),
        },
        Mistake {
            name: "adds the offset after the rotation, so that it is not turned with the lattice",
            hint: "Is the offset measured along the lattice, or along the sides of the square?",
            answer: |q| points(q, |how| (how.offset, how.after) = (Vec2::ZERO, how.offset)),
        },
        Mistake {
            name: "adds the offset after the rotation (in a lattice turned clockwise)",
            hint: "Is the offset measured along the lattice, or along the sides of the square?",
            answer: |q| clockwise(q, |how| (how.offset, how.after) = (Vec2::ZERO, how.offset)),
        },
        Mistake {
            name: "takes the offset in sides of the square",
            hint: "In which unit is the offset: in spacings, or in sides of the square?",
            answer: |q| points(q, |how| how.offset /= q.spacing),
        },
        Mistake {
            name: "takes the offset in sides of the square (in a lattice turned clockwise)",
            hint: "In which unit is the offset: in spacings, or in sides of the square?",
            answer: |q| clockwise(q, |how| how.offset /= q.spacing),
        },
        Mistake {
            name: "adds the offset at last, in sides of the square",
            hint: "In which unit is the offset, and along which axes is it measured?",
            answer: |q| {
                points(q, |how| {
                    (how.offset, how.after) = (Vec2::ZERO, q.offset / q.spacing);
                })
            },
        },
        Mistake {
            name: "rotates by 30°",
            hint: "Which angle has the tangent ½, and which angle the sine ½?",
            answer: |q| points(q, |how| how.turn = Mat2::from_angle(FRAC_PI_6)),
        },
        Mistake {
            name: "takes no more steps along the lattice than fit into half of the square's side",
            hint: "How far is it from the middle of the square to its corners? A lattice that is turned, or moved, must reach further still.",
            answer: |q| points(q, |how| how.takes = within_half_of_side),
        },
        Mistake {
            name: "keeps the points that are in the square before the rotation",
            hint: "Which points must be in the square: the rotated ones, or those before?",
            answer: |q| {
                points(q, |how| {
                    how.keeps = |half, before, _| is_inside(before, half);
                })
            },
        },
        Mistake {
            name: "keeps only the points that are in the square before the rotation and after it",
            hint: "Which points must be in the square: the rotated ones, or those before?",
            answer: |q| points(q, |how| how.keeps = inside_twice),
        },
        Mistake {
            name: WRAPPED,
            hint: WRAPPED_HINT,
            answer: |q| {
                points(q, |how| {
                    (how.takes, how.keeps, how.ends) = (of_a_piece, |_, _, _| true, Vec2::fract_gl);
                })
            },
        },
        Mistake {
            name: "lets i and j go only as far as half of the square's side, and does not come into its corners (in a lattice turned clockwise)",
            hint: "How far is it from the middle of the square to its corners? A lattice that is turned, or moved, must reach further still.",
            answer: |q| clockwise(q, |how| how.takes = to_half_of_side),
        },
        Mistake {
            name: "takes no more steps along the lattice than fit into half of the square's side (in a lattice turned clockwise)",
            hint: "How far is it from the middle of the square to its corners? A lattice that is turned, or moved, must reach further still.",
            answer: |q| clockwise(q, |how| how.takes = within_half_of_side),
        },
        Mistake {
            name: "lets i and j go only as far as half of the square's side, and leaves out the last of both",
            hint: "Does your loop come to its last number, or does it end before? And how far is it from the middle of the square to its corners?",
            answer: |q| points(q, |how| how.takes = before_half_of_side),
        },
        Mistake {
            name: "lets i and j go only as far as half of the square's side, and leaves out the last of both (in a lattice turned clockwise)",
            hint: "Does your loop come to its last number, or does it end before? And how far is it from the middle of the square to its corners?",
            answer: |q| clockwise(q, |how| how.takes = before_half_of_side),
        },
        Mistake {
            name: "lets i and j go only as far as half of the square's diagonal, and no further for the offset",
            hint: "A lattice that is moved by its offset begins further away on one side: how many steps more must i and j take?",
            answer: |q| points(q, |how| how.takes = within_half_of_diagonal),
        },
        Mistake {
            name: "lets i and j go only as far as half of the square's diagonal, and no further for the offset (in a lattice turned clockwise)",
            hint: "A lattice that is moved by its offset begins further away on one side: how many steps more must i and j take?",
            answer: |q| clockwise(q, |how| how.takes = within_half_of_diagonal),
        },
        Mistake {
            name: "takes no negative steps along the lattice (in a lattice turned clockwise)",
            hint: "Where i = j = 0 lies the middle: which points lie on the other side of it?",
            answer: |q| clockwise(q, |how| how.takes = |_, step| step.min_element() >= 0.0),
        },
        Mistake {
            name: "keeps only four points (in a lattice turned clockwise)",
            hint: "A fine lattice has many points in the square: over which i and j do you go?",
            answer: |q| clockwise(q, |how| how.takes = of_four),
        },
        Mistake {
            name: "rotates about the corner (in a lattice turned clockwise)",
            hint: "Which point of the square stays where it is when you rotate?",
            answer: |q| clockwise(q, |how| how.centre = -half_of_side(q)),
        },
        Mistake {
            name: "keeps the points that are in the square before the rotation (in a lattice turned clockwise)",
            hint: "Which points must be in the square: the rotated ones, or those before?",
            answer: |q| {
                clockwise(q, |how| {
                    how.keeps = |half, before, _| is_inside(before, half);
                })
            },
        },
        Mistake {
            name: "keeps only the points that are in the square before the rotation and after it (in a lattice turned clockwise)",
            hint: "Which points must be in the square: the rotated ones, or those before?",
            answer: |q| clockwise(q, |how| how.keeps = inside_twice),
        },
        Mistake {
            name: "rotates by 30° (in a lattice turned clockwise)",
            hint: "Which angle has the tangent ½, and which angle the sine ½?",
            answer: |q| clockwise(q, |how| how.turn = Mat2::from_angle(FRAC_PI_6)),
        },
        Mistake {
            name: "rotates by 60°",
            hint: "Which angle has the tangent ½, and which angle the cosine ½?",
            answer: |q| points(q, |how| how.turn = Mat2::from_angle(FRAC_PI_3)),
        },
        Mistake {
            name: "rotates by 60° (in a lattice turned clockwise)",
            hint: "Which angle has the tangent ½, and which angle the cosine ½?",
            answer: |q| clockwise(q, |how| how.turn = Mat2::from_angle(FRAC_PI_3)),
        },
        Mistake {
            name: "rotates by 45° (in a lattice turned clockwise)",
            hint: "An edge at 45° is also common in pictures. Which angle has the tangent ½?",
            answer: |q| clockwise(q, |how| how.turn = Mat2::from_angle(FRAC_PI_4)),
        },
        Mistake {
            name: "takes degrees for radians (in a lattice turned clockwise)",
            hint: "In which unit does your language's cosine want its angle?",
            answer: |q| clockwise(q, |how| how.turn = Mat2::from_angle(26.565)),
        },
        Mistake {
            name: "rotates without the root of 5 (in a lattice turned clockwise)",
            hint: "A right triangle has the sides 2 and 1: how long is its third side? Are your points as far apart as asked?",
            answer: |q| clockwise(q, |how| how.turn *= 5.0_f32.sqrt() / 2.0),
        },
    ];
}

/// Whether no points, or all, are on the lattice only if they are moved by whole sides of the square, or others are not on it at all.
fn not_wrapped(q: &RotatedGrid, got: &[Vec2]) -> Verdict {
    /// Sides by which a point may be moved.
    const SIDES: i32 = 2;
    let sides =
        (-SIDES..=SIDES).flat_map(|j| (-SIDES..=SIDES).map(move |i| vec2(i as f32, j as f32)));
    let sides: Vec<_> = sides.collect();
    let is_on = |p: Vec2, sense: f32| {
        let steps = turned((p - 0.5) / q.spacing, -sense) - q.offset;
        (steps - steps.round()).length() < 2.0 * TOLERANCE / q.spacing
    };
    let senses = [1.0, -1.0];
    if senses
        .iter()
        .any(|sense| got.iter().all(|p| is_on(*p, *sense)))
    {
        return Ok(()); // in the middle, points may be on the lattice of the other sense too
    }
    for sense in senses {
        let moved = got.iter().filter(|p| !is_on(**p, sense)).count();
        let comes_from = |p: &Vec2| sides.iter().any(|side| is_on(*p + *side, sense));
        if (1..got.len()).contains(&moved) && got.iter().all(comes_from) {
            return Err(format!(
                "{moved} of the points are on the lattice only if they are moved by whole sides of the square"
            ));
        }
    }
    Ok(())
}

/// Whether the lattice is turned as it should be, by each point's way to its nearest neighbour.
fn angle(q: &RotatedGrid, got: &[Vec2]) -> Verdict {
    let nearest = |p: &Vec2| {
        let ways = got.iter().map(|other| *other - *p);
        let others = ways.filter(|way| *way != Vec2::ZERO);
        others.min_by(|one, other| one.length_squared().total_cmp(&other.length_squared()))
    };
    let Some(way) = got.first().and_then(nearest) else {
        return Ok(());
    };
    if (way.length() - q.spacing).abs() > 0.01 * q.spacing {
        return Err(format!(
            "the first point's nearest neighbour is {:.4} away; on this lattice it would be {:.4}",
            way.length(),
            q.spacing
        ));
    }
    // From the nearest axis, whichever that is: 0° to 45°.
    let to_axis = way.to_angle().rem_euclid(2.0 * FRAC_PI_4);
    let degrees = to_axis.min(2.0 * FRAC_PI_4 - to_axis).to_degrees();
    let off = (degrees - 26.565).abs();
    if off > 0.5 {
        return Err(format!(
            "the lattice is turned by {degrees:.1}°, and should be by 26.6°"
        ));
    }
    // So little may also come of a shear, whose columns are not at right angles to its rows.
    let is_on = |p: &Vec2| {
        let way_back = vec2(way.x, -way.y) / way.length_squared();
        let steps = way_back.rotate(*p - got[0]);
        (steps - steps.round()).length() < 2.0 * TOLERANCE / q.spacing
    };
    if off > LITTLE && got.iter().all(is_on) {
        return Err(format!(
            "the lattice is turned by {degrees:.2}°, and should be by 26.57°"
        ));
    }
    Ok(())
}

/// Whether the lattice, turned as it should be, is in its place, and whole: by how many steps it is shifted along its own axes.
fn shift(q: &RotatedGrid, got: &[Vec2]) -> Verdict {
    let Some(first) = got.first() else {
        return Ok(());
    };
    let surely = |p: &&Vec2| (**p - 0.5).abs().max_element() < 0.5 - TOLERANCE;
    let steps = |p: &Vec2, sense: f32| turned((*p - 0.5) / q.spacing, -sense);
    let near = |a: Vec2, b: Vec2| {
        let off = a - b;
        (off - off.round()).length() < 2.0 * TOLERANCE / q.spacing
    };
    // The points tell in which sense they are turned, if there are any two of them.
    let on_lattice = |sense: &f32| {
        let here = steps(first, *sense);
        got.iter().all(|p| near(steps(p, *sense), here))
    };
    let senses: Vec<_> = [1.0, -1.0].into_iter().filter(on_lattice).collect();
    let is = |offset: Vec2| {
        senses
            .iter()
            .any(|sense| near(steps(first, *sense), offset))
    };
    let Some(sense) = senses.first() else {
        return Err("the points are not on one lattice of squares".to_owned());
    };
    if is(q.offset) {
        let all = lattice(q, |p| turned(p, *sense));
        let due = all.iter().filter(surely).count();
        let there = got.iter().filter(surely).count();
        return match due.cmp(&there) {
            Ordering::Greater => Err(format!(
                "{} of the lattice's {due} points are missing",
                due - there
            )),
            Ordering::Less => Err(format!("{} points are there twice", there - due)),
            Ordering::Equal => Ok(()),
        };
    }
    let turned = senses.iter().map(|sense| steps(first, *sense));
    let words: Vec<_> = turned
        .map(|steps| {
            (steps - steps.floor())
                .to_array()
                .map(|v| format!("{v:.2}"))
                .join(" and ")
        })
        .collect();
    let how = if is(Vec2::ZERO) {
        ", as if there were no offset"
    } else if is(-q.offset) {
        ", as if the offset were subtracted"
    } else {
        ""
    };
    Err(format!(
        "the lattice is shifted by {} steps{how}, and should be by {:.2} and {:.2}",
        words.join(" or "),
        q.offset.x,
        q.offset.y
    ))
}

//! `jittered`: random questions, judge and mistakes.

mod placed;

use super::points;
use crate::together::Bounds;
use crate::upon::changed;
use crate::{Flaw, Graded, Mistake, Verdict, judge, together, traits};
use glam::{Vec2, Vec2Swizzles, vec2};
use placed::{
    BOTH, CellOrder, IN_ONE_CELL, LEFT_TO_RIGHT, MANY, TOP_TO_BOTTOM, by_cells, drawn_for_each,
    one_each, places, same_at_the_edges, scattered, unevenness,
};
use rand::RngExt;
use raybook::math::pcg::{self, Pcg};
use raybook_workbook::exercises::ch22_antialiasing::Jittered;
use std::f32::consts::TAU;

/// How points are put into cells; one field wrong is a mistake.
#[derive(Clone, Copy)]
struct How {
    /// The cell whose two numbers are taken, for each coordinate.
    drawn: [fn(cell: Vec2) -> Vec2; 2],
    /// Which of these two is taken, for each coordinate.
    taken: [usize; 2],
    /// What is made of these uniform numbers.
    bend: fn(u: Vec2) -> Vec2,
    /// From where in its cell a point may be …
    from: Vec2,
    /// … to where.
    to: Vec2,
    /// The column and the row that are taken for those of a cell.
    cell: fn(cell: Vec2) -> Vec2,
    /// What the column and the row are divided by, of the number of cells.
    count: fn(count: Vec2) -> Vec2,
    /// What the random part is divided by, of what the column and the row are.
    width: fn(count: Vec2) -> Vec2,
    /// What becomes of a point at last.
    ends: fn(p: Vec2) -> Vec2,
}

/// As it should be.
const WELL: How = How {
    drawn: [|cell| cell; 2],
    taken: [0, 1],
    bend: |u| u,
    from: Vec2::ZERO,
    to: Vec2::ONE,
    cell: |cell| cell,
    count: |count| count,
    width: |count| count,
    ends: |p| p,
};

/// The cells that share their numbers: all of a column …
const OF_COLUMN: fn(Vec2) -> Vec2 = |cell| vec2(cell.x, 0.0);

/// … or all of a row.
const OF_ROW: fn(Vec2) -> Vec2 = |cell| vec2(0.0, cell.y);

/// The points, rightly but for what is changed.
fn in_cells(q: &Jittered, change: fn(&mut How)) -> Vec<Vec2> {
    let how = changed(WELL, change);
    let rng = &mut pcg::stream(22, q.seed.into());
    let drawn = (0..q.columns * q.rows).map(|_| vec2(rng.random(), rng.random()));
    let drawn: Vec<_> = drawn.collect();
    let number = |cell: Vec2| cell.y as usize * q.columns as usize + cell.x as usize;
    let count = (how.count)(vec2(q.columns as f32, q.rows as f32));
    let width = (how.width)(count);
    let cells = (0..q.rows).flat_map(|j| (0..q.columns).map(move |i| vec2(i as f32, j as f32)));
    let place = |cell| {
        let [x, y] = [0, 1].map(|axis| drawn[number(how.drawn[axis](cell))][how.taken[axis]]);
        let u = how.from + (how.to - how.from) * (how.bend)(vec2(x, y));
        (how.ends)((how.cell)(cell) / count + u / width)
    };
    cells.map(place).collect()
}

/// A number with the distribution of the mean of two uniform ones, of one uniform number.
fn of_a_tent(u: f32) -> f32 {
    if u < 0.5 {
        (0.5 * u).sqrt()
    } else {
        1.0 - (0.5 * (1.0 - u)).sqrt()
    }
}

/// Two normal numbers around ½, of two uniform ones (Box and Muller 1958), so that nearly all are in [0, 1); the others are put at its ends.
fn of_a_bell(u: Vec2) -> Vec2 {
    const DEVIATION: f32 = 1.0 / 6.0;
    let radius = DEVIATION * (-2.0 * (1.0 - u.x).ln()).sqrt();
    let p = 0.5 + radius * Vec2::from_angle(TAU * u.y);
    p.clamp(Vec2::ZERO, Vec2::splat(1.0 - f32::EPSILON))
}

impl Graded for Jittered {
    fn random(rng: &mut Pcg) -> Jittered {
        Jittered {
            columns: rng.random_range(8..=20),
            rows: rng.random_range(8..=20),
            seed: rng.random(),
        }
    }

    fn judge(q: &Jittered, _golden: &Vec<Vec2>, got: &Vec<Vec2>) -> Verdict {
        points::in_square((q.columns * q.rows) as usize, got)?;
        let count = vec2(q.columns as f32, q.rows as f32);
        let scaled: Vec<_> = got.iter().map(|p| count * *p).collect();
        one_each(q, &scaled)?;
        let places = places(q, got);
        judge::scattered("places in the cells", &places)?;
        drawn_for_each(q, got, &places)?;
        scattered(&places)
    }

    fn together(answers: &[(Jittered, Vec<Vec2>)], bounds: Bounds) -> Verdict {
        let same = |a: &Jittered, b: &Jittered| (a.columns, a.rows) == (b.columns, b.rows);
        together::seeded(answers, same, |q| q.seed)?;
        same_at_the_edges(answers)?;
        let in_order = |order: CellOrder| {
            let sorted = |(q, got): &(Jittered, Vec<Vec2>)| places(q, &by_cells(q, got, order));
            answers.iter().map(sorted).collect::<Vec<_>>()
        };
        let along_rows = in_order(CellOrder::AlongRows);
        let along_rows: Vec<_> = along_rows.iter().collect();
        points::together(&along_rows, [LEFT_TO_RIGHT, TOP_TO_BOTTOM], BOTH, bounds)?;
        // Points that are sorted depend on each other in their order, which does not count; in that of the cells they must not.
        points::serial(&along_rows, IN_ONE_CELL, "the next cell in its row", bounds)?;
        // Three questions more, and a right program fails each by chance with 4e-10: 1e-9 in all.
        let down_columns = in_order(CellOrder::DownColumns);
        let down_columns: Vec<_> = down_columns.iter().collect();
        let next = "the next cell in its column";
        points::serial(&down_columns, IN_ONE_CELL, next, bounds)
    }

    /// Within the visible cases' limit of columns and rows; they are the same, so that seeds can be compared.
    fn further(rng: &mut Pcg) -> Vec<Jittered> {
        let question = |seed| Jittered {
            columns: 24,
            rows: 24,
            seed,
        };
        together::seeds(rng, 800).map(question).collect()
    }

    fn traits(q: &Jittered, got: &Vec<Vec2>) -> Vec<f64> {
        let count = vec2(q.columns as f32, q.rows as f32);
        let in_cell = |p: &Vec2| (count * *p - (count * *p).floor()).as_dvec2();
        let places: Vec<_> = got.iter().map(in_cell).collect();
        let whole: Vec<_> = got.iter().map(|p| p.as_dvec2()).collect();
        let cell = |p: &Vec2| ((count * *p).floor().dot(vec2(1.0, 1e3))).into();
        let mut traits = [traits::of_square(&places), traits::of_square(&whole)].concat();
        traits.push(traits::distinct(got.iter().map(cell)));
        traits.extend(unevenness(q, got));
        let asked = f64::from(q.columns * q.rows);
        traits.push(got.len() as f64 / asked.max(1.0));
        // A few cells tell little of a distribution.
        let weight = (asked / MANY).sqrt().min(1.0);
        traits.iter().map(|v| weight * v).collect()
    }

    const FIXED: &'static [&'static str] = &["seed"];

    const FLAWS: &'static [Flaw] = &[
        points::COUNT,
        points::OUTSIDE,
        Flaw {
            complaint: "each cell has one",
            name: "puts two points into some cells, and none into others",
            hint: "Cell (i, j) is from i/columns to (i + 1)/columns along x, and from j/rows to (j + 1)/rows along y: is each of your points in its own?",
        },
        points::SAME,
        points::LINE,
        Flaw {
            complaint: "lie alike in their cells",
            name: "draws a number for a whole column or row of cells, and not for each cell",
            hint: "In which of your two loops does each random number stand: how often is it drawn?",
        },
        Flaw {
            name: "does not choose all places in a cell equally often",
            hint: "From where to where in its cell may your point be? Is it anywhere between with the same chance?",
            ..points::UNEVEN
        },
        points::TOGETHER,
        Flaw {
            complaint: "than in the cells within",
            name: "chooses other places in the cells at an edge of the square, in the first or last row or column, than in the others",
            hint: "Is there a condition for the first or the last row or column of cells? Is anything clamped to the square there?",
        },
        Flaw {
            complaint: "its mirror image",
            name: "spreads the places in the cells more evenly than chance does",
            hint: "Does the place in one cell depend on that in another, or on the cell's number?",
        },
        points::SEED,
        points::PART_OF_SEED,
        points::SEED_OR_PART,
        points::SEED_OF_ONE,
        Flaw {
            name: "chooses a place in one cell that depends on the place in the next cell",
            hint: "Is the place in a cell chosen by random numbers of its own, or by those of another cell?",
            ..points::SERIAL
        },
    ];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "takes the cells' middles",
            hint: "Which of your points would be elsewhere with another seed?",
            answer: |q| {
                in_cells(q, |how| {
                    (how.from, how.to) = (Vec2::splat(0.5), Vec2::splat(0.5));
                })
            },
        },
        Mistake {
            name: "puts points anywhere in the square, not one into each cell",
            hint: "How many of your points are in the first cell? And in the last?",
            answer: |q| {
                in_cells(q, |how| {
                    (how.cell, how.width) = (|_| Vec2::ZERO, |_| Vec2::ONE);
                })
            },
        },
        Mistake {
            name: "jitters around the cells' corners",
            hint: "Cell (i, j) begins at (i, j): can your point be before it?",
            answer: |q| {
                in_cells(q, |how| {
                    (how.from, how.to) = (Vec2::splat(-0.5), Vec2::splat(0.5));
                    how.ends = |p| p.max(Vec2::ZERO);
                })
            },
        },
        Mistake {
            name: "moves all points by the same amount",
            hint: "Do all your points have the same place in their cells? How many random numbers does each point need?",
            answer: |q| in_cells(q, |how| how.drawn = [|_| Vec2::ZERO; 2]),
        },
        Mistake {
            name: "moves all points of a column by the same amount along x",
            hint: "Do the points of one column of cells lie straight under each other? How many random numbers does each point need?",
            answer: |q| in_cells(q, |how| how.drawn[0] = OF_COLUMN),
        },
        Mistake {
            name: "moves all points of a row by the same amount along y",
            hint: "Do the points of one row of cells lie side by side at one height? How many random numbers does each point need?",
            answer: |q| in_cells(q, |how| how.drawn[1] = OF_ROW),
        },
        Mistake {
            name: "uses one number for both coordinates",
            hint: "Look at your points in their cells: are all of them on a diagonal?",
            answer: |q| in_cells(q, |how| how.taken = [0, 0]),
        },
        Mistake {
            name: "jitters by half a cell only",
            hint: "Can your point be anywhere in its cell, near its edges too?",
            answer: |q| {
                in_cells(q, |how| {
                    (how.from, how.to) = (Vec2::splat(0.25), Vec2::splat(0.75));
                })
            },
        },
        Mistake {
            name: "exchanges columns and rows",
            hint: "Try three columns and one row: are your points side by side?",
            answer: |q| Self::misread(q, |q| (q.columns, q.rows) = (q.rows, q.columns)),
        },
        Mistake {
            name: "jitters along x only",
            hint: "How many different y have your points in one row of cells?",
            answer: |q| in_cells(q, |how| (how.from.y, how.to.y) = (0.5, 0.5)),
        },
        Mistake {
            name: "jitters along y only",
            hint: "How many different x have your points in one column of cells?",
            answer: |q| in_cells(q, |how| (how.from.x, how.to.x) = (0.5, 0.5)),
        },
        Mistake {
            name: "jitters around the cells' corners, and leaves the square",
            hint: "Cell (i, j) begins at (i, j): can your point be before it?",
            answer: |q| {
                in_cells(q, |how| {
                    (how.from, how.to) = (Vec2::splat(-0.5), Vec2::splat(0.5));
                })
            },
        },
        Mistake {
            name: "moves a point by as much as the whole square, not by as much as its cell",
            hint: "How wide is a cell, and how far may its point be from its left edge?",
            answer: |q| in_cells(q, |how| how.width = |_| Vec2::ONE),
        },
        Mistake {
            name: "divides the columns by the number of rows, and the rows by that of the columns",
            hint: "Along x, how many cells are side by side?",
            answer: |q| in_cells(q, |how| how.count = |count| count.yx()),
        },
        Mistake {
            name: "leaves out the last row of cells",
            hint: "Where does each of your two loops end?",
            answer: |q| {
                let count = q.columns * q.rows.saturating_sub(1);
                let mut all = Self::right(q);
                all.truncate(count as usize);
                all
            },
        },
        Mistake {
            name: "leaves out the last column of cells",
            hint: "Where does each of your two loops end?",
            answer: |q| {
                let last = q.columns.saturating_sub(1) as f32 / q.columns as f32;
                let mut all = Self::right(q);
                all.retain(|p| p.x < last);
                all
            },
        },
        Mistake {
            name: "squares the number that places a point along x",
            hint: "Is every place in a cell as likely as any other?",
            answer: |q| in_cells(q, |how| how.bend = |u| vec2(u.x * u.x, u.y)),
        },
        Mistake {
            name: "squares the number that places a point along y",
            hint: "Is every place in a cell as likely as any other?",
            answer: |q| in_cells(q, |how| how.bend = |u| vec2(u.x, u.y * u.y)),
        },
        Mistake {
            name: "squares the numbers that place a point",
            hint: "Is every place in a cell as likely as any other?",
            answer: |q| in_cells(q, |how| how.bend = |u| u * u),
        },
        Mistake {
            name: "counts the cells from 1",
            hint: "In which cell is the point for i = j = 0: where does it begin?",
            answer: |q| in_cells(q, |how| how.cell = |cell| cell + 1.0),
        },
        Mistake {
            name: "divides both by the number of columns",
            hint: "Are your cells square where there are more columns than rows?",
            answer: |q| in_cells(q, |how| how.count = |count| count.xx()),
        },
        Mistake {
            name: "moves points by up to a whole cell from their cell's middle, and clamps them to the square",
            hint: "How far is it from a cell's middle to its edge?",
            answer: |q| {
                in_cells(q, |how| {
                    (how.from, how.to) = (Vec2::splat(-0.5), Vec2::splat(1.5));
                    how.ends = |p| p.clamp(Vec2::ZERO, Vec2::splat(1.0 - f32::EPSILON));
                })
            },
        },
        Mistake {
            name: "starts the generator again for every row of cells",
            hint: "Do the points of one row of cells have the same places in their cells as those of the next?",
            answer: |q| in_cells(q, |how| how.drawn = [OF_COLUMN; 2]),
        },
        Mistake {
            name: "takes the column for the row too",
            hint: "In which row of cells is the point for i = 0 and j = 1?",
            answer: |q| in_cells(q, |how| how.cell = |cell| cell.xx()),
        },
        Mistake {
            name: "puts all points into the first cell",
            hint: "How do i and j come in: is i/columns a division of whole numbers?",
            answer: |q| in_cells(q, |how| how.cell = |_| Vec2::ZERO),
        },
        Mistake {
            name: "keeps to the cells along x only, and puts y anywhere",
            hint: "How many of your points are in each row of cells?",
            answer: |q| {
                in_cells(q, |how| {
                    how.cell = |cell| vec2(cell.x, 0.0);
                    how.width = |count| vec2(count.x, 1.0);
                })
            },
        },
        Mistake {
            name: "keeps to the cells along y only, and puts x anywhere",
            hint: "How many of your points are in each column of cells?",
            answer: |q| {
                in_cells(q, |how| {
                    how.cell = |cell| vec2(0.0, cell.y);
                    how.width = |count| vec2(1.0, count.y);
                })
            },
        },
        Mistake {
            name: "draws one number for all cells of a column, and one for all of a row",
            hint: "Do the points of a column of cells all have the same x?",
            answer: |q| in_cells(q, |how| how.drawn = [OF_COLUMN, OF_ROW]),
        },
        Mistake {
            name: "crowds the points in the middle of their cells, as the mean of two random numbers does",
            hint: "The mean of two random numbers is seldom near 0 or 1: is every place in a cell as likely as any other?",
            answer: |q| in_cells(q, |how| how.bend = |u| u.map(of_a_tent)),
        },
        Mistake {
            name: "crowds the points around the middle of their cells, as a normal distribution does",
            hint: "Is a place at the edge of a cell as likely as one in the middle?",
            answer: |q| in_cells(q, |how| how.bend = of_a_bell),
        },
        Mistake {
            name: "divides by one less than the number of columns and of rows",
            hint: "Where does the last cell end: at 1, or beyond it?",
            answer: |q| in_cells(q, |how| how.count = |count| (count - 1.0).max(Vec2::ONE)),
        },
        Mistake {
            name: "divides the random part along x by the number of rows, and that along y by the number of columns",
            hint: "How wide is a cell, and how high? By how much of that may its point move along each axis?",
            answer: |q| in_cells(q, |how| how.width = |count| count.yx()),
        },
        Mistake {
            name: "chooses places in the lower left quarter of each cell only",
            hint: "Can your point be anywhere in its cell? By how much do your two numbers move it at most?",
            answer: |q| in_cells(q, |how| how.to *= 0.5),
        },
    ];
}

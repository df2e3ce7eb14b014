//! `regular_grid`: random questions, judge and mistakes.

use super::points;
use crate::{Graded, Mistake, Verdict};
use glam::{Vec2, vec2};
use rand::RngExt;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch22_antialiasing::RegularGrid;

/// How far a point may be from its place, in pixels: column 999 is exact to 0.00006 in `f32`.
const TOLERANCE: f32 = 5e-4;

/// What a wrong formula makes of each cell (i, j) of (columns, rows).
fn cells(q: &RegularGrid, place: impl Fn(Vec2, Vec2) -> Vec2) -> Vec<Vec2> {
    let cells = (0..q.rows).flat_map(|j| (0..q.columns).map(move |i| vec2(i as f32, j as f32)));
    let (pixel, count) = (
        vec2(q.x as f32, q.y as f32),
        vec2(q.columns as f32, q.rows as f32),
    );
    cells.map(|cell| pixel + place(cell, count)).collect()
}

/// The same of a grid of other numbers of columns and rows; `place` is still given those of the question.
fn other_cells(
    q: &RegularGrid,
    [columns, rows]: [u32; 2],
    place: impl Fn(Vec2, Vec2) -> Vec2,
) -> Vec<Vec2> {
    let count = vec2(q.columns as f32, q.rows as f32);
    let other = RegularGrid {
        columns,
        rows,
        ..q.clone()
    };
    cells(&other, |cell, _| place(cell, count))
}

impl Graded for RegularGrid {
    fn random(rng: &mut Pcg) -> RegularGrid {
        RegularGrid {
            x: rng.random_range(0..1000),
            y: rng.random_range(0..1000),
            columns: rng.random_range(1..=6),
            rows: rng.random_range(1..=6),
        }
    }

    fn judge(_q: &RegularGrid, golden: &Vec<Vec2>, got: &Vec<Vec2>) -> Verdict {
        points::same_places(golden, got, TOLERANCE)
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "takes the cells' corners",
            hint: "With one cell, where should its point be: in the pixel's corner?",
            answer: |q| cells(q, |cell, count| cell / count),
        },
        Mistake {
            name: "reaches from edge to edge",
            hint: "The last point is on the pixel's edge, and so is the first one of the next pixel: how far apart should they be?",
            answer: |q| cells(q, |cell, count| cell / (count - 1.0).max(Vec2::ONE)),
        },
        Mistake {
            name: "leaves a whole cell at each edge",
            hint: "How far is the first point from the edge, and how far from its neighbour? Together with the next pixel's, all should be equally far apart.",
            answer: |q| cells(q, |cell, count| (cell + 1.0) / (count + 1.0)),
        },
        Mistake {
            name: "exchanges columns and rows",
            hint: "Try three columns and one row: are your points side by side?",
            answer: |q| {
                let exchanged = RegularGrid {
                    columns: q.rows,
                    rows: q.columns,
                    ..q.clone()
                };
                RegularGrid::right(&exchanged)
            },
        },
        Mistake {
            name: "stays in the first pixel",
            hint: "In which pixel are your points, if it is not the one at the top left?",
            answer: |q| {
                cells(
                    &RegularGrid {
                        x: 0,
                        y: 0,
                        ..q.clone()
                    },
                    |cell, count| (cell + 0.5) / count,
                )
            },
        },
        Mistake {
            name: "centres the cells around the pixel's corner",
            hint: "Pixel (x, y) begins at (x, y) and ends at (x + 1, y + 1): where is its middle?",
            answer: |q| cells(q, |cell, count| (cell + 0.5) / count - 0.5),
        },
        Mistake {
            name: "divides both by the number of columns",
            hint: "Are your cells square where the pixel is divided into more columns than rows?",
            answer: |q| cells(q, |cell, count| (cell + 0.5) / count.x),
        },
        Mistake {
            name: "divides the columns by the number of rows, and the rows by that of the columns",
            hint: "Try three columns and one row: how wide is a cell?",
            answer: |q| cells(q, |cell, count| (cell + 0.5) / vec2(count.y, count.x)),
        },
        Mistake {
            name: "puts all points into the middle of the pixel",
            hint: "Are i/columns and j/rows whole numbers in your language? What is 1/2 then?",
            answer: |q| cells(q, |_, _| Vec2::splat(0.5)),
        },
        Mistake {
            name: "puts all points into the middle of the first cell",
            hint: "Where does the number of a cell come in?",
            answer: |q| cells(q, |_, count| 0.5 / count),
        },
        Mistake {
            name: "adds the pixel's column and row before it divides",
            hint: "Which part of your sum is in cells, and which in pixels?",
            answer: |q| {
                let pixel = vec2(q.x as f32, q.y as f32);
                cells(q, |cell, count| (pixel + cell + 0.5) / count - pixel)
            },
        },
        Mistake {
            name: "goes one cell too far, along x and along y",
            hint: "How many points are there in a grid of two cells by two? Where do your loops end?",
            answer: |q| {
                other_cells(q, [q.columns + 1, q.rows + 1], |cell, count| {
                    (cell + 0.5) / count
                })
            },
        },
        Mistake {
            name: "leaves out the last column and the last row of cells",
            hint: "How many points are there in a grid of two cells by two? Where do your loops end?",
            answer: |q| {
                let fewer = [q.columns, q.rows].map(|count| count.saturating_sub(1));
                other_cells(q, fewer, |cell, count| (cell + 0.5) / count)
            },
        },
        Mistake {
            name: "counts the cells from 1",
            hint: "With one cell, which number has it in your loop, and where is its point?",
            answer: |q| cells(q, |cell, count| (cell + 1.5) / count),
        },
        Mistake {
            name: "takes the cells' lower right corners",
            hint: "With one cell, where should its point be: in the pixel's corner?",
            answer: |q| cells(q, |cell, count| (cell + 1.0) / count),
        },
        Mistake {
            name: "goes over as many columns as there are rows, and over as many rows as there are columns",
            hint: "Try three columns and one row: which of your two loops goes along x?",
            answer: |q| other_cells(q, [q.rows, q.columns], |cell, count| (cell + 0.5) / count),
        },
        Mistake {
            name: "divides a cell's number by the number of rows, not by that of the columns, to find its row",
            hint: "How many cells are counted before the first one of the second row?",
            answer: |q| {
                let cell = |i: u32| vec2((i % q.columns) as f32, (i / q.rows) as f32);
                let all = (0..q.columns * q.rows).map(cell);
                let count = vec2(q.columns as f32, q.rows as f32);
                let pixel = vec2(q.x as f32, q.y as f32);
                all.map(|cell| pixel + (cell + 0.5) / count).collect()
            },
        },
        Mistake {
            name: "moves by the row along x, and by the column along y",
            hint: "The second pixel of the first row has the column 1: where does it begin?",
            answer: |q| Self::misread(q, |q| (q.x, q.y) = (q.y, q.x)),
        },
        Mistake {
            name: "goes along the diagonal only, with one number for column and row",
            hint: "How many points are there in a grid of two cells by two? How many loops do you need?",
            answer: |q| {
                let square = [q.columns.min(q.rows), 1];
                other_cells(q, square, |cell, count| (cell.x + 0.5) / count)
            },
        },
        Mistake {
            name: "adds half of a cell's width along y too, and not half of its height",
            hint: "A cell may be wider than it is high: how far is its middle from its upper edge, and how far from its left one?",
            answer: |q| cells(q, |cell, count| cell / count + 0.5 / count.x),
        },
        Mistake {
            name: "adds half of a cell's height along x too, and not half of its width",
            hint: "A cell may be wider than it is high: how far is its middle from its upper edge, and how far from its left one?",
            answer: |q| cells(q, |cell, count| cell / count + 0.5 / count.y),
        },
        Mistake {
            name: "adds half of a cell's height along x, and half of its width along y",
            hint: "A cell may be wider than it is high: how far is its middle from its upper edge, and how far from its left one?",
            answer: |q| cells(q, |cell, count| cell / count + 0.5 / vec2(count.y, count.x)),
        },
    ];
}

//! `regular_grid`: random questions, judge and mistakes.

use super::points;
use crate::upon::changed;
use crate::{Graded, Mistake, Verdict};
use glam::{Vec2, Vec2Swizzles, vec2};
use rand::RngExt;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch22_antialiasing::RegularGrid;

/// How far a point may be from its place, in pixels: column 999 is exact to 0.00006 in `f32`.
const TOLERANCE: f32 = 5e-4;

/// How the points of a grid are found; one field wrong is a mistake.
#[derive(Clone, Copy)]
struct How {
    /// How many columns and rows are gone over.
    loops: [u32; 2],
    /// The column and the row of the cell that is number `i` of `columns`, where there are `rows`.
    cell: fn(i: u32, columns: u32, rows: u32) -> Vec2,
    /// What the column and the row are divided by, …
    count: Vec2,
    /// … what is added to them as a part of a cell, …
    part: Vec2,
    /// … and what that is divided by.
    part_of: Vec2,
    /// Where the pixel begins.
    pixel: Vec2,
}

impl How {
    /// As it should be.
    fn well(q: &RegularGrid) -> Self {
        let count = vec2(q.columns as f32, q.rows as f32);
        Self {
            loops: [q.columns, q.rows],
            cell: |i, columns, _| vec2((i % columns) as f32, (i / columns) as f32),
            count,
            part: Vec2::splat(0.5),
            part_of: count,
            pixel: vec2(q.x as f32, q.y as f32),
        }
    }

    /// Both are divided by the same.
    fn divide(&mut self, by: Vec2) {
        (self.count, self.part_of) = (by, by);
    }
}

/// The points, rightly but for what is changed.
fn in_cells(q: &RegularGrid, change: impl FnOnce(&mut How)) -> Vec<Vec2> {
    places(&changed(How::well(q), change))
}

fn places(how: &How) -> Vec<Vec2> {
    let [columns, rows] = how.loops;
    let cells = (0..columns * rows).map(|i| (how.cell)(i, columns, rows));
    let place = |cell| how.pixel + cell / how.count + how.part / how.part_of;
    cells.map(place).collect()
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
            answer: |q| in_cells(q, |how| how.part = Vec2::ZERO),
        },
        Mistake {
            name: "reaches from edge to edge",
            hint: "The last point is on the pixel's edge, and so is the first one of the next pixel: how far apart should they be?",
            answer: |q| {
                in_cells(q, |how| {
                    how.divide((how.count - 1.0).max(Vec2::ONE));
                    how.part = Vec2::ZERO;
                })
            },
        },
        Mistake {
            name: "reaches from edge to edge, and puts a single column or row into the middle",
            hint: "The last point is on the pixel's edge, and so is the first one of the next pixel: how far apart should they be?",
            answer: |q| {
                in_cells(q, |how| {
                    how.part = how.count.map(|count| if count > 1.0 { 0.0 } else { 0.5 });
                    how.count = (how.count - 1.0).max(Vec2::ONE);
                    how.part_of = Vec2::ONE;
                })
            },
        },
        Mistake {
            name: "leaves a whole cell at each edge",
            hint: "How far is the first point from the edge, and how far from its neighbour? Together with the next pixel's, all should be equally far apart.",
            answer: |q| {
                in_cells(q, |how| {
                    how.divide(how.count + 1.0);
                    how.part = Vec2::ONE;
                })
            },
        },
        Mistake {
            name: "exchanges columns and rows",
            hint: "Try three columns and one row: are your points side by side?",
            answer: |q| Self::misread(q, |q| (q.columns, q.rows) = (q.rows, q.columns)),
        },
        Mistake {
            name: "stays in the first pixel",
            hint: "In which pixel are your points, if it is not the one at the top left?",
            answer: |q| in_cells(q, |how| how.pixel = Vec2::ZERO),
        },
        Mistake {
            name: "adds the pixel's column only, and not its row",
            hint: "In which row of pixels are your points?",
            answer: |q| in_cells(q, |how| how.pixel.y = 0.0),
        },
        Mistake {
            name: "adds the pixel's row only, and not its column",
            hint: "In which column of pixels are your points?",
            answer: |q| in_cells(q, |how| how.pixel.x = 0.0),
        },
        Mistake {
            name: "centres the cells around the pixel's corner",
            hint: "Pixel (x, y) begins at (x, y) and ends at (x + 1, y + 1): where is its middle?",
            answer: |q| in_cells(q, |how| how.pixel -= 0.5),
        },
        Mistake {
            name: "divides both by the number of columns",
            hint: "Are your cells square where the pixel is divided into more columns than rows?",
            answer: |q| in_cells(q, |how| how.divide(how.count.xx())),
        },
        Mistake {
            name: "divides the columns by the number of rows, and the rows by that of the columns",
            hint: "Try three columns and one row: how wide is a cell?",
            answer: |q| in_cells(q, |how| how.divide(how.count.yx())),
        },
        Mistake {
            name: "puts all points into the middle of the pixel",
            hint: "Are i/columns and j/rows whole numbers in your language? What is 1/2 then?",
            answer: |q| {
                in_cells(q, |how| {
                    (how.cell, how.part_of) = (|_, _, _| Vec2::ZERO, Vec2::ONE);
                })
            },
        },
        Mistake {
            name: "puts all points into the middle of the first cell",
            hint: "Where does the number of a cell come in?",
            answer: |q| in_cells(q, |how| how.cell = |_, _, _| Vec2::ZERO),
        },
        Mistake {
            name: "adds the pixel's column and row before it divides",
            hint: "Which part of your sum is in cells, and which in pixels?",
            answer: |q| in_cells(q, |how| how.pixel /= how.count),
        },
        Mistake {
            name: "goes one cell too far, along x and along y",
            hint: "How many points are there in a grid of two cells by two? Where do your loops end?",
            answer: |q| in_cells(q, |how| how.loops = how.loops.map(|count| count + 1)),
        },
        Mistake {
            name: "leaves out the last column and the last row of cells",
            hint: "How many points are there in a grid of two cells by two? Where do your loops end?",
            answer: |q| {
                in_cells(q, |how| {
                    how.loops = how.loops.map(|count| count.saturating_sub(1));
                })
            },
        },
        Mistake {
            name: "counts the cells from 1",
            hint: "With one cell, which number has it in your loop, and where is its point?",
            answer: |q| in_cells(q, |how| how.part += 1.0),
        },
        Mistake {
            name: "takes the cells' lower right corners",
            hint: "With one cell, where should its point be: in the pixel's corner?",
            answer: |q| in_cells(q, |how| how.part = Vec2::ONE),
        },
        Mistake {
            name: "goes over as many columns as there are rows, and over as many rows as there are columns",
            hint: "Try three columns and one row: which of your two loops goes along x?",
            answer: |q| in_cells(q, |how| how.loops.reverse()),
        },
        Mistake {
            name: "divides a cell's number by the number of rows, not by that of the columns, to find its row",
            hint: "How many cells are counted before the first one of the second row?",
            answer: |q| {
                in_cells(q, |how| {
                    how.cell = |i, columns, rows| vec2((i % columns) as f32, (i / rows) as f32);
                })
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
                in_cells(q, |how| {
                    how.loops = [q.columns.min(q.rows), 1];
                    how.cell = |i, _, _| Vec2::splat(i as f32);
                })
            },
        },
        Mistake {
            name: "adds half of a cell's width along y too, and not half of its height",
            hint: "A cell may be wider than it is high: how far is its middle from its upper edge, and how far from its left one?",
            answer: |q| in_cells(q, |how| how.part_of = how.count.xx()),
        },
        Mistake {
            name: "adds half of a cell's height along x too, and not half of its width",
            hint: "A cell may be wider than it is high: how far is its middle from its upper edge, and how far from its left one?",
            answer: |q| in_cells(q, |how| how.part_of = how.count.yy()),
        },
        Mistake {
            name: "adds half of a cell's height along x, and half of its width along y",
            hint: "A cell may be wider than it is high: how far is its middle from its upper edge, and how far from its left one?",
            answer: |q| in_cells(q, |how| how.part_of = how.count.yx()),
        },
    ];
}

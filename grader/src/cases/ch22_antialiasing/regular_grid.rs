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
    ];
}

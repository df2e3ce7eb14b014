//! `jittered`: random questions, judge and mistakes.

use super::points;
use crate::{Graded, Mistake, Verdict};
use glam::{Vec2, vec2};
use rand::RngExt;
use raybook::math::pcg::{self, Pcg};
use raybook_workbook::exercise::Exercise;
use raybook_workbook::exercises::ch22_antialiasing::Jittered;

/// What a wrong formula makes of each cell (i, j) of (columns, rows) and two uniform numbers.
fn cells(q: &Jittered, place: impl Fn(Vec2, Vec2, Vec2) -> Vec2) -> Vec<Vec2> {
    let rng = &mut pcg::stream(22, q.seed.into());
    let count = vec2(q.columns as f32, q.rows as f32);
    let cells = (0..q.rows).flat_map(|j| (0..q.columns).map(move |i| vec2(i as f32, j as f32)));
    let place = |cell| {
        let u = vec2(rng.random(), rng.random());
        place(cell, count, u).min(Vec2::splat(1.0_f32.next_down()))
    };
    cells.map(place).collect()
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
        let mut cells = vec![0_u32; got.len()];
        let mut places = Vec::new();
        for p in got {
            let scaled = count * *p;
            let cell = scaled.floor().min(count - 1.0);
            cells[(cell.y * count.x + cell.x) as usize] += 1;
            places.push(scaled - cell);
        }
        // A point that is printed with six digits is moved by 5e-7, which is 1e-5 of a cell, perhaps over the edge.
        let on_edge = |p: &&Vec2| (**p - 0.5).abs().max_element() > 0.5 - 2e-5;
        let moved = places.iter().filter(on_edge).count();
        let wrong: Vec<_> = (0..).zip(&cells).filter(|(_, c)| **c != 1).collect();
        if wrong.len() > 2 * moved {
            let (i, points) = wrong[0];
            return Err(format!(
                "the cell in column {} and row {} has {points} points; each cell has one",
                i % q.columns,
                i / q.columns
            ));
        }
        if got.len() < 60 {
            return Ok(()); // too few to tell
        }
        points::uniform(
            "the place from left to right in a cell",
            places.iter().map(|p| p.x),
        )?;
        points::uniform(
            "the place from top to bottom in a cell",
            places.iter().map(|p| p.y),
        )?;
        points::independent("the places along x and y in a cell", places.iter().copied())
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "takes the cells' middles",
            hint: "Which of your points would be elsewhere with another seed?",
            answer: |q| cells(q, |cell, count, _| (cell + 0.5) / count),
        },
        Mistake {
            name: "throws anywhere in the square",
            hint: "How many of your points are in the first cell? And in the last?",
            answer: |q| cells(q, |_, _, u| u),
        },
        Mistake {
            name: "jitters around the cells' corners",
            hint: "Cell (i, j) begins at (i, j): can your point be before it?",
            answer: |q| {
                cells(q, |cell, count, u| {
                    ((cell + u - 0.5) / count).max(Vec2::ZERO)
                })
            },
        },
        Mistake {
            name: "moves all points by the same",
            hint: "Do all your points have the same place in their cells? One throw is not enough for all.",
            answer: |q| {
                let u: Vec2 = {
                    let rng = &mut pcg::stream(22, q.seed.into());
                    vec2(rng.random(), rng.random())
                };
                cells(q, |cell, count, _| (cell + u) / count)
            },
        },
        Mistake {
            name: "uses one number for both coordinates",
            hint: "Look at your points in their cells: are all of them on a diagonal?",
            answer: |q| cells(q, |cell, count, u| (cell + u.x) / count),
        },
        Mistake {
            name: "jitters by half a cell only",
            hint: "Can your point be anywhere in its cell, near its edges too?",
            answer: |q| cells(q, |cell, count, u| (cell + 0.25 + 0.5 * u) / count),
        },
        Mistake {
            name: "exchanges columns and rows",
            hint: "Try three columns and one row: are your points side by side?",
            answer: |q| {
                let exchanged = Jittered {
                    columns: q.rows,
                    rows: q.columns,
                    ..q.clone()
                };
                Jittered::answer(&exchanged)
            },
        },
        Mistake {
            name: "jitters along x only",
            hint: "How many different y have your points in one row of cells?",
            answer: |q| cells(q, |cell, count, u| (cell + vec2(u.x, 0.5)) / count),
        },
    ];
}

//! `refine_cell`: its mistakes.

use super::refine_cell_cases;
use super::refine_cell_judge::{self, depth};
use raybook::accel::lattice::Lattice;
use crate::{Graded, Mistake, Verdict};
use raybook::math::{aabb::Aabb, pcg::Pcg};
use raybook_workbook::exercise::Exercise;
use raybook_workbook::exercises::ch05_box::Corners;
use raybook_workbook::exercises::ch09_two_level_grid::{Entry, RefineCell, RefineCellAnswer};
use glam::UVec3;

/// The reference's answer with other boxes.
fn with_shapes(q: &RefineCell, shape: impl Fn(&Corners) -> Corners) -> RefineCellAnswer {
    RefineCell::misread(q, |q| q.shapes = q.shapes.iter().map(shape).collect())
}

impl Graded for RefineCell {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "ignores the density",
            hint: "Twice the density: how many more fine cells are there?",
            answer: |q| Self::misread(q, |q| q.density = 1.0),
        },
        Mistake {
            name: "gives every cell the same resolution",
            hint: "A cell with eight times as many shapes: how much finer is it cut along an axis?",
            answer: |q| cut(q, UVec3::splat(2)),
        },
        Mistake {
            name: "names a shape only where its middle is",
            hint: "A ray can hit a shape far from its middle: in which cell does it look for it?",
            answer: |q| {
                with_shapes(q, |shape| {
                    let middle = 0.5 * (shape.min + shape.max);
                    Corners {
                        min: middle,
                        max: middle,
                    }
                })
            },
        },
        Mistake {
            name: "names a shape only where its least corner is",
            hint: "Which cells are there between the one with the least corner and the one with the greatest?",
            answer: |q| {
                with_shapes(q, |shape| Corners {
                    min: shape.min,
                    max: shape.min,
                })
            },
        },
        Mistake {
            name: "cuts an empty cell too",
            hint: "What is there to be found in a cell without shapes?",
            answer: |q| {
                if q.shapes.is_empty() {
                    cut(q, UVec3::ONE)
                } else {
                    RefineCell::answer(q)
                }
            },
        },
        Mistake {
            name: "measures from the origin, not from the cell's corner",
            hint: "Where does the first fine cell begin?",
            answer: |q| {
                with_shapes(q, |shape| Corners {
                    min: shape.min + q.min,
                    max: shape.max + q.min,
                })
            },
        },
        Mistake {
            name: "drops shapes that reach out of the coarse cell",
            hint: "A shape lies in two coarse cells: which of them names it?",
            answer: |q| {
                let inside = |i: usize| {
                    let shape = &q.shapes[i];
                    shape.min.cmpge(q.min).all() && shape.max.cmple(q.max).all()
                };
                let mut answer = RefineCell::answer(q);
                answer.entries.retain(|entry| inside(entry.shape as usize));
                answer
            },
        },
        Mistake {
            name: "swaps x and z",
            hint: "How many fine cells are there along a long side of the cell, and how many along a short one?",
            answer: |q| {
                let answer = RefineCell::answer(q);
                let entry = |e: &Entry| Entry {
                    x: e.z,
                    z: e.x,
                    ..e.clone()
                };
                RefineCellAnswer {
                    nx: answer.nz,
                    nz: answer.nx,
                    entries: answer.entries.iter().map(entry).collect(),
                    ..answer
                }
            },
        },
    ];

    fn random(rng: &mut Pcg) -> RefineCell {
        refine_cell_cases::random(rng)
    }

    fn judge(q: &RefineCell, golden: &RefineCellAnswer, got: &RefineCellAnswer) -> Verdict {
        refine_cell_judge::judge(q, golden, got)
    }
}

/// The answer for a resolution of one's own.
fn cut(q: &RefineCell, along: UVec3) -> RefineCellAnswer {
    let bounds = Aabb {
        min: q.min,
        max: q.max,
    };
    let fine = Lattice::new(&bounds, along);
    let mut entries = Vec::new();
    for cell in fine.all() {
        for (shape, corners) in (0..).zip(&q.shapes) {
            if depth(&fine, cell, corners) >= 0.0 {
                entries.push(Entry {
                    x: cell.x,
                    y: cell.y,
                    z: cell.z,
                    shape,
                });
            }
        }
    }
    RefineCellAnswer {
        nx: along.x,
        ny: along.y,
        nz: along.z,
        entries,
    }
}

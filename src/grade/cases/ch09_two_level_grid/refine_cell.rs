//! `refine_cell`: its cases, judge and mistakes.

use super::refine_cell_judge::{TOLERANCE, cut, depth};
use crate::accel::lattice::Lattice;
use crate::grade::{Edge, Graded, Mistake, Verdict, sample};
use crate::math::{aabb::Aabb, pcg::Pcg};
use crate::workbook::exercise::Exercise;
use crate::workbook::exercises::ch05_box::Corners;
use crate::workbook::exercises::ch09_two_level_grid::{
    Entry, RefineCell, RefineCellAnswer, RefineCellQuestion,
};
use glam::{UVec3, Vec3, vec3};
use rand::RngExt;

/// The reference's answer with other boxes.
fn with_shapes(q: &RefineCellQuestion, shape: impl Fn(&Corners) -> Corners) -> RefineCellAnswer {
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

    fn edges() -> Vec<Edge<Self>> {
        let question = |max: Vec3, density, shapes: &[(Vec3, Vec3)]| RefineCellQuestion {
            min: vec3(1.0, 2.0, 3.0),
            max: vec3(1.0, 2.0, 3.0) + max,
            density,
            shapes: shapes
                .iter()
                .map(|&(min, max)| Corners { min, max })
                .collect(),
        };
        let edge =
            |name, max, density, shapes: &[_]| Edge::new(name, question(max, density, shapes));
        let corner = (vec3(1.1, 2.1, 3.1), vec3(1.3, 2.4, 3.2));
        let across = (vec3(1.2, 2.2, 3.2), vec3(2.8, 3.8, 3.4));
        let outside = (vec3(0.5, 1.5, 2.5), vec3(1.6, 2.4, 3.4));
        let larger = (Vec3::ZERO, Vec3::splat(9.0));
        let far = (vec3(2.7, 3.7, 4.7), vec3(2.9, 3.9, 4.9));
        let cube = Vec3::splat(2.0);
        vec![
            edge("no shapes", cube, 2.0, &[]),
            edge("one small shape", cube, 1.0, &[corner]),
            edge("one shape, eight fine cells", cube, 8.0, &[corner]),
            edge("one that reaches across", cube, 8.0, &[across]),
            edge("one that begins outside", cube, 8.0, &[outside]),
            edge("one larger than the cell", cube, 8.0, &[larger]),
            edge("in opposite corners", cube, 4.0, &[corner, far]),
            edge(
                "a long cell",
                vec3(8.0, 2.0, 1.0),
                4.0,
                &[corner, across, outside],
            ),
            edge("a flat cell", vec3(4.0, 4.0, 0.01), 4.0, &[larger, outside]),
        ]
    }

    fn random(rng: &mut Pcg) -> RefineCellQuestion {
        let min = sample::point(rng, 3.0);
        let size = vec3(
            sample::number(rng, 1.0, 4.0),
            sample::number(rng, 1.0, 4.0),
            sample::number(rng, 1.0, 4.0),
        );
        let shapes = (0..rng.random_range(2..6))
            .map(|_| {
                let middle = min + size * (sample::point(rng, 0.55) + 0.5);
                let half = 0.2 * size * (sample::point(rng, 0.5) + 0.5);
                // All of them reach the cell.
                let middle = middle.clamp(min - 0.5 * half, min + size + 0.5 * half);
                Corners {
                    min: middle - half,
                    max: middle + half,
                }
            })
            .collect();
        RefineCellQuestion {
            min,
            max: min + size,
            density: sample::number(rng, 2.0, 6.0),
            shapes,
        }
    }

    fn judge(q: &RefineCellQuestion, golden: &RefineCellAnswer, got: &RefineCellAnswer) -> Verdict {
        let cells = |n: &RefineCellAnswer| UVec3::new(n.nx, n.ny, n.nz);
        let (right, along) = (cells(golden), cells(got));
        if right != along {
            return Err(format!(
                "you cut it into {} × {} × {} fine cells, and {} × {} × {} are asked for",
                along.x, along.y, along.z, right.x, right.y, right.z
            ));
        }
        if right == UVec3::ZERO {
            return Ok(());
        }
        let bounds = Aabb {
            min: q.min,
            max: q.max,
        };
        let fine = Lattice::new(&bounds, right);
        for (i, entry) in got.entries.iter().enumerate() {
            let cell = UVec3::new(entry.x, entry.y, entry.z);
            let Some(shape) = q.shapes.get(entry.shape as usize) else {
                return Err(format!("there is no shape {}", entry.shape));
            };
            if cell.cmpge(right).any() {
                return Err(format!("there is no cell {cell}"));
            }
            if got.entries[..i].contains(entry) {
                return Err(format!("shape {} is twice in cell {cell}", entry.shape));
            }
            if depth(&fine, cell, shape) < -TOLERANCE {
                return Err(format!("shape {} does not reach cell {cell}", entry.shape));
            }
        }
        let missing = golden.entries.iter().find(|entry| {
            let cell = UVec3::new(entry.x, entry.y, entry.z);
            let deep = depth(&fine, cell, &q.shapes[entry.shape as usize]) > TOLERANCE;
            deep && !got.entries.contains(entry)
        });
        match missing {
            Some(Entry { x, y, z, shape }) => Err(format!(
                "shape {shape} reaches cell [{x}, {y}, {z}], which does not name it"
            )),
            None => Ok(()),
        }
    }
}

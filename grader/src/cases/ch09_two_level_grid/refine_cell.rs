//! `refine_cell`: random questions, judge and mistakes.

mod refinements;

use crate::{Flaw, Graded, Mistake, Relation, Verdict, sample};
use glam::{UVec3, Vec3, vec3};
use rand::RngExt;
use raybook::inside::grid::Lattice;
use raybook::math::{aabb::Aabb, pcg::Pcg};
use raybook_workbook::exercises::ch05_box::Corners;
use raybook_workbook::exercises::ch09_two_level_grid::{Entry, RefineCell, RefineCellAnswer};
use refinements::{
    Last, at, by_overlap, cut, cut_by, cut_for, middle, reached, reaches, reaches_along,
    resolution, with_cells, with_numbers, with_places, with_shapes, within, without_last,
    without_shapes, without_those_outside,
};
use std::collections::HashSet;

impl Graded for RefineCell {
    fn random(rng: &mut Pcg) -> RefineCell {
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
        RefineCell {
            min,
            max: min + size,
            density: sample::number(rng, 2.0, 6.0),
            shapes,
        }
    }

    fn crowded(rng: &mut Pcg, count: usize) -> Option<RefineCell> {
        let size = vec3(2.0, 3.0, 1.4);
        let shapes = (0..count).map(|_| {
            let middle = size * (sample::point(rng, 0.5) + 0.5);
            let half = 0.04 * size * (sample::point(rng, 0.5) + 0.5);
            Corners {
                min: middle - half,
                max: middle + half,
            }
        });
        Some(RefineCell {
            min: Vec3::ZERO,
            max: size,
            density: 2.0,
            shapes: shapes.collect(),
        })
    }

    /// The resolution, then every shape in the cells that it reaches and in no other.
    fn is_sound(q: &RefineCell) -> bool {
        let mut shapes = q.shapes.iter();
        sample::is_box(q.min, q.max) && shapes.all(|shape| sample::is_box(shape.min, shape.max))
    }

    fn judge(q: &RefineCell, golden: &RefineCellAnswer, got: &RefineCellAnswer) -> Verdict {
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
        let pair = |entry: &Entry| (entry.x, entry.y, entry.z, entry.shape);
        let mut met = HashSet::new();
        for entry in &got.entries {
            let cell = UVec3::new(entry.x, entry.y, entry.z);
            let Some(shape) = q.shapes.get(entry.shape as usize) else {
                return Err(format!("there is no shape {}", entry.shape));
            };
            if cell.cmpge(right).any() {
                return Err(format!("there is no cell {cell}"));
            }
            if !met.insert(pair(entry)) {
                return Err(format!("shape {} is twice in cell {cell}", entry.shape));
            }
            if depth(&fine, cell, shape) < -TOLERANCE {
                return Err(format!("shape {} does not reach cell {cell}", entry.shape));
            }
        }
        let missing = golden.entries.iter().find(|entry| {
            let cell = UVec3::new(entry.x, entry.y, entry.z);
            let shape = q.shapes.get(entry.shape as usize);
            let shape = shape.filter(|_| cell.cmplt(right).all());
            let deep = shape.is_some_and(|shape| depth(&fine, cell, shape) > TOLERANCE);
            deep && !met.contains(&pair(entry))
        });
        match missing {
            Some(Entry { x, y, z, shape }) => Err(format!(
                "shape {shape} reaches cell [{x}, {y}, {z}], which does not name it"
            )),
            None => Ok(()),
        }
    }

    const POSITIVE: &'static [&'static str] = &["density"];

    const FLAWS: &'static [Flaw] = &[
        Flaw {
            complaint: "are asked for",
            name: "cuts the cell into a wrong number of fine cells",
            hint: "What are the extents of the cell, how many shapes are in it, and how many cells are allowed along an axis?",
        },
        Flaw {
            complaint: "there is no shape",
            name: "counts the shapes from 1",
            hint: "What is the number of the first shape?",
        },
        Flaw {
            complaint: "there is no cell",
            name: "names cells that are not there",
            hint: "What are the numbers of the first and the last cell along each axis?",
        },
        Flaw {
            complaint: "is twice in cell",
            name: "names a shape twice in the same cell",
            hint: "How often is each pair of a cell and a shape appended?",
        },
        Flaw {
            complaint: "does not reach cell",
            name: "names shapes in cells that they do not reach",
            hint: "Does the shape's box overlap the cell along all three axes?",
        },
        Flaw {
            complaint: "which does not name it",
            name: "leaves shapes out of cells that they reach",
            hint: "A shape may reach several cells, and beyond the coarse cell: does your test find it in all of them?",
        },
    ];

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| {
        let moved = |shape: &Corners| Corners {
            min: shape.min + sample::METRE,
            max: shape.max + sample::METRE,
        };
        RefineCell {
            min: q.min + sample::METRE,
            max: q.max + sample::METRE,
            shapes: q.shapes.iter().map(moved).collect(),
            ..q.clone()
        }
    })];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "ignores the density",
            hint: "Twice the density: how many times as many fine cells are there?",
            answer: |q| Self::misread(q, |q| q.density = 1.0),
        },
        Mistake {
            name: "takes the resolution for the extents of the box around the shapes, and not for those of the cell",
            hint: "A cell with a single small shape: what is cut into fine cells, the shape's box or the cell?",
            answer: |q| {
                let around = Aabb::of(q.shapes.iter().flat_map(|shape| [shape.min, shape.max]));
                cut_for(q, around.size(), q.shapes.len(), 255)
            },
        },
        Mistake {
            name: "gives every cell the same resolution",
            hint: "A cell with eight times as many shapes: how much finer is it cut along an axis?",
            answer: |q| cut(q, UVec3::splat(2)),
        },
        Mistake {
            name: "names a shape only where its middle is",
            hint: "A ray can hit a shape far from the shape's middle: in which cells must the ray find the shape?",
            answer: |q| with_shapes(q, middle),
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
            name: "names every shape in the first fine cell",
            hint: "A shape reaches fine cells: of which grid are the numbers that you name, of the fine one or of the coarse one?",
            answer: |q| {
                let right = RefineCell::right(q);
                let first = |shape| Entry {
                    x: 0,
                    y: 0,
                    z: 0,
                    shape,
                };
                let entries = (0..q.shapes.len() as u32).map(first).collect();
                RefineCellAnswer { entries, ..right }
            },
        },
        Mistake {
            name: "cuts an empty cell too",
            hint: "What is there to be found in a cell without shapes?",
            answer: |q| {
                if q.shapes.is_empty() {
                    cut(q, UVec3::ONE)
                } else {
                    RefineCell::right(q)
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
                without_shapes(q, |shape| {
                    shape.min.cmplt(q.min).any() || shape.max.cmpgt(q.max).any()
                })
            },
        },
        Mistake {
            name: "swaps x and z",
            hint: "How many fine cells are there along a long side of the cell, and how many along a short one?",
            answer: |q| {
                let answer = RefineCell::right(q);
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
        Mistake {
            name: "cuts an axis into more than 255 cells",
            hint: "A resolution is kept in a byte: which is the largest number in it?",
            answer: |q| cut_for(q, q.max - q.min, q.shapes.len(), u32::MAX),
        },
        Mistake {
            name: "names only shapes that lie within a cell as a whole",
            hint: "A shape that sticks out of a cell: which list finds the part inside?",
            answer: |q| {
                let mut answer = RefineCell::right(q);
                let n = UVec3::new(answer.nx, answer.ny, answer.nz).as_vec3();
                let size = (q.max - q.min) / n.max(Vec3::ONE);
                answer.entries.retain(|entry| {
                    let low = q.min + size * UVec3::new(entry.x, entry.y, entry.z).as_vec3();
                    let shape = &q.shapes[entry.shape as usize];
                    shape.min.cmpge(low).all() && shape.max.cmple(low + size).all()
                });
                answer
            },
        },
        Mistake {
            name: "ignores the number of shapes",
            hint: "A cell with eight times as many shapes: how many times as many fine cells does it get?",
            answer: |q| cut_for(q, q.max - q.min, 1, 255),
        },
        Mistake {
            name: "leaves out the last cell that a shape reaches, along each axis",
            hint: "A shape within one cell: how often does your loop go round?",
            answer: |q| without_last(q, [true; 3], Last::Always),
        },
        Mistake {
            name: "leaves out the last cell that a shape reaches, along x",
            hint: "A shape within one cell: how often does your loop over x go round?",
            answer: |q| without_last(q, [true, false, false], Last::Always),
        },
        Mistake {
            name: "leaves out the last cell that a shape reaches, along y",
            hint: "A shape within one cell: how often does your loop over y go round?",
            answer: |q| without_last(q, [false, true, false], Last::Always),
        },
        Mistake {
            name: "leaves out the last cell that a shape reaches, along z",
            hint: "A shape within one cell: how often does your loop over z go round?",
            answer: |q| without_last(q, [false, false, true], Last::Always),
        },
        Mistake {
            name: "allows 256 cells along an axis",
            hint: "A resolution is kept in a byte: which is the largest number in it?",
            answer: |q| cut_for(q, q.max - q.min, q.shapes.len(), 256),
        },
        Mistake {
            name: "names a shape only where its middle is, and loses one whose middle is outside",
            hint: "A ray can hit a shape far from the shape's middle: in which cells must the ray find the shape?",
            answer: |q| without_those_outside(q, middle),
        },
        Mistake {
            name: "measures from the origin, and loses the shapes that are then outside",
            hint: "Where does the first fine cell begin?",
            answer: |q| {
                without_those_outside(q, |shape| Corners {
                    min: shape.min + q.min,
                    max: shape.max + q.min,
                })
            },
        },
        Mistake {
            name: "takes the coarse cell's greatest corner for its extents",
            hint: "How long is a cell that begins at x = 2 and ends at x = 3?",
            answer: |q| cut_for(q, q.max.max(Vec3::ZERO), q.shapes.len(), 255),
        },
        Mistake {
            name: "divides the coarse cell's greatest corner, not its extents, for a fine cell's extents",
            hint: "How long is a fine cell, if four of them lie between x = 2 and x = 3?",
            answer: |q| {
                let right = RefineCell::right(q);
                let n = resolution(&right);
                with_numbers(right, q, q.max / n, |begin, end, last| {
                    (begin.floor().max(Vec3::ZERO), end.floor().min(last))
                })
            },
        },
        Mistake {
            name: "drops shapes that begin before the coarse cell",
            hint: "A shape lies in two coarse cells: which of them names it?",
            answer: |q| without_shapes(q, |shape| shape.min.cmplt(q.min).any()),
        },
        Mistake {
            name: "drops shapes that end behind the coarse cell",
            hint: "A shape lies in two coarse cells: which of them names it?",
            answer: |q| without_shapes(q, |shape| shape.max.cmpgt(q.max).any()),
        },
        Mistake {
            name: "leaves out the last cell that a shape reaches along each axis, unless it is the only one",
            hint: "A shape reaches from cell 1 to cell 3: how often does your loop go round?",
            answer: |q| without_last(q, [true; 3], Last::UnlessAlone),
        },
        Mistake {
            name: "counts only the shapes whose middles are in the cell",
            hint: "A shape whose middle is in the next coarse cell reaches into this one: is it one of this cell's shapes?",
            answer: |q| {
                let bounds = Aabb::new(q.min, q.max);
                let inside = q
                    .shapes
                    .iter()
                    .filter(|shape| bounds.contains(middle(shape).min));
                match inside.count() {
                    0 => cut(q, UVec3::ZERO),
                    count => cut_for(q, q.max - q.min, count, 255),
                }
            },
        },
        Mistake {
            name: "counts only the shapes that lie within the cell as a whole",
            hint: "A shape that reaches into the next coarse cell reaches into this one, too: is it one of this cell's shapes?",
            answer: |q| {
                let bounds = Aabb::new(q.min, q.max);
                let is_inside =
                    |shape: &&Corners| bounds.contains(shape.min) && bounds.contains(shape.max);
                match q.shapes.iter().filter(is_inside).count() {
                    0 => cut(q, UVec3::ZERO),
                    count => cut_for(q, q.max - q.min, count, 255),
                }
            },
        },
        Mistake {
            name: "cuts every axis into equally many fine cells",
            hint: "A cell is twice as long as it is wide, and its fine cells are about cubes: are there as many along both sides?",
            answer: |q| cut_for(q, Vec3::ONE, q.shapes.len(), 255),
        },
        Mistake {
            name: "keeps a resolution in a byte without a limit, so that 256 becomes 0 again",
            hint: "What becomes of 400 in a byte, and what does the task want instead?",
            answer: |q| cut_by(q, q.max - q.min, q.shapes.len(), |n| n & UVec3::splat(255)),
        },
        Mistake {
            name: "rounds up for the number of the last cell that a shape reaches",
            hint: "A shape ends at 2.1 cells from the corner, where the first cell begins at 0: in which cell is that?",
            answer: |q| {
                with_cells(q, |begin, end, last| {
                    (begin.floor().max(Vec3::ZERO), end.ceil().min(last))
                })
            },
        },
        Mistake {
            name: "rounds to the nearest number of a cell",
            hint: "A shape begins at 0.7 cells from the corner, where the first cell begins at 0: in which cell is that?",
            answer: |q| {
                let mut answer = with_cells(q, |begin, end, last| {
                    let number = |at: Vec3| (at + 0.5).floor().clamp(Vec3::ZERO, last);
                    (number(begin), number(end))
                });
                let inside = |entry: &Entry| reaches(q, &q.shapes[entry.shape as usize]);
                answer.entries.retain(inside);
                answer
            },
        },
        Mistake {
            name: "counts a shape's cells by its extents, wherever in its first cell it begins",
            hint: "A shape as long as half a cell: in how many cells is it if it begins at 0.8 cells from the corner?",
            answer: |q| {
                with_cells(q, |begin, end, last| {
                    let (first, more) = (begin.floor(), (end - begin).floor());
                    (first.max(Vec3::ZERO), (first + more).min(last))
                })
            },
        },
        Mistake {
            name: "names a shape only in the cells of its box's eight corners",
            hint: "A long shape reaches from cell 1 to cell 5: in which cells between is none of its corners?",
            answer: |q| {
                let mut answer = RefineCell::right(q);
                let reached = reached(q, &answer);
                answer.entries.retain(|entry| {
                    let mut along = reached[entry.shape as usize].into_iter().zip(at(entry));
                    along.all(|(ends, at)| ends.contains(&at))
                });
                answer
            },
        },
        Mistake {
            name: "divides the coarse cell's extents by one less than the number of fine cells, as between fence posts",
            hint: "Four fine cells side by side: how many planes are there, and how long is each of the cells?",
            answer: |q| by_overlap(q, |n| (n - 1.0).max(Vec3::ONE), within),
        },
        Mistake {
            name: "divides the coarse cell's extents by one more than the number of fine cells",
            hint: "Four fine cells side by side: how many planes are there, and how long is each of the cells?",
            answer: |q| by_overlap(q, |n| n + 1.0, within),
        },
        Mistake {
            name: "multiplies the place in the coarse cell, from 0 to 1, by one less than the number of fine cells, and rounds",
            hint: "The place is 0.2, and there are four fine cells: in which of them is it, and what does your formula say?",
            answer: |q| {
                with_places(q, |place, last| {
                    let number = |x: f32| x.round_ties_even();
                    (place * last).map(number).clamp(Vec3::ZERO, last)
                })
            },
        },
        Mistake {
            name: "names shapes in cells that they reach along one axis, where they must along all three",
            hint: "A shape beside a cell and as high as it: does it reach the cell?",
            answer: |q| by_overlap(q, |n| n, |cell, shape| reaches_along(cell, shape).any()),
        },
        Mistake {
            name: "asks only whether an end of the shape lies in the cell, along each axis",
            hint: "A shape begins before a cell and ends behind it: does it reach the cell?",
            answer: |q| {
                by_overlap(
                    q,
                    |n| n,
                    |cell, shape| {
                        let holds = |p: Vec3| p.cmpge(cell.min) & p.cmple(cell.max);
                        (holds(shape.min) | holds(shape.max)).all()
                    },
                )
            },
        },
        Mistake {
            name: "takes the longest side of a fine cell for its extents along all three axes",
            hint: "Along each axis the fine cells fill the coarse cell: how long are they along x, along y and along z?",
            answer: |q| {
                let longest = |n: Vec3| {
                    let size = q.max - q.min;
                    size / (size / n).max_element()
                };
                by_overlap(q, longest, within)
            },
        },
        Mistake {
            name: "multiplies the place in the coarse cell, from 0 to 1, by one more than the number of fine cells",
            hint: "The place is 0.9, and there are four fine cells: in which of them is it, and what does your formula say?",
            answer: |q| {
                with_places(q, |place, last| {
                    (place * (last + 2.0)).floor().clamp(Vec3::ZERO, last)
                })
            },
        },
        Mistake {
            name: "names a shape only where its middle is, and in both cells if that is between them",
            hint: "A ray can hit a shape far from the shape's middle: in which cells must the ray find the shape?",
            answer: |q| {
                by_overlap(
                    q,
                    |n| n,
                    |cell, shape| {
                        let middle = 0.5 * (shape.min + shape.max);
                        (middle.cmpge(cell.min) & middle.cmple(cell.max)).all()
                    },
                )
            },
        },
    ];
}

/// A shape may reach a cell by so little, in metres, or miss it, and either answer is right.
const TOLERANCE: f32 = 1e-4;

/// How far a box reaches into a cell; negative if it does not.
fn depth(fine: &Lattice, cell: UVec3, shape: &Corners) -> f32 {
    let Aabb { min, max } = fine.bounds_of(cell, cell);
    (shape.max.min(max) - shape.min.max(min)).min_element()
}

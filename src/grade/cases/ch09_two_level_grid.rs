//! Chapter 9: `refine_cell`, `two_level_walk`.

use crate::accel::lattice::Lattice;
use crate::grade::examine::Examiner;
use crate::grade::passage::passage;
use crate::grade::{Edge, Graded, Mistake, Verdict, sample};
use crate::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use crate::workbook::exercise::Exercise;
use crate::workbook::exercises::ch05_box::Corners;
use crate::workbook::exercises::ch09_two_level_grid::{
    Entry, RefineCell, RefineCellAnswer, RefineCellQuestion, Resolution, TwoLevelWalk,
    TwoLevelWalkQuestion,
};
use glam::{UVec3, Vec3, vec3};
use rand::RngExt;

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&RefineCell, &TwoLevelWalk];

/// The reference's answer with other boxes.
fn with_shapes(q: &RefineCellQuestion, shape: impl Fn(&Corners) -> Corners) -> RefineCellAnswer {
    RefineCell::answer(&RefineCellQuestion {
        shapes: q.shapes.iter().map(shape).collect(),
        ..q.clone()
    })
}

impl Graded for RefineCell {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "ignores the density",
            hint: "Twice the density: how many more fine cells are there?",
            answer: |q| {
                RefineCell::answer(&RefineCellQuestion {
                    density: 1.0,
                    ..q.clone()
                })
            },
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
        let corner = (vec3(1.1, 2.1, 3.1), vec3(1.3, 2.4, 3.2));
        let across = (vec3(1.2, 2.2, 3.2), vec3(2.8, 3.8, 3.4));
        let outside = (vec3(0.5, 1.5, 2.5), vec3(1.6, 2.4, 3.4));
        let larger = (Vec3::ZERO, Vec3::splat(9.0));
        let far = (vec3(2.7, 3.7, 4.7), vec3(2.9, 3.9, 4.9));
        let cube = Vec3::splat(2.0);
        vec![
            Edge::new("no shapes", question(cube, 2.0, &[])),
            Edge::new("one small shape", question(cube, 1.0, &[corner])),
            Edge::new(
                "one shape, eight fine cells",
                question(cube, 8.0, &[corner]),
            ),
            Edge::new("one that reaches across", question(cube, 8.0, &[across])),
            Edge::new("one that begins outside", question(cube, 8.0, &[outside])),
            Edge::new("one larger than the cell", question(cube, 8.0, &[larger])),
            Edge::new("in opposite corners", question(cube, 4.0, &[corner, far])),
            Edge::new(
                "a long cell",
                question(vec3(8.0, 2.0, 1.0), 4.0, &[corner, across, outside]),
            ),
            Edge::new(
                "a flat cell",
                question(vec3(4.0, 4.0, 0.01), 4.0, &[larger, outside]),
            ),
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

/// A shape may reach a cell by so little, in metres, or miss it, and either answer is right.
const TOLERANCE: f32 = 1e-4;

/// How far a box reaches into a cell; negative if it does not.
fn depth(fine: &Lattice, cell: UVec3, shape: &Corners) -> f32 {
    let Aabb { min, max } = fine.bounds_of(cell, cell);
    (shape.max.min(max) - shape.min.max(min)).min_element()
}

/// The answer for a resolution of one's own.
fn cut(q: &RefineCellQuestion, along: UVec3) -> RefineCellAnswer {
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

/// The boxes of all fine cells, in the row of all.
fn cells(q: &TwoLevelWalkQuestion) -> Vec<Aabb> {
    let levels = q.levels();
    let fine = levels.top.all().filter_map(|coarse| levels.fine(coarse));
    fine.flat_map(|(_, fine)| fine.all().map(move |cell| fine.bounds_of(cell, cell)))
        .collect()
}

/// The walk's cells grouped by the coarse cell in which they are: its first cell's place, and their places.
fn by_coarse_cell(q: &TwoLevelWalkQuestion) -> Vec<(u32, u32, Vec<u32>)> {
    let levels = q.levels();
    let mut groups: Vec<(u32, u32, Vec<u32>)> = Vec::new();
    for place in TwoLevelWalk::answer(q) {
        let cut = levels
            .cuts
            .iter()
            .rfind(|cut| cut.first <= place && cut.resolution.x > 0);
        let (first, count) = cut.map_or((0, 0), |cut| {
            (cut.first, cut.resolution.as_uvec3().element_product())
        });
        match groups.last_mut() {
            Some((last, _, places)) if *last == first => places.push(place),
            _ => groups.push((first, count, vec![place])),
        }
    }
    groups
}

impl Graded for TwoLevelWalk {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "visits all fine cells of a coarse cell",
            hint: "Which fine cells does the ray pass through?",
            answer: |q| {
                let groups = by_coarse_cell(q).into_iter();
                groups
                    .flat_map(|(first, count, _)| first..first + count)
                    .collect()
            },
        },
        Mistake {
            name: "visits the fine cells in the order in which they are stored",
            hint: "A ray that runs towards −x meets the last cell of a row first.",
            answer: |q| {
                let groups = by_coarse_cell(q).into_iter();
                groups
                    .flat_map(|(_, _, mut places)| {
                        places.sort_unstable();
                        places
                    })
                    .collect()
            },
        },
        Mistake {
            name: "numbers the fine cells of each coarse cell from 0",
            hint: "All fine cells are in one row: where do those of this coarse cell begin?",
            answer: |q| {
                let groups = by_coarse_cell(q).into_iter();
                groups
                    .flat_map(|(first, _, places)| {
                        places.into_iter().map(move |place| place - first)
                    })
                    .collect()
            },
        },
        Mistake {
            name: "stops after the first coarse cell that is not empty",
            hint: "If there is no hit in it, where does the ray go on?",
            answer: |q| {
                by_coarse_cell(q)
                    .into_iter()
                    .next()
                    .map_or(Vec::new(), |group| group.2)
            },
        },
        Mistake {
            name: "visits the first fine cell of each coarse cell only",
            hint: "The inner walk takes more than one step: how many?",
            answer: |q| {
                by_coarse_cell(q)
                    .into_iter()
                    .map(|group| group.2[0])
                    .collect()
            },
        },
        Mistake {
            name: "goes on behind the end of the interval",
            hint: "What is the interval's max for?",
            answer: |q| {
                TwoLevelWalk::answer(&TwoLevelWalkQuestion {
                    within: Interval::new(q.within.min, f32::INFINITY),
                    ..q.clone()
                })
            },
        },
        Mistake {
            name: "takes the first cell's resolution for all",
            hint: "Each coarse cell is cut in its own way: where is that stored?",
            answer: |q| {
                let first = q.fine.iter().find(|r| r.nx > 0).cloned();
                let same = |r: &Resolution| match &first {
                    Some(first) if r.nx > 0 => first.clone(),
                    _ => r.clone(),
                };
                TwoLevelWalk::answer(&TwoLevelWalkQuestion {
                    fine: q.fine.iter().map(same).collect(),
                    ..q.clone()
                })
            },
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let cut = |nx, ny, nz| Resolution { nx, ny, nz };
        let q = |origin: Vec3, toward: Vec3, within| TwoLevelWalkQuestion {
            ray: Ray::new(origin, Dir3::new_or(toward, Dir3::X)),
            within,
            min: Vec3::ZERO,
            max: vec3(8.0, 8.0, 4.0),
            coarse: cut(2, 2, 1),
            fine: vec![cut(1, 1, 1), cut(4, 2, 2), cut(0, 0, 0), cut(2, 2, 1)],
        };
        let ahead = Interval::AHEAD;
        let from = vec3(-2.0, 1.0, 1.0);
        vec![
            Edge::new("along +x", q(from, Vec3::X, ahead)),
            Edge::new(
                "along −x, with −0.0",
                q(vec3(11.0, 1.0, 1.0), vec3(-1.0, -0.0, -0.0), ahead),
            ),
            Edge::new(
                "through an empty coarse cell",
                q(vec3(-1.0, 5.0, 1.0), vec3(1.0, 0.1, 0.0), ahead),
            ),
            Edge::new(
                "across, from the upper right",
                q(vec3(10.0, 9.0, 3.0), vec3(-1.0, -0.8, -0.1), ahead),
            ),
            Edge::new(
                "in the plane between coarse cells",
                q(vec3(4.0, -1.0, 1.0), Vec3::Y, ahead),
            ),
            Edge::new(
                "in a plane between fine cells",
                q(vec3(6.0, -1.0, 1.0), Vec3::Y, ahead),
            ),
            Edge::new(
                "through a corner of four coarse cells",
                q(vec3(8.5, 8.5, 1.0), vec3(-1.0, -1.0, 0.0), ahead),
            ),
            Edge::new(
                "from inside",
                q(vec3(5.5, 1.0, 3.0), vec3(1.0, 0.3, -0.4), ahead),
            ),
            Edge::new(
                "ends in the first coarse cell",
                q(from, vec3(1.0, 0.1, 0.1), Interval::new(0.0, 4.0)),
            ),
            Edge::new(
                "begins in the second coarse cell",
                q(from, vec3(1.0, 0.1, 0.1), Interval::new(7.0, 40.0)),
            ),
            Edge::new(
                "passes the grid by",
                q(vec3(-2.0, 9.0, 1.0), Vec3::X, ahead),
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> TwoLevelWalkQuestion {
        let min = sample::point(rng, 3.0);
        let size = vec3(
            sample::number(rng, 2.0, 6.0),
            sample::number(rng, 2.0, 6.0),
            sample::number(rng, 2.0, 6.0),
        );
        let mut along = |least| rng.random_range(least..4_u32);
        let coarse = Resolution {
            nx: along(2),
            ny: along(1),
            nz: along(1),
        };
        let count = coarse.nx * coarse.ny * coarse.nz;
        let fine = (0..count)
            .map(|_| {
                let (nx, ny, nz) = (along(0), along(1), along(1));
                let some = u32::from(nx > 0);
                Resolution {
                    nx,
                    ny: ny * some,
                    nz: nz * some,
                }
            })
            .collect();
        let inside = min + size * (sample::point(rng, 0.35) + 0.5);
        let origin = if rng.random_bool(0.3) {
            min + size * (sample::point(rng, 0.5) + 0.5)
        } else {
            inside + size.max_element() * 1.5 * *sample::direction(rng)
        };
        let end = if rng.random_bool(0.3) {
            size.max_element()
        } else {
            f32::INFINITY
        };
        TwoLevelWalkQuestion {
            ray: Ray::new(origin, Dir3::new_or(inside - origin, Dir3::X)),
            within: Interval::new(0.0, end),
            min,
            max: min + size,
            coarse,
            fine,
        }
    }

    fn judge(q: &TwoLevelWalkQuestion, golden: &Vec<u32>, got: &Vec<u32>) -> Verdict {
        passage("cell", &cells(q), &q.ray, q.within, golden, got)
    }
}

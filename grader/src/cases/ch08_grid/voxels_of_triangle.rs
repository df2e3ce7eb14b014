//! `voxels_of_triangle`: random questions, judge and mistakes.

mod overlaps;
mod points;

use crate::{Flaw, Graded, Mistake, Relation, Verdict, sample};
use glam::{UVec3, Vec3, uvec3, vec3};
use overlaps::{
    an_edge_passes, around, bare, corners, cuts_an_edge, found, no_edge_parts, normal, plane_cuts,
};
use points::{BETWEEN, hold_a_corner, hold_a_point, hold_the_middle};
use rand::RngExt;
use raybook::inside::grid::{self, triangle_meets_box};
use raybook::math::{aabb::Aabb, pcg::Pcg};
use raybook_workbook::exercises::ch08_grid::{Cell, VoxelsOfTriangle};

impl Graded for VoxelsOfTriangle {
    fn random(rng: &mut Pcg) -> VoxelsOfTriangle {
        let cell = vec3(1.0, 0.8, 1.1) * sample::number(rng, 0.5, 1.5);
        let min = sample::point(rng, 3.0);
        let n = uvec3(
            rng.random_range(2..6),
            rng.random_range(2..6),
            rng.random_range(2..5),
        );
        let extents = n.as_vec3() * cell;
        let center = min + 0.5 * extents;
        let half = 0.5 * sample::number(rng, 0.5, 1.1) * extents;
        let mut corner = || center + sample::point(rng, 1.0) * half;
        let (p0, p1, p2) = (corner(), corner(), corner());
        VoxelsOfTriangle {
            min,
            cell,
            nx: n.x,
            ny: n.y,
            nz: n.z,
            margin: sample::number(rng, 0.0, 0.15),
            p0,
            p1,
            p2,
        }
    }

    fn is_sound(q: &VoxelsOfTriangle) -> bool {
        sample::is_triangle([q.p0, q.p1, q.p2])
    }

    fn judge(q: &VoxelsOfTriangle, _golden: &Vec<Cell>, got: &Vec<Cell>) -> Verdict {
        // A cell that the triangle only touches is nobody's fault: these must be there, and only those may be.
        let hair = hair(q);
        let with = |margin| grid::voxels_of_triangle(&q.lattice(), margin, &[q.p0, q.p1, q.p2]);
        let (must, may) = (with(q.margin - hair), with(q.margin + hair));
        let got: Vec<_> = got.iter().map(|c| uvec3(c.x, c.y, c.z)).collect();
        for (i, cell) in got.iter().enumerate() {
            if got[..i].contains(cell) {
                return Err(format!("cell {cell} is there twice"));
            }
            if cell.cmpge(q.lattice().resolution).any() {
                return Err(format!(
                    "cell {cell} is not in the lattice, whose last cell is {}",
                    q.lattice().resolution - 1
                ));
            }
            if !may.contains(cell) {
                return Err(format!(
                    "cell {cell} is one too many: the triangle does not reach it"
                ));
            }
        }
        let missing = || must.iter().filter(|&cell| !got.contains(cell));
        let is_deep = |cell: &&UVec3| reaches_deep(q, **cell);
        match (missing().next(), missing().find(is_deep)) {
            (_, Some(cell)) => Err(format!(
                "cell {cell} is missing: the triangle reaches into it"
            )),
            (Some(cell), None) => Err(format!(
                "cell {cell} is missing: a small piece of the triangle reaches into it"
            )),
            (None, None) => Ok(()),
        }
    }

    /// Without the cells that only touch the triangle's bounding box.
    fn canonical(q: &VoxelsOfTriangle, mut cells: Vec<Cell>) -> Vec<Cell> {
        let around = Aabb::of([q.p0, q.p1, q.p2]).grown(q.margin);
        cells.retain(|cell| {
            let low = q.min + vec3(cell.x as f32, cell.y as f32, cell.z as f32) * q.cell;
            let gaps = [around.min - (low + q.cell), low - around.max];
            !gaps
                .into_iter()
                .any(|gap| gap.abs().cmple(Vec3::splat(hair(q))).any())
        });
        cells
    }

    const POSITIVE: &'static [&'static str] = &["cell"];

    const FLAWS: &'static [Flaw] = &[
        Flaw {
            complaint: "is there twice",
            name: "names a cell twice",
            hint: "How often is each cell appended?",
        },
        Flaw {
            complaint: "is not in the lattice",
            name: "names cells outside of the lattice",
            hint: "What are the numbers of the first and the last cell along each axis?",
        },
        Flaw {
            complaint: "one too many",
            name: "names cells that the triangle does not reach",
            hint: "A triangle is smaller than its bounding box: which cells of the box does it miss? Which planes and which edges can part a cell and a triangle?",
        },
        Flaw {
            complaint: "is missing: the triangle",
            name: "leaves out cells that the triangle reaches",
            hint: "A long triangle passes through cells that hold none of its corners: do you find these cells, and the cells that reach the triangle by their margin only?",
        },
        Flaw {
            complaint: "is missing: a small piece",
            name: "leaves out cells into which only a small piece of the triangle reaches",
            hint: "Do you put points of the triangle into cells? Between two of them the triangle goes on: can it cut off the corner of a cell there? If you do not, which of your bounds is too narrow?",
        },
    ];

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| VoxelsOfTriangle {
        min: q.min + sample::METRE,
        p0: q.p0 + sample::METRE,
        p1: q.p1 + sample::METRE,
        p2: q.p2 + sample::METRE,
        ..q.clone()
    })];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "takes all cells of the bounding box",
            hint: "A large slanting triangle has a large bounding box: is it everywhere in it?",
            answer: |q| around(q, |how| how.meets = |_, _| true),
        },
        Mistake {
            name: "takes all cells",
            hint: "Which condition keeps a cell off the list, and when is it false?",
            answer: |q| found(q, |how| how.meets = |_, _| true),
        },
        Mistake {
            name: "takes only the cells that hold a corner",
            hint: "What if the triangle is larger than a cell?",
            answer: |q| found(q, |how| how.meets = hold_a_corner),
        },
        Mistake {
            name: "takes a cell's extent along x for the way to its upper plane along every axis",
            hint: "A cell is 1 m wide and 2 m high: where is its upper side?",
            answer: |q| {
                found(q, |how| {
                    how.meets = |q, bounds| {
                        let max = bounds.max - q.cell + q.cell.x;
                        triangle_meets_box(&corners(q), &Aabb { max, ..*bounds })
                    };
                })
            },
        },
        Mistake {
            name: "takes all cells of the bounding box that the triangle's plane cuts",
            hint: "The plane goes on beyond the triangle's edges: along which directions can you tell that a box lies past an edge?",
            answer: |q| around(q, |how| how.meets = plane_cuts),
        },
        Mistake {
            name: "takes only cells whose centre is near the triangle's plane",
            hint: "How far from its centre does a box reach along the triangle's normal: to a face, or to a corner?",
            answer: |q| {
                let n = normal(q).normalize_or_zero();
                let near = |cell: &Cell| {
                    let center =
                        q.min + (vec3(cell.x as f32, cell.y as f32, cell.z as f32) + 0.5) * q.cell;
                    n.dot(center - q.p0).abs() <= 0.5 * q.cell.min_element()
                };
                Self::right(q).into_iter().filter(near).collect()
            },
        },
        Mistake {
            name: "takes a cell for twice as large as it is",
            hint: "A box reaches from its centre by half of its size along each axis: what do you add up along the normal and along each cross product?",
            answer: |q| around(q, |how| how.growth = 0.5),
        },
        Mistake {
            name: "forgets the margin",
            hint: "A triangle just beyond a plane of the lattice: which cells does it belong to?",
            answer: |q| Self::misread(q, |q| q.margin = 0.0),
        },
        Mistake {
            name: "leaves out the last cell along each axis",
            hint: "The cell that holds the bounding box's greatest corner: is it in your loop?",
            answer: |q| {
                let all = VoxelsOfTriangle::right(q);
                let last = all
                    .iter()
                    .fold(UVec3::ZERO, |last, c| last.max(uvec3(c.x, c.y, c.z)));
                all.into_iter()
                    .filter(|c| uvec3(c.x, c.y, c.z).cmplt(last).all())
                    .collect()
            },
        },
        Mistake {
            name: "takes the lattice to begin at the origin",
            hint: "Move the lattice and the triangle by one metre: the answer must not change.",
            answer: |q| Self::misread(q, |q| q.min = Vec3::ZERO),
        },
        Mistake {
            name: "adds the margin on one side of the cells only",
            hint: "A triangle that passes a cell on its left by less than the margin: does your cell reach that far?",
            answer: |q| {
                let half = 0.5 * q.margin;
                Self::misread(q, |q| {
                    let by = Vec3::splat(half);
                    (q.p0, q.p1, q.p2) = (q.p0 - by, q.p1 - by, q.p2 - by);
                    q.margin = half;
                })
            },
        },
        Mistake {
            name: "adds the margin along x only",
            hint: "A cell reaches farther by the margin to all sides: along which axes does yours?",
            answer: |q| found(q, |how| how.margin = |q| q.margin * Vec3::X),
        },
        Mistake {
            name: "adds the margin along y only",
            hint: "A cell reaches farther by the margin to all sides: along which axes does yours?",
            answer: |q| found(q, |how| how.margin = |q| q.margin * Vec3::Y),
        },
        Mistake {
            name: "adds the margin along z only",
            hint: "A cell reaches farther by the margin to all sides: along which axes does yours?",
            answer: |q| found(q, |how| how.margin = |q| q.margin * Vec3::Z),
        },
        Mistake {
            name: "takes only the cells that hold a corner, and forgets the margin",
            hint: "What if the triangle is larger than a cell?",
            answer: |q| bare(q, |how| how.meets = hold_a_corner),
        },
        Mistake {
            name: "takes a cell's least corner for its middle",
            hint: "A cell begins at min + i·cell: where is its middle?",
            answer: |q| found(q, |how| how.shift = -0.5),
        },
        Mistake {
            name: "takes a cell's greatest corner for its middle",
            hint: "A cell begins at min + i·cell: where is its middle?",
            answer: |q| found(q, |how| how.shift = 0.5),
        },
        Mistake {
            name: "never asks for the plane in which the triangle lies",
            hint: "A cell may lie above the middle of a large triangle: which direction parts the two?",
            answer: |q| around(q, |how| how.meets = no_edge_parts),
        },
        Mistake {
            name: "takes all cells of the lattice that the triangle's plane cuts",
            hint: "The plane goes on beyond the triangle: how far is a cell from the triangle's own bounding box?",
            answer: |q| found(q, |how| how.meets = plane_cuts),
        },
        Mistake {
            name: "asks only for the directions across an edge and an axis",
            hint: "A triangle and a cell may lie one behind the other along x, or on both sides of the triangle's plane: which directions do you have to try beside the nine?",
            answer: |q| found(q, |how| how.meets = no_edge_parts),
        },
        Mistake {
            name: "takes all cells that a piece of the triangle's plane within its bounding box cuts, and forgets the margin",
            hint: "The plane goes on beyond the triangle's edges, and a cell beyond its own planes: how far?",
            answer: |q| {
                around(q, |how| {
                    how.meets = plane_cuts;
                    how.margin = |_| Vec3::ZERO;
                })
            },
        },
        Mistake {
            name: "takes only the cells through which an edge of the triangle passes",
            hint: "A triangle may be much larger than a cell: which cells are in its middle?",
            answer: |q| found(q, |how| how.meets = an_edge_passes),
        },
        Mistake {
            name: "takes the margin for a part of a cell's extents, not for metres",
            hint: "In which unit is the margin, and what is it multiplied by before it is added to a cell's half extents?",
            answer: |q| found(q, |how| how.margin = |q| q.margin * q.cell),
        },
        Mistake {
            name: "adds up the normal's components with their signs for a box's reach along the normal",
            hint: "A normal of −1, 0, 0: how far does a box reach along it, and can that be less than 0?",
            answer: |q| {
                found(q, |how| {
                    how.meets = |q, bounds| {
                        let n = normal(q);
                        let reach = n.dot(0.5 * bounds.size());
                        let is_near = n.dot(bounds.center() - q.p0).abs() <= reach;
                        is_near && triangle_meets_box(&corners(q), bounds)
                    };
                })
            },
        },
        Mistake {
            name: "takes only the cells that the triangle cuts through an edge",
            hint: "A small triangle lies inside a cell, or pokes through one of its faces: which of the cell's edges does it cut?",
            answer: |q| found(q, |how| how.meets = cuts_an_edge),
        },
        Mistake {
            name: "ends each row of the lattice along x at the first cell that the triangle does not reach",
            hint: "In a row of five cells the triangle may reach the third only: what does your loop do at the first?",
            answer: |q| found(q, |how| how.ending = |cell| Some(cell.with_x(0))),
        },
        Mistake {
            name: "ends each row of the lattice along y at the first cell that the triangle does not reach",
            hint: "In a row of five cells the triangle may reach the third only: what does your loop do at the first?",
            answer: |q| found(q, |how| how.ending = |cell| Some(cell.with_y(0))),
        },
        Mistake {
            name: "ends each row of the lattice along z at the first cell that the triangle does not reach",
            hint: "In a row of five cells the triangle may reach the third only: what does your loop do at the first?",
            answer: |q| found(q, |how| how.ending = |cell| Some(cell.with_z(0))),
        },
        Mistake {
            name: "goes through the lattice along x first, and ends at the first cell that the triangle does not reach",
            hint: "In a row of five cells the triangle may reach the third only: what does your loop do at the first?",
            answer: |q| found(q, |how| how.ending = |_| Some(UVec3::ZERO)),
        },
        Mistake {
            name: "goes through the lattice along z first, and ends at the first cell that the triangle does not reach",
            hint: "In a row of five cells the triangle may reach the third only: what does your loop do at the first?",
            answer: |q| {
                found(q, |how| {
                    how.ending = |_| Some(UVec3::ZERO);
                    how.is_along_z = true;
                })
            },
        },
        Mistake {
            name: "ends each row of the bounding box along x at the first cell that the triangle does not reach",
            hint: "A slanting triangle reaches the box around it at a few places: what does your loop do at a cell that it does not reach?",
            answer: |q| around(q, |how| how.ending = |cell| Some(cell.with_x(0))),
        },
        Mistake {
            name: "ends each row of the bounding box along y at the first cell that the triangle does not reach",
            hint: "A slanting triangle reaches the box around it at a few places: what does your loop do at a cell that it does not reach?",
            answer: |q| around(q, |how| how.ending = |cell| Some(cell.with_y(0))),
        },
        Mistake {
            name: "ends each row of the bounding box along z at the first cell that the triangle does not reach",
            hint: "A slanting triangle reaches the box around it at a few places: what does your loop do at a cell that it does not reach?",
            answer: |q| around(q, |how| how.ending = |cell| Some(cell.with_z(0))),
        },
        Mistake {
            name: "goes through the bounding box along x first, and ends at the first cell that the triangle does not reach",
            hint: "A slanting triangle reaches the box around it at a few places: what does your loop do at a cell that it does not reach?",
            answer: |q| around(q, |how| how.ending = |_| Some(UVec3::ZERO)),
        },
        Mistake {
            name: "goes through the bounding box along z first, and ends at the first cell that the triangle does not reach",
            hint: "A slanting triangle reaches the box around it at a few places: what does your loop do at a cell that it does not reach?",
            answer: |q| {
                around(q, |how| {
                    how.ending = |_| Some(UVec3::ZERO);
                    how.is_along_z = true;
                })
            },
        },
        Mistake {
            name: "puts only points of the triangle into cells, in steps of a tenth of its edges",
            hint: BETWEEN,
            answer: |q| found(q, |how| how.meets = |q, bounds| hold_a_point(q, bounds, 10)),
        },
        Mistake {
            name: "puts only points of the triangle into cells, in steps of a sixteenth of its edges",
            hint: BETWEEN,
            answer: |q| found(q, |how| how.meets = |q, bounds| hold_a_point(q, bounds, 16)),
        },
        Mistake {
            name: "puts only points of the triangle into cells, in steps of a twentieth of its edges",
            hint: BETWEEN,
            answer: |q| found(q, |how| how.meets = |q, bounds| hold_a_point(q, bounds, 20)),
        },
        Mistake {
            name: "puts only points of the triangle into cells, in steps of a tenth of its edges, and forgets the margin",
            hint: BETWEEN,
            answer: |q| bare(q, |how| how.meets = |q, bounds| hold_a_point(q, bounds, 10)),
        },
        Mistake {
            name: "puts only points of the triangle into cells, in steps of a sixteenth of its edges, and forgets the margin",
            hint: BETWEEN,
            answer: |q| bare(q, |how| how.meets = |q, bounds| hold_a_point(q, bounds, 16)),
        },
        Mistake {
            name: "puts only points of the triangle into cells, in steps of a twentieth of its edges, and forgets the margin",
            hint: BETWEEN,
            answer: |q| bare(q, |how| how.meets = |q, bounds| hold_a_point(q, bounds, 20)),
        },
        Mistake {
            name: "takes only the cells that hold the triangle's middle",
            hint: "What if the triangle is larger than a cell?",
            answer: |q| found(q, |how| how.meets = hold_the_middle),
        },
        Mistake {
            name: "takes only the cell that holds the triangle's middle, and forgets the margin",
            hint: "What if the triangle is larger than a cell?",
            answer: |q| bare(q, |how| how.meets = hold_the_middle),
        },
    ];
}

/// Less than this nobody is to blame for.
fn hair(q: &VoxelsOfTriangle) -> f32 {
    1e-4 * (q.cell.max_element() + q.min.abs().max_element())
}

/// Whether a triangle reaches deeper into a cell than a quarter of the cell's extents.
fn reaches_deep(q: &VoxelsOfTriangle, cell: UVec3) -> bool {
    let bounds = q.lattice().bounds_of(cell, cell);
    let by = 0.25 * bounds.size();
    let middle = Aabb::new(bounds.min + by, bounds.max - by);
    triangle_meets_box(&[q.p0, q.p1, q.p2], &middle)
}

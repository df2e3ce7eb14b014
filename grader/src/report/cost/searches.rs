//! The searches whose steps are counted: how a ray through a scene of triangles is asked, and how many steps the answer stands for.
//!
//! Trees answer with their own counts. A walk answers with the cells or leaves on the ray's way, and the search goes on here: it tests
//! the triangles of one after the other, until a hit lies before the end of its cell.

use crate::cases::{ch11_bvh, ch24_wide_bvh};
use glam::Vec3;
use raybook::math::{aabb::Aabb, interval::Interval, ray::Ray, slab};
use raybook::shape::{Shape, triangle::Triangle};
use raybook_workbook::exercise::Exercise;
use raybook_workbook::exercises::ch05_box::Corners;
use raybook_workbook::exercises::ch08_grid::{GridResolution, GridWalk, Visit, VoxelsOfTriangle};
use raybook_workbook::exercises::ch10_octree::{OctreeBuild, OctreeWalk};
use raybook_workbook::octree_rows::{TreeRow, to_tree};
use raybook_workbook::row;
use std::collections::BTreeMap;

/// The search of an exercise.
pub struct Search {
    /// The exercise's name.
    pub exercise: &'static str,
    /// What is a step.
    pub step: &'static str,
    /// The search over a scene.
    pub over: fn(&[[Vec3; 3]]) -> Over,
}

/// The steps of a ray with an answer.
pub type Steps = Box<dyn Fn(Ray, &[f64]) -> f64>;

/// A search over a scene.
pub struct Over {
    /// The question of a ray, as a row of numbers.
    pub question: Box<dyn Fn(Ray) -> Vec<f64>>,
    /// The steps of a ray with its answer.
    pub steps: Steps,
}

/// All of them.
pub const SEARCHES: [Search; 4] = [
    Search {
        exercise: "grid_walk",
        step: "a cell or a triangle",
        over: grid,
    },
    Search {
        exercise: "octree_walk",
        step: "a leaf or a triangle",
        over: octree,
    },
    Search {
        exercise: "bvh_closest",
        step: "a box or a triangle",
        over: |triangles| {
            let triangles = triangles.to_vec();
            counted(move |ray| {
                row::to_numbers(&ch11_bvh::question(&triangles, ray, Interval::AHEAD))
            })
        },
    },
    Search {
        exercise: "wide_closest",
        step: "a node or a triangle",
        over: |triangles| {
            let triangles = triangles.to_vec();
            counted(move |ray| {
                let triangles = triangles.clone();
                row::to_numbers(&ch24_wide_bvh::question(triangles, ray, Interval::AHEAD))
            })
        },
    },
];

/// A search whose answer begins with two counts.
fn counted(question: impl Fn(Ray) -> Vec<f64> + 'static) -> Over {
    Over {
        question: Box::new(question),
        steps: Box::new(|_, answer| answer.iter().take(2).sum()),
    }
}

/// The reference's grid, through which the student's walk goes.
fn grid(triangles: &[[Vec3; 3]]) -> Over {
    /// Cells for each triangle, as many as the library's grids have.
    const DENSITY: f32 = 5.0;
    let Aabb { min, max } = around(triangles);
    let shapes = triangles.len() as u32;
    let cells = GridResolution {
        extents: max - min,
        shapes,
        density: DENSITY,
    };
    let cells = cells.answer();
    let [nx, ny, nz] = [cells.x, cells.y, cells.z];
    let cell = (max - min) / Vec3::new(nx as f32, ny as f32, nz as f32);
    let mut members: BTreeMap<_, Vec<u32>> = BTreeMap::new();
    for (i, [p0, p1, p2]) in (0..).zip(triangles.iter().copied()) {
        let reached = VoxelsOfTriangle {
            min,
            cell,
            nx,
            ny,
            nz,
            margin: 1e-4 * cell.min_element(),
            p0,
            p1,
            p2,
        };
        for cell in reached.answer() {
            members.entry([cell.x, cell.y, cell.z]).or_default().push(i);
        }
    }
    let triangles = triangles.to_vec();
    Over {
        question: Box::new(move |ray| {
            row::to_numbers(&GridWalk {
                min,
                cell,
                nx,
                ny,
                nz,
                ray,
                within: Interval::AHEAD,
            })
        }),
        steps: Box::new(move |ray, answer| {
            let visits: Vec<Visit> = row::from_numbers(answer);
            let cells = visits.iter().map(|visit| {
                let members = members.get(&[visit.x, visit.y, visit.z]);
                (members.map_or(&[][..], Vec::as_slice), visit.leave)
            });
            searched(&triangles, ray, cells)
        }),
    }
}

/// The reference's octree, through which the student's walk goes.
fn octree(triangles: &[[Vec3; 3]]) -> Over {
    let bounds @ Aabb { min, max } = around(triangles);
    let corners = |triangle: &[Vec3; 3]| {
        let Aabb { min, max } = Aabb::of(*triangle);
        Corners { min, max }
    };
    let tree = OctreeBuild {
        min,
        max,
        opening: 2.0,
        copies: 8.0,
        depth: 8,
        shapes: triangles.iter().map(corners).collect(),
    };
    let TreeRow { nodes, names } = tree.answer();
    let places = to_tree(bounds, &nodes).places();
    let cells: BTreeMap<u32, Aabb> = places
        .into_iter()
        .map(|place| (place.node, place.cell))
        .collect();
    let (triangles, rows) = (triangles.to_vec(), nodes.clone());
    Over {
        question: Box::new(move |ray| {
            row::to_numbers(&OctreeWalk {
                ray,
                within: Interval::AHEAD,
                min,
                max,
                nodes: nodes.clone(),
            })
        }),
        steps: Box::new(move |ray, answer| {
            let leaves: Vec<u32> = row::from_numbers(answer);
            let leaves = leaves.iter().map(|leaf| {
                let members = rows.get(*leaf as usize).and_then(|node| {
                    let (first, count) = (node.first as usize, node.count as usize);
                    names.get(first..first.checked_add(count)?)
                });
                let inside = cells.get(leaf);
                let inside = inside.and_then(|cell| slab::clip(cell, &ray, Interval::AHEAD));
                (
                    members.unwrap_or_default(),
                    inside.map_or(f32::INFINITY, |inside| inside.max),
                )
            });
            searched(&triangles, ray, leaves)
        }),
    }
}

/// A box around triangles, with a little room.
fn around(triangles: &[[Vec3; 3]]) -> Aabb {
    let Aabb { min, max } = Aabb::of(triangles.iter().flatten().copied());
    let room = Vec3::splat(1e-3);
    Aabb::new(min - room, max + room)
}

/// The steps of a search through groups of triangles, each with the distance at which the ray leaves it: one for each group, and one
/// for each of its triangles.
pub fn searched<'a>(
    triangles: &[[Vec3; 3]],
    ray: Ray,
    groups: impl Iterator<Item = (&'a [u32], f32)>,
) -> f64 {
    let (mut steps, mut nearest) = (0, f32::INFINITY);
    for (members, leave) in groups {
        steps += 1 + members.len();
        for [p0, p1, p2] in members.iter().map(|i| triangles[*i as usize]) {
            let hit = Triangle::new(p0, p1, p2).hit(&ray, Interval::AHEAD);
            nearest = hit.map_or(nearest, |hit| nearest.min(hit.t));
        }
        if nearest <= leave && nearest < f32::INFINITY {
            break;
        }
    }
    steps as f64
}

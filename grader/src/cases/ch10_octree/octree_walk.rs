//! `octree_walk`: its judge and mistakes.

use super::octree_walk_cases;
use raybook::accel::octree::tree::Kind;
use crate::passage::passage;
use crate::{Graded, Mistake, Verdict};
use raybook::math::{aabb::Aabb, interval::Interval, pcg::Pcg, ray::Ray};
use raybook_workbook::exercise::Exercise;
use raybook_workbook::exercises::ch10_octree::OctreeWalk;

/// The leaves' cells by the nodes' numbers, and which nodes are leaves that are not empty; empty boxes for inner nodes.
pub(super) fn cells(q: &OctreeWalk) -> (Vec<Aabb>, Vec<u32>) {
    let tree = q.tree();
    let mut cells = vec![Aabb::EMPTY; tree.nodes.len()];
    let mut leaves = Vec::new();
    for place in tree.places() {
        if let Kind::Leaf { count, .. } = tree.nodes[place.node as usize].kind() {
            cells[place.node as usize] = place.cell;
            if count > 0 {
                leaves.push(place.node);
            }
        }
    }
    leaves.sort_unstable();
    (cells, leaves)
}

fn walked(q: &OctreeWalk, ray: Ray, within: Interval) -> Vec<u32> {
    OctreeWalk::answer(&OctreeWalk {
        ray,
        within,
        ..q.clone()
    })
}

impl Graded for OctreeWalk {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "visits the children in the order of their numbers",
            hint: "A ray that runs towards −x meets the upper half first.",
            answer: |q| {
                let mut leaves = OctreeWalk::answer(q);
                leaves.sort_unstable();
                leaves
            },
        },
        Mistake {
            name: "visits every leaf",
            hint: "Which leaves does the ray never enter?",
            answer: |q| cells(q).1,
        },
        Mistake {
            name: "stops after the first leaf",
            hint: "If the first leaf has no hit, where is the next one?",
            answer: |q| OctreeWalk::answer(q).into_iter().take(1).collect(),
        },
        Mistake {
            name: "goes on behind the end of the interval",
            hint: "Something nearer may already have been hit: what is `limit` for?",
            answer: |q| walked(q, q.ray, Interval::new(q.within.min, f32::INFINITY)),
        },
        Mistake {
            name: "begins behind the ray's origin",
            hint: "Can the ray enter a leaf that lies behind its origin?",
            answer: |q| walked(q, q.ray, Interval::new(f32::NEG_INFINITY, q.within.max)),
        },
        Mistake {
            name: "loses rays that run along an axis",
            hint: "If the ray does not move along x, how far is it to the middle plane in x, and what is 0 · ∞?",
            answer: |q| {
                let along = q.ray.direction.to_array().contains(&0.0);
                if along {
                    Vec::new()
                } else {
                    OctreeWalk::answer(q)
                }
            },
        },
        Mistake {
            name: "visits the leaves from back to front",
            hint: "In which leaf would the nearest hit be?",
            answer: |q| OctreeWalk::answer(q).into_iter().rev().collect(),
        },
    ];

    fn random(rng: &mut Pcg) -> OctreeWalk {
        octree_walk_cases::random(rng)
    }

    fn judge(q: &OctreeWalk, golden: &Vec<u32>, got: &Vec<u32>) -> Verdict {
        let (cells, leaves) = cells(q);
        if let Some(node) = got.iter().find(|node| !leaves.contains(node)) {
            let what = match q.nodes.get(*node as usize) {
                None => "does not exist",
                Some(row) if row.inner != 0 => "is no leaf",
                Some(_) => "is an empty leaf",
            };
            return Err(format!("node {node} {what}"));
        }
        passage("leaf", &cells, &q.ray, q.within, golden, got)
    }
}

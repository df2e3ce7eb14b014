//! `octree_walk`: its cases, judge and mistakes.

use crate::accel::octree::tree::Kind;
use crate::grade::passage::passage;
use crate::grade::{Edge, Graded, Mistake, Verdict, sample};
use crate::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use crate::workbook::exercise::Exercise;
use crate::workbook::exercises::ch10_octree::{NodeRow, OctreeWalk, OctreeWalkQuestion};
use glam::{Vec3, vec3};
use rand::RngExt;

/// The leaves' cells by the nodes' numbers, and which nodes are leaves that are not empty; empty boxes for inner nodes.
pub(super) fn cells(q: &OctreeWalkQuestion) -> (Vec<Aabb>, Vec<u32>) {
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

fn walked(q: &OctreeWalkQuestion, ray: Ray, within: Interval) -> Vec<u32> {
    OctreeWalk::answer(&OctreeWalkQuestion {
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

    fn edges() -> Vec<Edge<Self>> {
        let q = |origin: Vec3, toward: Vec3, within| OctreeWalkQuestion {
            ray: Ray::new(origin, Dir3::new_or(toward, Dir3::X)),
            within,
            min: Vec3::ZERO,
            max: Vec3::splat(8.0),
            nodes: full_tree(),
        };
        let ahead = Interval::AHEAD;
        vec![
            Edge::new(
                "upwards through the lower row",
                q(vec3(-2.0, 1.0, 3.0), Vec3::X, ahead),
            ),
            Edge::new(
                "downwards along x",
                q(vec3(11.0, 1.0, 3.0), -Vec3::X, ahead),
            ),
            Edge::new(
                "along −z with −0.0 in x and y",
                q(vec3(5.0, 5.0, 20.0), vec3(-0.0, -0.0, -1.0), ahead),
            ),
            Edge::new("in a middle plane", q(vec3(4.0, 1.0, -1.0), Vec3::Z, ahead)),
            Edge::new(
                "in two middle planes, with −0.0",
                q(vec3(4.0, 4.0, 9.0), vec3(-0.0, 0.0, -1.0), ahead),
            ),
            Edge::new(
                "in a face of the root",
                q(vec3(0.0, 3.0, -1.0), Vec3::Z, ahead),
            ),
            Edge::new(
                "through the centre",
                q(vec3(-1.0, -1.0, -1.0), Vec3::ONE, ahead),
            ),
            Edge::new(
                "from inside",
                q(vec3(5.0, 5.0, 5.0), vec3(-1.0, -0.6, -0.4), ahead),
            ),
            Edge::new(
                "from inside, away from most leaves",
                q(vec3(5.0, 1.5, 1.0), vec3(1.0, 0.1, 0.05), ahead),
            ),
            Edge::new(
                "ends in the first half",
                q(
                    vec3(-2.0, 1.2, 3.0),
                    vec3(1.0, 0.3, 0.1),
                    Interval::new(0.0, 5.0),
                ),
            ),
            Edge::new(
                "begins in the second half",
                q(
                    vec3(-2.0, 1.2, 3.0),
                    vec3(1.0, 0.3, 0.1),
                    Interval::new(7.0, 30.0),
                ),
            ),
            Edge::new(
                "passes the root by",
                q(vec3(-2.0, 9.0, 3.0), vec3(1.0, 0.1, 0.1), ahead),
            ),
            Edge::new(
                "the root is a leaf",
                OctreeWalkQuestion {
                    nodes: vec![leaf(0, 3)],
                    ..q(vec3(-1.0, 2.0, 2.0), vec3(1.0, 0.1, 0.2), ahead)
                },
            ),
            Edge::new(
                "the root is an empty leaf",
                OctreeWalkQuestion {
                    nodes: vec![leaf(0, 0)],
                    ..q(vec3(-1.0, 2.0, 2.0), vec3(1.0, 0.1, 0.2), ahead)
                },
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> OctreeWalkQuestion {
        let (min, size) = (sample::point(rng, 3.0), sample::number(rng, 1.0, 6.0));
        let mut nodes = vec![inner(1)];
        let mut names = 0;
        let mut add_leaf = |rng: &mut Pcg| {
            let count = if rng.random_bool(0.25) {
                0
            } else {
                rng.random_range(1..4)
            };
            names += count;
            leaf(names - count, count)
        };
        for _ in 0..8 {
            nodes.push(add_leaf(rng));
        }
        for child in 1..9 {
            if rng.random_bool(0.35) {
                nodes[child] = inner(nodes.len() as u32);
                for _ in 0..8 {
                    nodes.push(add_leaf(rng));
                }
            }
        }
        let inside = min + size * (sample::point(rng, 0.35) + 0.5);
        let origin = if rng.random_bool(0.3) {
            min + size * (sample::point(rng, 0.5) + 0.5)
        } else {
            inside + size * 1.5 * *sample::direction(rng)
        };
        let end = if rng.random_bool(0.3) {
            size
        } else {
            f32::INFINITY
        };
        OctreeWalkQuestion {
            ray: Ray::new(origin, Dir3::new_or(inside - origin, Dir3::X)),
            within: Interval::new(0.0, end),
            min,
            max: min + size,
            nodes,
        }
    }

    fn judge(q: &OctreeWalkQuestion, golden: &Vec<u32>, got: &Vec<u32>) -> Verdict {
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

pub(super) fn leaf(first: u32, count: u32) -> NodeRow {
    NodeRow {
        inner: 0,
        first,
        count,
    }
}

fn inner(first: u32) -> NodeRow {
    NodeRow {
        inner: 1,
        first,
        count: 0,
    }
}

/// A root whose children 0 and 5 are cut once more; every leaf holds one shape.
fn full_tree() -> Vec<NodeRow> {
    let mut nodes = vec![inner(1)];
    nodes.extend((1..25).map(|i| leaf(i - 1, 1)));
    nodes[1] = inner(9);
    nodes[6] = inner(17);
    nodes
}

//! Chapter 10: `octree_child`, `octree_build`, `octree_walk`.

use crate::accel::octree::build::{Limits, build};
use crate::accel::octree::tree::{Kind, Tree, child_cell};
use crate::grade::examine::Examiner;
use crate::grade::passage::passage;
use crate::grade::{Edge, Graded, Mistake, Verdict, sample};
use crate::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use crate::workbook::exercise::Exercise;
use crate::workbook::exercises::ch05_box::Corners;
use crate::workbook::exercises::ch10_octree::{
    NodeRow, OctreeBuild, OctreeBuildQuestion, OctreeChild, OctreeChildQuestion, OctreeWalk,
    OctreeWalkQuestion, TreeRow, reached,
};
use glam::{Vec3, vec3};
use rand::RngExt;

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&OctreeChild, &OctreeBuild, &OctreeWalk];

impl Graded for OctreeChild {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "counts x as the highest bit",
            hint: "Move the point along x from one half to the other: by how much does the number change?",
            answer: |q| {
                let n = OctreeChild::answer(q);
                (n & 1) << 2 | n & 2 | n >> 2
            },
        },
        Mistake {
            name: "swaps y and z",
            hint: "Which of the three coordinates is worth 4?",
            answer: |q| {
                let n = OctreeChild::answer(q);
                n & 1 | (n & 2) << 1 | (n & 4) >> 1
            },
        },
        Mistake {
            name: "counts the upper half as 0",
            hint: "Which child has the number 0: the one at the least corner or at the greatest?",
            answer: |q| 7 - OctreeChild::answer(q),
        },
        Mistake {
            name: "takes a point on a middle plane for below",
            hint: "The middle plane belongs to one of the two halves: to which?",
            answer: |q| bits(q.p.cmpgt(0.5 * (q.min + q.max))),
        },
        Mistake {
            name: "compares with half the size of the cell",
            hint: "Where is the middle of a cell that begins at x = 10 and is 2 wide?",
            answer: |q| bits(q.p.cmpge(0.5 * (q.max - q.min))),
        },
        Mistake {
            name: "compares with 0",
            hint: "Is the middle of every cell at the origin?",
            answer: |q| bits(q.p.cmpge(Vec3::ZERO)),
        },
        Mistake {
            name: "looks at x and y only",
            hint: "A quad-tree has four children; how many has an octree?",
            answer: |q| OctreeChild::answer(q) & 3,
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let edge = |name, min: f32, max: f32, p| {
            Edge::new(
                name,
                OctreeChildQuestion {
                    min: Vec3::splat(min),
                    max: Vec3::splat(max),
                    p,
                },
            )
        };
        vec![
            edge("at the least corner", 0.0, 2.0, vec3(0.0, 0.0, 0.0)),
            edge("at the greatest corner", 0.0, 2.0, vec3(2.0, 2.0, 2.0)),
            edge("only x is above", 0.0, 2.0, vec3(1.5, 0.5, 0.5)),
            edge("only y is above", 0.0, 2.0, vec3(0.5, 1.5, 0.5)),
            edge("only z is above", 0.0, 2.0, vec3(0.5, 0.5, 1.5)),
            edge("in the middle", 0.0, 2.0, vec3(1.0, 1.0, 1.0)),
            edge("on one middle plane", 0.0, 2.0, vec3(0.5, 1.0, 1.5)),
            edge(
                "in a cell away from the origin",
                10.0,
                12.0,
                vec3(10.5, 11.5, 10.5),
            ),
            edge(
                "in a cell of negative coordinates",
                -8.0,
                -4.0,
                vec3(-5.0, -7.0, -4.5),
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> OctreeChildQuestion {
        let min = sample::point(rng, 4.0);
        let size = Vec3::splat(sample::number(rng, 0.5, 4.0));
        let inside = sample::point(rng, 0.5) + 0.5;
        OctreeChildQuestion {
            min,
            max: min + size,
            p: min + inside * size,
        }
    }

    fn judge(_q: &OctreeChildQuestion, golden: &u32, got: &u32) -> Verdict {
        if golden == got {
            return Ok(());
        }
        if *got > 7 {
            return Err(format!(
                "there are eight children, 0 to 7, and no child {got}"
            ));
        }
        let half = |n: u32, axis: u32| if n >> axis & 1 == 1 { "upper" } else { "lower" };
        let wrong = (0..3)
            .zip(["x", "y", "z"])
            .find(|&(axis, _)| half(*golden, axis) != half(*got, axis));
        let (axis, name) = wrong.unwrap_or((0, "x"));
        Err(format!(
            "child {got} is in the {} half along {name}, and the point is in the {}",
            half(*got, axis),
            half(*golden, axis)
        ))
    }
}

fn bits(above: glam::BVec3) -> u32 {
    above.bitmask()
}

/// The tree that the library builds if it is told something else about which cells a box reaches, or other limits.
fn built(
    q: &OctreeBuildQuestion,
    limits: impl FnOnce(Limits) -> Limits,
    seen: impl Fn(&Corners, &[Aabb; 8]) -> u8,
) -> TreeRow {
    let limits = limits(Limits {
        opening: q.opening,
        copies: q.copies,
        depth: q.depth,
    });
    let bounds = Aabb {
        min: q.min,
        max: q.max,
    };
    let tree = build(bounds, q.shapes.len() as u32, limits, &|i, cells| {
        seen(&q.shapes[i as usize], cells)
    });
    rows(&tree)
}

fn rows(tree: &Tree) -> TreeRow {
    let row = |node: &crate::accel::octree::tree::Node| match node.kind() {
        Kind::Inner { children, .. } => NodeRow {
            inner: 1,
            first: children,
            count: 0,
        },
        Kind::Leaf { first, count } => NodeRow {
            inner: 0,
            first,
            count,
        },
    };
    TreeRow {
        nodes: tree.nodes.iter().map(row).collect(),
        names: tree.named.clone(),
    }
}

impl Graded for OctreeBuild {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "names a shape only where its middle is",
            hint: "A ray can hit a shape far from its middle: in which leaf does it look for it?",
            answer: |q| {
                built(
                    q,
                    |l| l,
                    |shape, cells| {
                        let middle = 0.5 * (shape.min + shape.max);
                        let place = Corners {
                            min: middle,
                            max: middle,
                        };
                        1 << reached(&place, cells).trailing_zeros().min(7)
                    },
                )
            },
        },
        Mistake {
            name: "drops shapes that reach several children",
            hint: "A shape that does not fit into one child: where is it named?",
            answer: |q| {
                built(
                    q,
                    |l| l,
                    |shape, cells| {
                        let bits = reached(shape, cells);
                        if bits.is_power_of_two() { bits } else { 0 }
                    },
                )
            },
        },
        Mistake {
            name: "never cuts",
            hint: "What does a ray gain from a tree that is a single leaf?",
            answer: |q| built(q, |l| Limits { depth: 0, ..l }, reached),
        },
        Mistake {
            name: "cuts as long as the depth allows",
            hint: "What does a ray gain if a leaf with one shape, or none, is cut?",
            answer: |q| {
                built(
                    q,
                    |l| Limits {
                        opening: -1e9,
                        copies: 1e9,
                        ..l
                    },
                    reached,
                )
            },
        },
        Mistake {
            name: "cuts the root only",
            hint: "Are the children cells like any other?",
            answer: |q| {
                built(
                    q,
                    |l| Limits {
                        depth: l.depth.min(1),
                        ..l
                    },
                    reached,
                )
            },
        },
        Mistake {
            name: "cuts once too often",
            hint: "With a depth of 0, how many nodes may there be?",
            answer: |q| {
                built(
                    q,
                    |l| Limits {
                        depth: l.depth + 1,
                        ..l
                    },
                    reached,
                )
            },
        },
        Mistake {
            name: "swaps x and z in the children's numbers",
            hint: "Child 1 is in the upper half along one axis only: along which?",
            answer: |q| {
                built(
                    q,
                    |l| l,
                    |shape, cells| {
                        let swapped = [0, 4, 2, 6, 1, 5, 3, 7].map(|i: usize| cells[i]);
                        reached(shape, &swapped)
                    },
                )
            },
        },
        Mistake {
            name: "ignores the limit on copies",
            hint: "How often are large shapes named in all leaves together?",
            answer: |q| {
                built(
                    q,
                    |l| Limits {
                        copies: f32::INFINITY,
                        ..l
                    },
                    reached,
                )
            },
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let tiny = |p: Vec3| Corners {
            min: p - 0.01,
            max: p + 0.01,
        };
        let question = |depth, copies, shapes: Vec<Corners>| OctreeBuildQuestion {
            min: Vec3::ZERO,
            max: Vec3::splat(8.0),
            opening: 1.0,
            copies,
            depth,
            shapes,
        };
        let corners = (0..8)
            .map(|i| tiny(vec3((i & 1) as f32, (i >> 1 & 1) as f32, (i >> 2) as f32) * 6.0 + 1.0));
        let crowd =
            (0..6).map(|i| tiny(vec3(0.3, 0.3, 0.2) + 0.3 * i as f32 * vec3(1.0, 0.0, 0.3)));
        let across = Corners {
            min: vec3(1.0, 1.0, 1.0),
            max: vec3(7.0, 1.5, 1.5),
        };
        let sheets = (0..4).map(|i| Corners {
            min: vec3(0.5, 0.5, 0.5 + 2.0 * i as f32),
            max: vec3(7.5, 7.5, 0.6 + 2.0 * i as f32),
        });
        let pair = [
            vec3(1.0, 1.0, 1.0),
            vec3(7.0, 1.0, 1.0),
            vec3(1.0, 1.0, 7.0),
            vec3(2.5, 1.0, 1.0),
        ];
        vec![
            Edge::new("no shapes", question(3, 8.0, vec![])),
            Edge::new(
                "one shape",
                question(3, 8.0, vec![tiny(vec3(1.0, 2.0, 3.0))]),
            ),
            Edge::new("one in each child", question(3, 8.0, corners.collect())),
            Edge::new(
                "some along x, one along z",
                question(3, 8.0, pair.map(tiny).to_vec()),
            ),
            Edge::new(
                "a crowd in a corner",
                question(3, 8.0, crowd.clone().collect()),
            ),
            Edge::new(
                "a crowd, and no depth left",
                question(1, 8.0, crowd.clone().collect()),
            ),
            Edge::new("no depth at all", question(0, 8.0, crowd.clone().collect())),
            Edge::new(
                "one that reaches across",
                question(2, 8.0, crowd.chain([across]).collect()),
            ),
            Edge::new(
                "all at the same place",
                question(3, 8.0, vec![tiny(vec3(3.9, 3.9, 3.9)); 5]),
            ),
            Edge::new(
                "all reach all children",
                question(
                    3,
                    8.0,
                    vec![
                        Corners {
                            min: Vec3::splat(1.0),
                            max: Vec3::splat(7.0)
                        };
                        4
                    ],
                ),
            ),
            Edge::new(
                "large sheets, few copies",
                question(2, 1.5, sheets.clone().collect()),
            ),
            Edge::new(
                "large sheets, many copies",
                question(2, 64.0, sheets.collect()),
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> OctreeBuildQuestion {
        let min = sample::point(rng, 3.0);
        let size = sample::number(rng, 1.0, 4.0);
        // Half of the shapes in one corner, so that depth matters.
        let crowd = min + size * Vec3::splat(sample::number(rng, 0.1, 0.6));
        let shapes = (0..rng.random_range(6..11))
            .map(|i| {
                let anywhere = min + size * (0.9 * (sample::point(rng, 0.5) + 0.5));
                let near = crowd + size * (0.1 * (sample::point(rng, 0.5) + 0.5));
                let least = if i % 2 == 0 { near } else { anywhere };
                let extent = size * 0.08 * (sample::point(rng, 0.5) + 0.5);
                Corners {
                    min: least,
                    max: least + extent,
                }
            })
            .collect();
        OctreeBuildQuestion {
            min,
            max: min + size,
            opening: 1.0,
            copies: [1.2, 2.0, 8.0][rng.random_range(0..3_usize)],
            depth: rng.random_range(1..4),
            shapes,
        }
    }

    fn judge(q: &OctreeBuildQuestion, golden: &TreeRow, got: &TreeRow) -> Verdict {
        let leaves = leaves(q, got)?;
        let tolerance = 1e-4 * (q.max - q.min).max_element();
        for leaf in &leaves {
            let names = &got.names[leaf.names.clone()];
            for (i, shape) in (0..).zip(&q.shapes) {
                let deep =
                    (shape.max.min(leaf.cell.max) - shape.min.max(leaf.cell.min)).min_element();
                let named = names.iter().filter(|&&name| name == i).count();
                if named > 1 {
                    return Err(format!("leaf {} names shape {i} twice", leaf.node));
                }
                if named == 0 && deep > tolerance {
                    return Err(format!(
                        "shape {i} reaches leaf {}, which does not name it",
                        leaf.node
                    ));
                }
                if named == 1 && deep < -tolerance {
                    return Err(format!(
                        "leaf {} names shape {i}, which is not in it",
                        leaf.node
                    ));
                }
            }
        }
        let (most, copies) = (q.copies * q.shapes.len() as f32, got.names.len() as f32);
        if copies > most.max(q.shapes.len() as f32) + 1e-3 {
            return Err(format!(
                "the leaves name {copies} shapes in all, and may name {most}"
            ));
        }
        // The golden tree is made by the same rules, so it can be taken apart too.
        let (cost, least) = (cost(q, got), cost(q, golden));
        if cost > 1.02 * least + 1e-3 {
            return Err(format!(
                "a ray through the cell is expected to cost {cost:.2} tests, and need not cost more than {least:.2}"
            ));
        }
        Ok(())
    }
}

/// A leaf of an answer.
struct LeafOf {
    node: usize,
    cell: Aabb,
    names: std::ops::Range<usize>,
}

/// The leaves of an answer, if it is a tree and no deeper than it may be.
fn leaves(q: &OctreeBuildQuestion, tree: &TreeRow) -> Result<Vec<LeafOf>, String> {
    let root = Aabb {
        min: q.min,
        max: q.max,
    };
    let (mut leaves, mut seen) = (Vec::new(), vec![false; tree.nodes.len()]);
    let mut to_do = vec![(0_usize, root, 0)];
    while let Some((node, cell, depth)) = to_do.pop() {
        let Some(row) = tree.nodes.get(node) else {
            return Err(format!(
                "there is no node {node}; there are {}",
                tree.nodes.len()
            ));
        };
        if std::mem::replace(&mut seen[node], true) {
            return Err(format!("node {node} is the child of two nodes"));
        }
        let first = row.first as usize;
        if row.inner == 0 {
            let names = first..first.saturating_add(row.count as usize);
            if names.end > tree.names.len() && !names.is_empty() {
                return Err(format!(
                    "leaf {node} names the shapes {first} to {} of a list of {}",
                    names.end,
                    tree.names.len()
                ));
            }
            let names = if names.is_empty() { 0..0 } else { names };
            leaves.push(LeafOf { node, cell, names });
        } else if depth == q.depth {
            return Err(format!(
                "node {node} is cut at depth {depth}, which is the limit"
            ));
        } else {
            to_do
                .extend((0..8).map(|i| (first.saturating_add(i), child_cell(&cell, i), depth + 1)));
        }
    }
    let shapes = q.shapes.len();
    match tree.names.iter().find(|&&name| name as usize >= shapes) {
        Some(name) => Err(format!(
            "there is no shape {name}; there are {shapes}, counted from 0"
        )),
        None => Ok(leaves),
    }
}

/// The tests that a ray through the root is expected to cost: a node at depth d is entered by one ray of 4^d.
fn cost(q: &OctreeBuildQuestion, tree: &TreeRow) -> f32 {
    let mut cost = 0.0;
    let mut to_do = vec![(0, 1.0)];
    while let Some((node, share)) = to_do.pop() {
        let row: &NodeRow = &tree.nodes[node];
        if row.inner == 0 {
            cost += share * row.count as f32;
        } else {
            cost += share * q.opening;
            to_do.extend((0..8).map(|i| (row.first as usize + i, 0.25 * share)));
        }
    }
    cost
}

/// The leaves' cells by the nodes' numbers, and which nodes are leaves that are not empty; empty boxes for inner nodes.
fn cells(q: &OctreeWalkQuestion) -> (Vec<Aabb>, Vec<u32>) {
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

fn leaf(first: u32, count: u32) -> NodeRow {
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

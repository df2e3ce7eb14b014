//! `octree_build`: its cases, judge and mistakes.

use super::octree_build_judge::judge;
use crate::accel::octree::build::{Limits, build};
use crate::accel::octree::tree::{Kind, Tree};
use crate::grade::{Edge, Graded, Mistake, Verdict, sample};
use crate::math::{aabb::Aabb, pcg::Pcg};
use crate::workbook::exercises::ch05_box::Corners;
use crate::workbook::exercises::ch10_octree::{
    NodeRow, OctreeBuild, OctreeBuildQuestion, TreeRow, reached,
};
use glam::{Vec3, vec3};
use rand::RngExt;

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
        let edge = |name, depth, copies, shapes| Edge::new(name, question(depth, copies, shapes));
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
            edge("no shapes", 3, 8.0, vec![]),
            edge("one shape", 3, 8.0, vec![tiny(vec3(1.0, 2.0, 3.0))]),
            edge("one in each child", 3, 8.0, corners.collect()),
            edge("some along x, one along z", 3, 8.0, pair.map(tiny).to_vec()),
            edge("a crowd in a corner", 3, 8.0, crowd.clone().collect()),
            edge(
                "a crowd, and no depth left",
                1,
                8.0,
                crowd.clone().collect(),
            ),
            edge("no depth at all", 0, 8.0, crowd.clone().collect()),
            edge(
                "one that reaches across",
                2,
                8.0,
                crowd.chain([across]).collect(),
            ),
            edge(
                "all at the same place",
                3,
                8.0,
                vec![tiny(vec3(3.9, 3.9, 3.9)); 5],
            ),
            edge(
                "all reach all children",
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
            edge("large sheets, few copies", 2, 1.5, sheets.clone().collect()),
            edge("large sheets, many copies", 2, 64.0, sheets.collect()),
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
        judge(q, golden, got)
    }
}

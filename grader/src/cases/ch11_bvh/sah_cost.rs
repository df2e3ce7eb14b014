//! `sah_cost`: its cases, judge and mistakes.

use super::{area, heaps, tree};
use raybook::accel::bvh::build::Method;
use crate::{Edge, Graded, Mistake, Verdict, judge, sample};
use raybook::math::pcg::Pcg;
use raybook_workbook::exercise::Exercise;
use raybook_workbook::exercises::ch11_bvh::{SahCost, SahCostQuestion};
use raybook_workbook::tree_rows::NodeRow;
use glam::{Vec3, vec3};

/// Σ of a price per node times a measure of its box, by that of the root's.
fn weighted(
    q: &SahCostQuestion,
    measure: fn(&NodeRow) -> f32,
    price: fn(&SahCostQuestion, &NodeRow) -> f32,
) -> f32 {
    let sum: f32 = q.nodes.iter().map(|n| measure(n) * price(q, n)).sum();
    sum / q.nodes.first().map_or(1.0, measure)
}

pub(super) fn node_area(node: &NodeRow) -> f32 {
    area(node.min, node.max)
}

fn node_price(q: &SahCostQuestion, node: &NodeRow) -> f32 {
    match node.count {
        0 => q.branch,
        count => q.shape * count as f32,
    }
}

impl Graded for SahCost {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "forgets to divide by the root's area",
            hint: "Make everything twice as large: does a search take longer?",
            answer: |q| SahCost::answer(q) * q.nodes.first().map_or(1.0, node_area),
        },
        Mistake {
            name: "counts the leaves only",
            hint: "Who comes to a leaf has opened branches before: for free?",
            answer: |q| weighted(&free(q, true), node_area, node_price),
        },
        Mistake {
            name: "counts the branches only",
            hint: "What does a search do once it is in a leaf?",
            answer: |q| weighted(&free(q, false), node_area, node_price),
        },
        Mistake {
            name: "gives every leaf the price of one shape",
            hint: "Does a leaf of five shapes cost as much as a leaf of one?",
            answer: |q| {
                weighted(
                    q,
                    node_area,
                    |q, n| {
                        if n.count == 0 { q.branch } else { q.shape }
                    },
                )
            },
        },
        Mistake {
            name: "weighs by volume",
            hint: "How large is the chance that a ray meets a flat box, which has no volume?",
            answer: |q| weighted(q, |n| (n.max - n.min).element_product(), node_price),
        },
        Mistake {
            name: "leaves out the root",
            hint: "A ray that meets the root's box opens the root, with what probability?",
            answer: |q| SahCost::answer(q) - q.nodes.first().map_or(0.0, |n| node_price(q, n)),
        },
        Mistake {
            name: "counts every node as often as another",
            hint: "Do as many rays meet a small box as a large one?",
            answer: |q| weighted(q, |_| 1.0, node_price),
        },
        Mistake {
            name: "weighs by the longest side",
            hint: "Lines through a box are counted by its surface, not by a length.",
            answer: |q| weighted(q, |n| (n.max - n.min).max_element(), node_price),
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let leaf = |min, max, first, count| NodeRow {
            min,
            max,
            first,
            count,
        };
        let branch = |min, max, first| leaf(min, max, first, 0);
        let (o, one) = (Vec3::ZERO, Vec3::ONE);
        let root = branch(o, vec3(4.0, 1.0, 1.0), 1);
        let halves = vec![
            root.clone(),
            leaf(o, one, 0, 2),
            leaf(vec3(3.0, 0.0, 0.0), vec3(4.0, 1.0, 1.0), 2, 3),
        ];
        let overlapping = vec![
            root.clone(),
            leaf(o, vec3(3.0, 1.0, 1.0), 0, 1),
            leaf(vec3(1.0, 0.0, 0.0), vec3(4.0, 1.0, 1.0), 1, 1),
        ];
        let flat = vec![
            branch(o, vec3(4.0, 0.0, 2.0), 1),
            leaf(o, vec3(1.0, 0.0, 2.0), 0, 4),
            leaf(vec3(2.0, 0.0, 0.0), vec3(4.0, 0.0, 1.0), 4, 2),
        ];
        let chain = vec![
            root,
            leaf(o, one, 0, 1),
            branch(vec3(1.0, 0.0, 0.0), vec3(4.0, 1.0, 1.0), 3),
            leaf(vec3(1.0, 0.0, 0.0), vec3(2.0, 1.0, 1.0), 1, 1),
            leaf(vec3(2.5, 0.0, 0.0), vec3(4.0, 1.0, 1.0), 2, 2),
        ];
        let edge = |name, branch, shape, nodes| {
            let question = SahCostQuestion {
                branch,
                shape,
                nodes,
            };
            Edge::new(name, question)
        };
        vec![
            edge("one leaf is all", 1.0, 1.0, vec![leaf(o, one, 0, 6)]),
            edge("two leaves", 1.0, 1.0, halves.clone()),
            edge("dear branches", 3.0, 1.0, halves.clone()),
            edge("dear shapes", 1.0, 2.5, halves),
            edge("boxes that overlap", 1.0, 1.0, overlapping),
            edge("flat boxes", 1.0, 1.0, flat),
            edge("a branch in a branch", 1.0, 1.0, chain),
        ]
    }

    fn random(rng: &mut Pcg) -> SahCostQuestion {
        let boxes = heaps(rng);
        SahCostQuestion {
            branch: sample::number(rng, 0.5, 2.0),
            shape: sample::number(rng, 0.5, 2.0),
            nodes: tree(&boxes, Method::Median, 8).nodes,
        }
    }

    fn judge(_q: &SahCostQuestion, golden: &f32, got: &f32) -> Verdict {
        judge::number("the cost", "", *golden, *got)
    }
}

/// The question where branches, or shapes, cost nothing.
fn free(q: &SahCostQuestion, branches: bool) -> SahCostQuestion {
    let mut q = q.clone();
    if branches {
        q.branch = 0.0;
    } else {
        q.shape = 0.0;
    }
    q
}

//! `collapse`: its cases, judge and mistakes.

use super::collapse_judge::judge;
use super::{MOST, half_area, is_branch, pair};
use crate::accel::bvh::COST;
use crate::accel::bvh::build::{Method, build, cost::Cost};
use crate::grade::{Edge, Graded, Mistake, Verdict, sample};
use crate::math::{aabb::Aabb, pcg::Pcg};
use crate::workbook::exercise::Exercise;
use crate::workbook::exercises::ch24_wide_bvh::{Collapse, CollapseQuestion, FamilyRow};
use crate::workbook::tree_rows::{NodeRow, to_rows};
use glam::{Vec3, vec3};
use rand::RngExt;

/// Families whose members are chosen by `open`: which of the branches among the members is opened next, if any.
fn families(
    q: &CollapseQuestion,
    open: impl Fn(&CollapseQuestion, &[u32]) -> Option<usize>,
) -> Vec<FamilyRow> {
    let mut families = Vec::new();
    let mut waiting = Vec::new();
    if !q.nodes.is_empty() {
        waiting.push(0);
    }
    while let Some(branch) = waiting.pop() {
        if !is_branch(q, branch) {
            continue;
        }
        let mut children = pair(q, branch).to_vec();
        while let Some(i) = open(q, &children) {
            let opened = children.remove(i);
            children.extend(pair(q, opened));
        }
        waiting.extend(&children);
        families.push(FamilyRow { branch, children });
    }
    families
}

/// The place of the best branch among the members, by an order of numbers.
fn best(
    q: &CollapseQuestion,
    members: &[u32],
    order: fn(&CollapseQuestion, u32) -> f32,
) -> Option<usize> {
    let branches = (0..members.len()).filter(|&i| is_branch(q, members[i]));
    branches.max_by(|&a, &b| order(q, members[a]).total_cmp(&order(q, members[b])))
}

fn while_fewer(
    most: usize,
    order: fn(&CollapseQuestion, u32) -> f32,
) -> impl Fn(&CollapseQuestion, &[u32]) -> Option<usize> {
    move |q, members| {
        (members.len() < most)
            .then(|| best(q, members, order))
            .flatten()
    }
}

/// The families without some members.
pub(super) fn without(
    families: Vec<FamilyRow>,
    keep: impl Fn(usize, u32) -> bool,
) -> Vec<FamilyRow> {
    let thin = |family: FamilyRow| FamilyRow {
        children: (family.children.iter().enumerate())
            .filter(|&(i, &child)| keep(i, child))
            .map(|(_, &child)| child)
            .collect(),
        ..family
    };
    families.into_iter().map(thin).collect()
}

impl Graded for Collapse {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "opens the smallest branch first",
            hint: "Which of two boxes do more rays enter, and which of them would you rather spare a step?",
            answer: |q| families(q, while_fewer(MOST, |q, i| -half_area(q, i))),
        },
        Mistake {
            name: "opens the branches in the order of the list",
            hint: "Not all branches are worth opening alike: what says how often one is entered?",
            answer: |q| families(q, while_fewer(MOST, |_, i| -(i as f32))),
        },
        Mistake {
            name: "keeps two children per branch",
            hint: "There is room for eight: whose children can move up?",
            answer: |q| families(q, while_fewer(2, half_area)),
        },
        Mistake {
            name: "stops at four children",
            hint: "How many lanes does a node have?",
            answer: |q| families(q, while_fewer(4, half_area)),
        },
        Mistake {
            name: "goes on to nine children",
            hint: "Opening a branch takes one member away and brings two: when must you stop?",
            answer: |q| families(q, while_fewer(MOST + 1, half_area)),
        },
        Mistake {
            name: "forgets the second child of the last branch it opens",
            hint: "Count the leaves before and after.",
            answer: |q| {
                let right = Collapse::answer(q);
                without(right, |i, _| i != 7)
            },
        },
        Mistake {
            name: "leaves out leaves",
            hint: "A child may be a leaf or a branch: do both have a place in your node?",
            answer: |q| {
                let right = Collapse::answer(q);
                let leaves: Vec<_> = q.nodes.iter().map(|node| node.count > 0).collect();
                without(right, |_, child| !leaves[child as usize])
            },
        },
        Mistake {
            name: "keeps the branches that it opened",
            hint: "Once a branch's children are members, is the branch still one?",
            answer: |q| {
                let mut right = Collapse::answer(q);
                for family in &mut right {
                    family.children.push(family.branch);
                }
                right
            },
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let row = |n: usize, size: fn(usize) -> f32| {
            let boxes: Vec<_> = (0..n)
                .map(|i| {
                    let at = vec3(3.0 * i as f32, 0.0, 0.0);
                    Aabb {
                        min: at,
                        max: at + Vec3::splat(size(i)),
                    }
                })
                .collect();
            binary_tree(&boxes)
        };
        let one = |_: usize| 1.0;
        let square: Vec<_> = (0..16)
            .map(|i| {
                let at = 2.0 * vec3((i % 4) as f32, (i / 4) as f32, 0.0);
                Aabb {
                    min: at,
                    max: at + Vec3::ONE,
                }
            })
            .collect();
        vec![
            Edge::new("no boxes", row(0, one)),
            Edge::new("a single leaf", row(1, one)),
            Edge::new("two leaves", row(2, one)),
            Edge::new("seven leaves: one node with a place left", row(7, one)),
            Edge::new("eight leaves: one full node", row(8, one)),
            Edge::new("nine leaves: one too many", row(9, one)),
            Edge::new("sixty-four leaves", row(64, one)),
            Edge::new("boxes that grow", row(20, |i| 0.1 + 0.2 * i as f32)),
            Edge::new("a chain: every branch has a leaf", chain(20)),
            Edge::new("a square of sixteen", binary_tree(&square)),
        ]
    }

    fn random(rng: &mut Pcg) -> CollapseQuestion {
        let boxes: Vec<_> = (0..rng.random_range(14..40))
            .map(|_| {
                let (at, size) = (sample::point(rng, 4.0), sample::number(rng, 0.05, 2.0));
                Aabb {
                    min: at,
                    max: at + size * (sample::point(rng, 0.4) + 0.5),
                }
            })
            .collect();
        binary_tree(&boxes)
    }

    fn judge(q: &CollapseQuestion, golden: &Vec<FamilyRow>, got: &Vec<FamilyRow>) -> Verdict {
        judge(q, golden, got)
    }
}

/// A binary tree over boxes, one in each leaf.
fn binary_tree(boxes: &[Aabb]) -> CollapseQuestion {
    let cost = Cost { most: 1, ..COST };
    CollapseQuestion {
        nodes: to_rows(&build(boxes, Method::Binned, &cost)),
    }
}

/// A tree in which each branch has a leaf and the rest.
fn chain(n: u32) -> CollapseQuestion {
    let node = |i: u32, first, count| NodeRow {
        min: vec3(i as f32, 0.0, 0.0),
        max: vec3(if count == 0 { n as f32 } else { i as f32 + 1.0 }, 1.0, 1.0),
        first,
        count,
    };
    let mut nodes = vec![node(0, 1, 0)];
    for i in 0..n - 1 {
        nodes.push(node(i, i, 1));
        let last = i + 2 == n;
        nodes.push(if last {
            node(i + 1, i + 1, 1)
        } else {
            node(i + 1, 2 * i + 3, 0)
        });
    }
    CollapseQuestion { nodes }
}

//! `collapse`: its mistakes.

use super::collapse_cases;
use super::collapse_judge::judge;
use super::{MOST, half_area, is_branch, pair};
use crate::{Graded, Mistake, Verdict};
use raybook::math::pcg::Pcg;
use raybook_workbook::exercise::Exercise;
use raybook_workbook::exercises::ch24_wide_bvh::{Collapse, FamilyRow};

/// Families whose members are chosen by `open`: which of the branches among the members is opened next, if any.
fn families(
    q: &Collapse,
    open: impl Fn(&Collapse, &[u32]) -> Option<usize>,
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
    q: &Collapse,
    members: &[u32],
    order: fn(&Collapse, u32) -> f32,
) -> Option<usize> {
    let branches = (0..members.len()).filter(|&i| is_branch(q, members[i]));
    branches.max_by(|&a, &b| order(q, members[a]).total_cmp(&order(q, members[b])))
}

fn while_fewer(
    most: usize,
    order: fn(&Collapse, u32) -> f32,
) -> impl Fn(&Collapse, &[u32]) -> Option<usize> {
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

    fn random(rng: &mut Pcg) -> Collapse {
        collapse_cases::random(rng)
    }

    fn judge(q: &Collapse, golden: &Vec<FamilyRow>, got: &Vec<FamilyRow>) -> Verdict {
        judge(q, golden, got)
    }
}

//! Ways of choosing a branch's new children as students write them: branches are opened in another order, up to another number, or by level.

use crate::cases::ch24_wide_bvh::{MOST, half_area, is_branch, pair};
use glam::Vec3;
use raybook_workbook::exercises::ch24_wide_bvh::{Collapse, FamilyRow};

/// Families whose members are chosen by `open`: which of the branches among the members is opened next, if any.
pub(super) fn families(
    q: &Collapse,
    open: impl Fn(&Collapse, &[u32]) -> Option<usize>,
) -> Vec<FamilyRow> {
    families_by(q, open, |children, i, two| {
        children.remove(i);
        children.extend(two);
    })
}

/// Families whose members are chosen by `open`, where the two children of a branch that is opened stand in its place.
pub(super) fn in_place(
    q: &Collapse,
    open: impl Fn(&Collapse, &[u32]) -> Option<usize>,
) -> Vec<FamilyRow> {
    families_by(q, open, |children, i, two| {
        children.splice(i..=i, two);
    })
}

/// Families whose members are chosen by `open`; `put` gives the place of member i to its two children.
fn families_by(
    q: &Collapse,
    open: impl Fn(&Collapse, &[u32]) -> Option<usize>,
    put: fn(&mut Vec<u32>, usize, [u32; 2]),
) -> Vec<FamilyRow> {
    families_of(q, |branch| {
        let mut children = pair(q, branch).to_vec();
        while let Some(i) = open(q, &children) {
            let two = pair(q, children[i]);
            put(&mut children, i, two);
        }
        children
    })
}

/// Families whose branches are opened in the order in which they came into the list, of two the right one first.
pub(super) fn from_the_right(q: &Collapse) -> Vec<FamilyRow> {
    let reversed = |branch: u32| pair(q, branch).into_iter().rev();
    families_of(q, |branch| {
        let mut children: Vec<_> = reversed(branch).collect();
        while children.len() < MOST {
            let Some(i) = children.iter().position(|&i| is_branch(q, i)) else {
                break;
            };
            let opened = children.remove(i);
            children.extend(reversed(opened));
        }
        children
    })
}

/// Families of all branches that are met: of those that are left, and of those that were opened, each as often as it was met.
pub(super) fn of_opened_too(q: &Collapse) -> Vec<FamilyRow> {
    /// More lists are not made: of a chain of 19 branches there are 250,000, as each branch is opened again and again.
    const ENOUGH: usize = 10_000;
    let mut families = Vec::new();
    let mut waiting: Vec<_> = (0..q.nodes.len().min(1) as u32).collect();
    while let Some(branch) = waiting.pop() {
        if !is_branch(q, branch) || families.len() == ENOUGH {
            continue;
        }
        let mut children = pair(q, branch).to_vec();
        while let Some(i) = while_fewer(MOST, half_area)(q, &children) {
            let opened = children.remove(i);
            children.extend(pair(q, opened));
            waiting.push(opened);
        }
        waiting.extend(&children);
        families.push(FamilyRow { branch, children });
    }
    families
}

/// Families of these members of each branch.
pub(super) fn families_of(q: &Collapse, members: impl Fn(u32) -> Vec<u32>) -> Vec<FamilyRow> {
    let mut families = Vec::new();
    let mut waiting = Vec::new();
    if !q.nodes.is_empty() {
        waiting.push(0);
    }
    while let Some(branch) = waiting.pop() {
        if !is_branch(q, branch) {
            continue;
        }
        let children = members(branch);
        waiting.extend(&children);
        families.push(FamilyRow { branch, children });
    }
    families
}

/// The place of the first of the best branches among the members, by an order of numbers.
pub(super) fn best(
    q: &Collapse,
    members: &[u32],
    order: fn(&Collapse, u32) -> f32,
) -> Option<usize> {
    let branches = (0..members.len()).filter(|&i| is_branch(q, members[i]));
    let backwards = branches.rev(); // the last of the greatest is found
    backwards.max_by(|&a, &b| order(q, members[a]).total_cmp(&order(q, members[b])))
}

pub(super) fn while_fewer(
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

/// The size of a node's box.
pub(super) fn size(q: &Collapse, i: u32) -> Vec3 {
    let node = &q.nodes[i as usize];
    node.max - node.min
}

/// The nodes three levels below a branch, and the leaves that lie above them.
pub(super) fn three_levels_down(q: &Collapse, branch: u32) -> Vec<u32> {
    let below = |node: u32| {
        if is_branch(q, node) {
            pair(q, node).to_vec()
        } else {
            vec![node]
        }
    };
    let children = below(branch).into_iter();
    children.flat_map(below).flat_map(below).collect()
}

/// Takes a node itself, or instead of a branch what is below it, as long as there are places for both of its sides: the left one
/// has half of them, and the right one those that are left.
pub(super) fn take(q: &Collapse, node: u32, places: usize, taken: &mut Vec<u32>) {
    if !is_branch(q, node) || places < 2 {
        taken.push(node);
        return;
    }
    let [left, right] = pair(q, node);
    let before = taken.len();
    take(q, left, places / 2, taken);
    take(q, right, places - (taken.len() - before), taken);
}

/// The number of leaves below a node.
pub(super) fn leaves_below(q: &Collapse, node: u32) -> u32 {
    if is_branch(q, node) {
        pair(q, node)
            .map(|child| leaves_below(q, child))
            .iter()
            .sum()
    } else {
        1
    }
}

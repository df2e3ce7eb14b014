//! Ways of choosing a branch's new children as students write them: branches are opened in another order, up to another number, or by level.

use crate::cases::ch24_wide_bvh::{MOST, half_area, is_branch, pair};
use crate::upon::changed;
use glam::Vec3;
use raybook_workbook::exercises::ch24_wide_bvh::{Collapse, FamilyRow};

/// How families are made; one field wrong is a mistake.
#[derive(Clone, Copy)]
pub(super) struct How {
    /// How many members a family may have.
    pub(super) most: usize,
    /// How many of the members count.
    pub(super) count: fn(q: &Collapse, members: &[u32]) -> usize,
    /// By which the branch that is opened next is the greatest.
    pub(super) order: Order,
    /// The place of the member that is opened next, if any is.
    pub(super) next: fn(q: &Collapse, members: &[u32], order: Order) -> Option<usize>,
    /// Takes away member `i`, and adds its two children.
    pub(super) put: fn(members: &mut Vec<u32>, i: usize, two: [u32; 2]),
    /// The children of a branch.
    pub(super) pair: fn(q: &Collapse, branch: u32) -> [u32; 2],
    /// The members of a branch's family; `open` gives the children of a branch, and notes that it was opened.
    pub(super) members: fn(q: &Collapse, how: &How, branch: u32, open: Open<'_>) -> Vec<u32>,
    /// Of which branches there are lists.
    pub(super) lists: Lists,
}

/// A node's place among others, as a number.
pub(super) type Order = fn(q: &Collapse, node: u32) -> f32;

/// Opens a branch.
pub(super) type Open<'a> = &'a mut dyn FnMut(u32) -> [u32; 2];

/// Of which branches there are lists.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Lists {
    /// Of those that are left.
    Left,
    /// Of all branches of the binary tree.
    All,
    /// Of those that are left, and of those that were opened, each as often as it was met.
    OpenedToo,
}

/// As it should be, or nearly: the largest of the branches is opened.
const WELL: How = How {
    most: MOST,
    count: |_, members| members.len(),
    order: half_area,
    next: best,
    put: |members, i, two| {
        members.remove(i);
        members.extend(two);
    },
    pair,
    members: one_by_one,
    lists: Lists::Left,
};

/// The families, made rightly but for what is changed.
pub(super) fn families(q: &Collapse, change: fn(&mut How)) -> Vec<FamilyRow> {
    /// More lists are not made of what was opened: of a chain of 19 branches there are 250,000, as each branch is opened again and again.
    const ENOUGH: usize = 10_000;
    let how = changed(WELL, change);
    let mut families = Vec::new();
    let all = match how.lists {
        Lists::All => q.nodes.len(),
        _ => q.nodes.len().min(1),
    };
    let mut waiting: Vec<_> = (0..all as u32).rev().collect();
    while let Some(branch) = waiting.pop() {
        let is_enough = how.lists == Lists::OpenedToo && families.len() == ENOUGH;
        if !is_branch(q, branch) || is_enough {
            continue;
        }
        let mut opened = Vec::new();
        let children = (how.members)(q, &how, branch, &mut |node| {
            opened.push(node);
            (how.pair)(q, node)
        });
        if how.lists == Lists::OpenedToo {
            waiting.extend(opened.into_iter().filter(|node| *node != branch));
        }
        if how.lists != Lists::All {
            waiting.extend(&children);
        }
        families.push(FamilyRow { branch, children });
    }
    families
}

/// Opens one of the members after the other.
fn one_by_one(q: &Collapse, how: &How, branch: u32, open: Open<'_>) -> Vec<u32> {
    let mut members = open(branch).to_vec();
    while (how.count)(q, &members) < how.most
        && let Some(i) = (how.next)(q, &members, how.order)
    {
        let two = open(members[i]);
        (how.put)(&mut members, i, two);
    }
    members
}

/// The place of the first of the best branches among the members, by an order of numbers.
fn best(q: &Collapse, members: &[u32], order: Order) -> Option<usize> {
    let branches = (0..members.len()).filter(|&i| is_branch(q, members[i]));
    let backwards = branches.rev(); // the last of the greatest is found
    backwards.max_by(|&a, &b| order(q, members[a]).total_cmp(&order(q, members[b])))
}

/// The place of the first branch among the members.
pub(super) fn first(q: &Collapse, members: &[u32], _: Order) -> Option<usize> {
    members.iter().position(|&i| is_branch(q, i))
}

/// The place of the last branch among the members.
pub(super) fn last(q: &Collapse, members: &[u32], _: Order) -> Option<usize> {
    members.iter().rposition(|&i| is_branch(q, i))
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
pub(super) fn three_levels(q: &Collapse, _: &How, branch: u32, open: Open<'_>) -> Vec<u32> {
    let mut members = vec![branch];
    for _ in 0..3 {
        let below = members.into_iter().flat_map(|node| {
            if is_branch(q, node) {
                open(node).to_vec()
            } else {
                vec![node]
            }
        });
        members = below.collect();
    }
    members
}

/// A node itself, or instead of a branch what is below it, as long as there are places for both of its sides: the left one has half of them, and the
/// right one those that are left.
pub(super) fn take(q: &Collapse, node: u32, places: usize, open: Open<'_>) -> Vec<u32> {
    if !is_branch(q, node) || places < 2 {
        return vec![node];
    }
    let [left, right] = open(node);
    let mut taken = take(q, left, places / 2, open);
    taken.extend(take(q, right, places - taken.len(), open));
    taken
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

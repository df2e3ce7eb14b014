//! From two children to eight: levels of the binary tree are left out.

use super::node::CHILDREN;
use crate::accel::bvh::build::flat::{Flat, Node};
use crate::accel::bvh::pair::Pair;

/// A branch of the binary tree that stays, and the nodes that become its children.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Family {
    /// The number of the branch.
    pub branch: u32,
    /// The numbers of its new children.
    pub children: Vec<u32>,
}

/// A binary tree as a list: the root, then the two children of pair 0, the two of pair 1, and so on.
pub fn binary(flat: &Flat) -> Vec<Node> {
    let below = flat.pairs.iter().flat_map(Pair::nodes);
    flat.root.into_iter().chain(below).collect()
}

/// The two children of a branch, by number.
pub fn children(branch: &Node) -> [u32; 2] {
    [1, 2].map(|side| 2 * branch.link.first + side)
}

/// Half the surface area of a node's box, in square metres; the probability that a ray meets the box is proportional to it.
pub fn half_area(node: &Node) -> f32 {
    let size = node.bounds.size();
    size.x * size.y + size.y * size.z + size.z * size.x
}

// ANCHOR: collapse
/// The families of a tree with up to eight children per branch, the root's first; none if the root is a leaf.
///
/// `nodes` is a binary tree: the root, then pairs; a branch's (count = 0) children are those of its pair.
/// A branch's new children are at first its two old ones. Then the one with the largest surface gives way to *its* two
/// children, for that is the box which most rays enter; and so on, until there are eight, or only leaves.
pub fn collapse(nodes: &[Node]) -> Vec<Family> {
    let mut families = Vec::new();
    let mut waiting: Vec<u32> = nodes.first().map(|_| 0).into_iter().collect();
    while let Some(branch) = waiting.pop() {
        if nodes[branch as usize].link.count > 0 {
            continue;
        }
        let mut members = Vec::with_capacity(CHILDREN);
        members.extend(children(&nodes[branch as usize]));
        while members.len() < CHILDREN {
            let branches =
                (0..members.len()).filter(|&i| nodes[members[i] as usize].link.count == 0);
            let area = |i: usize| half_area(&nodes[members[i] as usize]);
            let Some(largest) = branches.max_by(|&a, &b| area(a).total_cmp(&area(b))) else {
                break;
            };
            let opened = members.swap_remove(largest);
            members.extend(children(&nodes[opened as usize]));
        }
        waiting.extend(members.iter().rev());
        families.push(Family {
            branch,
            children: members,
        });
    }
    families
}
// ANCHOR_END: collapse

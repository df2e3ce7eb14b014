//! From two children to eight with the fewest steps: which branches stay is a matter of the whole subtree.

use super::collapse::{Family, children, half_area};
use super::node::CHILDREN;
use crate::accel::bvh::build::flat::Node;

/// The families of a tree with up to eight children per branch, like those of [`collapse`](super::collapse::collapse); but
/// of all ways to leave out branches, the one by which rays come to the fewest.
///
/// Opening the largest child fills the upper nodes, and what is left for the lower ones are odd ends: they have four
/// children on average, and are nearly twice as many. Here each subtree says first what it costs as 1, 2, … 7 children of
/// a node above it, from the leaves up; then the root divides eight places between its two subtrees, each of them its
/// places between its own, and so on (dynamic programming; Susano Pinto 2010, Ylitie, Karras and Laine 2017).
pub fn collapse(nodes: &[Node]) -> Vec<Family> {
    let prices = prices(nodes);
    let mut families = Vec::new();
    let mut waiting: Vec<u32> = nodes.first().map(|_| 0).into_iter().collect();
    while let Some(branch) = waiting.pop() {
        if nodes[branch as usize].link.count > 0 {
            continue;
        }
        let mut members = Vec::with_capacity(CHILDREN);
        let [left, right] = children(&nodes[branch as usize]);
        let (_, for_left) = divide(&prices, [left, right], CHILDREN);
        let mut open = vec![(right, CHILDREN - for_left), (left, for_left)];
        while let Some((member, places)) = open.pop() {
            let price = &prices[member as usize];
            // More places may be of no use.
            let places = (1..=places)
                .find(|&fewer| price[fewer] <= price[places])
                .unwrap_or(places);
            if places == 1 {
                members.push(member);
            } else {
                let [left, right] = children(&nodes[member as usize]);
                let (_, for_left) = divide(&prices, [left, right], places);
                open.extend([(right, places - for_left), (left, for_left)]);
            }
        }
        waiting.extend(members.iter().rev());
        families.push(Family {
            branch,
            children: members,
        });
    }
    families
}

/// Per node, for i < 8: the areas of all branches that stay at or below it if it may take up to i places of a node above.
/// A leaf takes one place, and has no branches.
fn prices(nodes: &[Node]) -> Vec<[f32; CHILDREN]> {
    let mut prices = vec![[0.0; CHILDREN]; nodes.len()];
    for (i, node) in nodes.iter().enumerate().rev() {
        if node.link.count > 0 {
            continue;
        }
        let below = |places| divide(&prices, children(node), places).0;
        let mut price = [half_area(node) + below(CHILDREN); CHILDREN];
        for places in 2..CHILDREN {
            price[places] = below(places).min(price[places - 1]);
        }
        prices[i] = price;
    }
    prices
}

/// The least price of two subtrees in `places` places, and how many of these the left one gets.
fn divide(prices: &[[f32; CHILDREN]], [left, right]: [u32; 2], places: usize) -> (f32, usize) {
    let (left, right) = (&prices[left as usize], &prices[right as usize]);
    let mut best = (f32::INFINITY, 1);
    for for_left in 1..places {
        let price = left[for_left] + right[places - for_left];
        if price < best.0 {
            best = (price, for_left);
        }
    }
    best
}

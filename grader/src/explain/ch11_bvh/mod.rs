//! Chapter 11: the price of a tree of boxes, its best cut, the tree that the cuts make, and the search in it.

mod build;
mod cost;
mod cut;
mod search;

use super::tree::Node;
pub use cost::area_by_steps;
use raybook_workbook::tree_rows::NodeRow;

/// The children of a branch, left and right; none of a leaf.
pub fn children(row: &NodeRow) -> Vec<usize> {
    let first = row.first as usize;
    if row.count == 0 {
        vec![first, first + 1]
    } else {
        Vec::new()
    }
}

/// The nodes of a tree to be drawn, of which some are met: each with its number and what else is said of it.
pub fn drawn(
    rows: &[NodeRow],
    is_met: impl Fn(usize) -> bool,
    more: impl Fn(usize) -> String,
) -> Vec<Node> {
    let node = |(i, row): (usize, &NodeRow)| Node {
        name: format!("{i}{}", more(i)),
        is_met: is_met(i),
        children: children(row),
    };
    rows.iter().enumerate().map(node).collect()
}

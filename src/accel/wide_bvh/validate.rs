//! What every wide tree keeps to.

use super::node::{CHILDREN, Link, TRIANGLES};
use super::tree::Tree;
use crate::math::aabb::Aabb;
use crate::shape::Shape;

/// Checks a tree:
///
/// - every facet is in exactly one leaf;
/// - a leaf holds its facets' corners and ids as they are, and NaN in the places without one;
/// - a node's box of a child is the smallest that holds what is below, and the places without a child have inverted boxes;
/// - every node has at least two children, and is the child of one node.
///
/// # Errors
/// Says which invariant is broken, and where.
pub(super) fn validate(tree: &Tree) -> Result<(), String> {
    let mut walk = Walk {
        tree,
        seen: vec![false; tree.facets.len()],
        nodes: 0,
        leaves: 0,
    };
    if let Some(root) = tree.root {
        walk.child(root)?;
    }
    if let Some(lost) = walk.seen.iter().position(|seen| !seen) {
        return Err(format!("facet {lost} is in no leaf"));
    }
    if (walk.nodes, walk.leaves) == (tree.nodes.len(), tree.leaves.len()) {
        Ok(())
    } else {
        Err(format!(
            "{} of {} nodes and {} of {} leaves are reached",
            walk.nodes,
            tree.nodes.len(),
            walk.leaves,
            tree.leaves.len()
        ))
    }
}

struct Walk<'a> {
    tree: &'a Tree,
    /// The facets that were met.
    seen: Vec<bool>,
    nodes: usize,
    leaves: usize,
}

impl Walk<'_> {
    /// The box of what is below a child.
    fn child(&mut self, link: Link) -> Result<Aabb, String> {
        match link.as_leaf() {
            Some(leaf) => self.leaf(leaf),
            None => self.node(link.index()),
        }
    }

    fn node(&mut self, i: usize) -> Result<Aabb, String> {
        let node = self
            .tree
            .nodes
            .get(i)
            .ok_or_else(|| format!("there is no node {i}"))?;
        self.nodes += 1;
        if self.nodes > self.tree.nodes.len() {
            return Err(format!("node {i} is the child of two"));
        }
        let mut all = Aabb::EMPTY;
        let mut count = 0;
        for (bounds, link) in node.children() {
            let below = self.child(link)?;
            if bounds != below {
                return Err(format!(
                    "node {i} has {bounds:?} for a child whose box is {below:?}"
                ));
            }
            all = all.union(&bounds);
            count += 1;
        }
        let inverted = (0..CHILDREN)
            .filter(|&lane| node.links[lane] == Link::NONE)
            .all(|lane| node.rows[0][lane] > node.rows[1][lane]);
        if count < 2 || !inverted {
            return Err(format!(
                "node {i} has {count} children, and the other boxes must be inverted"
            ));
        }
        Ok(all)
    }

    fn leaf(&mut self, i: usize) -> Result<Aabb, String> {
        let leaf = self
            .tree
            .leaves
            .get(i)
            .ok_or_else(|| format!("there is no leaf {i}"))?;
        self.leaves += 1;
        let mut all = Aabb::EMPTY;
        let mut count = 0;
        for lane in 0..TRIANGLES {
            let at = |corner: usize, axis: usize| leaf.corners[corner][axis][lane];
            let Some(facet) = self.tree.facets.get(leaf.facets[lane] as usize) else {
                if (0..3).any(|corner| !at(corner, 0).is_nan()) {
                    return Err(format!("leaf {i} has corners where there is no facet"));
                }
                continue;
            };
            if std::mem::replace(&mut self.seen[leaf.facets[lane] as usize], true) {
                return Err(format!("facet {} is in two leaves", leaf.facets[lane]));
            }
            let same = (0..3).all(|corner| {
                (0..3)
                    .all(|axis| at(corner, axis).to_bits() == facet.corners[corner][axis].to_bits())
            });
            if !same || leaf.ids[lane] != facet.id {
                return Err(format!("leaf {i} does not hold {facet:?} as it is"));
            }
            all = all.union(&facet.bounds());
            count += 1;
        }
        if count == 0 {
            return Err(format!("leaf {i} is empty"));
        }
        Ok(all)
    }
}

//! The invariants of every tree.

use crate::accel::bvh::build::flat::Node;
use crate::accel::bvh::build::tree::MAX_DEPTH;
use crate::accel::bvh::pair::Pair;
use crate::math::aabb::Aabb;

/// Checks a tree over boxes, which are in the order of its leaves:
///
/// - the leaves hold all boxes, one leaf after the other, and no leaf is empty;
/// - every node's box is the smallest that holds everything below the node;
/// - the pairs are in depth-first order, each the children of one branch;
/// - no leaf is deeper than `MAX_DEPTH`.
///
/// # Errors
/// Says which invariant is broken, and where.
pub fn validate(root: Option<&Node>, pairs: &[Pair], boxes: &[Aabb]) -> Result<(), String> {
    let mut walk = Walk {
        pairs,
        boxes,
        pair: 0,
        shape: 0,
    };
    if let Some(root) = root {
        walk.node(root, 0)?;
    }
    if (walk.pair, walk.shape) == (pairs.len(), boxes.len()) {
        Ok(())
    } else {
        Err(format!(
            "the tree reaches {} of {} pairs and {} of {} shapes",
            walk.pair,
            pairs.len(),
            walk.shape,
            boxes.len()
        ))
    }
}

/// A walk through the tree, depth-first.
struct Walk<'a> {
    pairs: &'a [Pair],
    boxes: &'a [Aabb],
    /// The pair that comes next.
    pair: usize,
    /// The shape that comes next.
    shape: usize,
}

impl Walk<'_> {
    fn node(&mut self, node: &Node, depth: u32) -> Result<(), String> {
        let first = node.link.first as usize;
        let below = if node.link.count > 0 {
            let end = first + node.link.count as usize;
            let boxes = self.boxes.get(first..end);
            let boxes = boxes.filter(|_| first == self.shape).ok_or_else(|| {
                format!(
                    "a leaf holds shapes {first} to {end} of {}, and {} comes next",
                    self.boxes.len(),
                    self.shape
                )
            })?;
            self.shape = end;
            boxes.iter().fold(Aabb::EMPTY, |all, b| all.union(b))
        } else {
            let pair = self.pairs.get(first).filter(|_| first == self.pair);
            let pair = pair.ok_or_else(|| {
                format!(
                    "a branch has pair {first} of {}, and {} comes next",
                    self.pairs.len(),
                    self.pair
                )
            })?;
            if depth == MAX_DEPTH {
                return Err(format!(
                    "pair {first} is more than {MAX_DEPTH} branches deep"
                ));
            }
            self.pair += 1;
            let [left, right] = pair.nodes();
            self.node(&left, depth + 1)?;
            self.node(&right, depth + 1)?;
            left.bounds.union(&right.bounds)
        };
        if below == node.bounds {
            Ok(())
        } else {
            Err(format!(
                "{node:?} should be the box {below:?} of what is below"
            ))
        }
    }
}

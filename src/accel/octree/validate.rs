//! The invariants of an octree.

use crate::accel::octree::Octree;
use crate::accel::octree::tree::Kind;
use crate::math::aabb::Aabb;
use crate::shape::Shape;

impl<S: Shape> Octree<S> {
    /// Checks the octree's invariants.
    ///
    /// # Errors
    /// The first invariant that does not hold, in words.
    pub fn validate(&self) -> Result<(), String> {
        let (tree, shapes) = (&self.tree, &self.shapes);
        let mut parents = vec![0; tree.nodes.len()];
        for (node, i) in tree.nodes.iter().zip(0..) {
            if let Kind::Inner { children, occupied } = node.kind() {
                if children <= i || children as usize + 8 > tree.nodes.len() {
                    return Err(format!("node {i}'s children are not after it in the array"));
                }
                for child in children..children + 8 {
                    parents[child as usize] += 1;
                    let is_empty = matches!(
                        tree.nodes[child as usize].kind(),
                        Kind::Leaf { count: 0, .. }
                    );
                    if is_empty == (occupied >> (child - children) & 1 != 0) {
                        return Err(format!(
                            "node {i} is wrong about whether child {child} is empty"
                        ));
                    }
                }
            }
        }
        if parents[0] != 0 || parents[1..].iter().any(|&parents| parents != 1) {
            return Err("not every node but the root has one parent".to_owned());
        }
        let mut ranges: Vec<_> = (0..tree.nodes.len() as u32)
            .map(|i| tree.range(i))
            .collect();
        ranges.retain(|range| !range.is_empty());
        ranges.sort_by_key(|range| range.start);
        let ends = std::iter::once(0).chain(ranges.iter().map(|range| range.end));
        let starts = ranges.iter().map(|range| range.start);
        if !ends.eq(starts.chain([tree.named.len()])) {
            return Err("the leaves' lists do not fill the array, end to end".to_owned());
        }
        let mut leaves = vec![0; shapes.len()];
        for place in tree.places() {
            let list = tree.shapes_in(place.node);
            for (at, &i) in list.iter().enumerate() {
                let Some(shape) = shapes.get(i as usize) else {
                    return Err(format!(
                        "leaf {} names shape {i}, which is none",
                        place.node
                    ));
                };
                let Aabb { min, max } = shape.bounds();
                if min.cmpgt(place.cell.max).any() || max.cmplt(place.cell.min).any() {
                    return Err(format!("shape {i} does not reach leaf {}", place.node));
                }
                if list[..at].contains(&i) {
                    return Err(format!("leaf {} names shape {i} twice", place.node));
                }
                leaves[i as usize] += 1;
            }
        }
        for (i, shape) in shapes.iter().enumerate() {
            let Aabb { min, max } = shape.bounds();
            if leaves[i] == 0 {
                return Err(format!("shape {i} is in no leaf"));
            }
            if !tree.bounds.contains(min) || !tree.bounds.contains(max) {
                return Err(format!("shape {i} reaches out of the root"));
            }
        }
        Ok(())
    }
}

//! What every wide tree keeps to.

use super::node::{CHILDREN, Link, TRIANGLES};
use super::tree::Tree;
use crate::math::aabb::Aabb;
use crate::shape::{Shape, mesh::Facet};
use glam::Vec3;

/// Checks a tree:
///
/// - every facet is in a leaf, and in several only if it is cut: each of its points is in the box of one of them;
/// - a leaf holds its facets' corners and ids as they are, and NaN in the places without one;
/// - a node's box of a child that is a node is the smallest that holds the boxes in it, and that of a leaf is no larger than its
///   facets; the places without a child have inverted boxes;
/// - every node has at least two children, and is the child of one node.
///
/// # Errors
/// Says which invariant is broken, and where.
pub(super) fn validate(tree: &Tree) -> Result<(), String> {
    let mut walk = Walk {
        tree,
        covered: vec![0; tree.facets.len()],
        nodes: 0,
        leaves: 0,
    };
    if let Some(root) = tree.root {
        match root.as_leaf() {
            Some(leaf) => walk.leaf(leaf, &EVERYTHING)?,
            None => walk.node(root.index())?,
        };
    }
    let whole = (1 << POINTS.len()) - 1;
    if let Some(lost) = walk.covered.iter().position(|&covered| covered != whole) {
        return Err(format!("facet {lost}, or a part of it, is in no leaf"));
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

/// The box of all points.
const EVERYTHING: Aabb = Aabb {
    min: Vec3::NEG_INFINITY,
    max: Vec3::INFINITY,
};

/// Points of a triangle, as weights of its corners, in quarters: three by which the whole box is known, and others between.
const POINTS: [[f32; 3]; 9] = [
    [4.0, 0.0, 0.0],
    [0.0, 4.0, 0.0],
    [0.0, 0.0, 4.0],
    [2.0, 2.0, 0.0],
    [0.0, 2.0, 2.0],
    [2.0, 0.0, 2.0],
    [2.0, 1.0, 1.0],
    [1.0, 2.0, 1.0],
    [1.0, 1.0, 2.0],
];

/// Which of a facet's [`POINTS`] a box holds, as bits; they are rounded, and those on a face count.
fn points_in(bounds: &Aabb, facet: &Facet) -> u16 {
    let [a, b, c] = facet.corners;
    let far = facet.bounds();
    let rounding = f32::EPSILON * far.min.abs().max(far.max.abs());
    let (min, max) = (bounds.min - rounding, bounds.max + rounding);
    let is_in = |[u, v, w]: [f32; 3]| {
        let p = u * 0.25 * a + v * 0.25 * b + w * 0.25 * c;
        // A corner of NaN is nowhere, and not outside.
        !p.cmplt(min).any() && !p.cmpgt(max).any()
    };
    let bits = POINTS.iter().zip(0..);
    bits.map(|(&point, bit)| u16::from(is_in(point)) << bit)
        .sum()
}

struct Walk<'a> {
    tree: &'a Tree,
    /// Which of each facet's points were met in the box of a leaf that holds it.
    covered: Vec<u16>,
    nodes: usize,
    leaves: usize,
}

impl Walk<'_> {
    /// Checks what is below a child with this box.
    fn child(&mut self, link: Link, bounds: &Aabb) -> Result<(), String> {
        let (fits, below) = if let Some(leaf) = link.as_leaf() {
            let facets = self.leaf(leaf, bounds)?;
            (facets.union(bounds) == facets, facets)
        } else {
            let below = self.node(link.index())?;
            (below == *bounds, below)
        };
        if fits {
            Ok(())
        } else {
            Err(format!(
                "{link:?} has {bounds:?}, and the box of what it holds is {below:?}"
            ))
        }
    }

    /// The box of all boxes in a node.
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
            self.child(link, &bounds)
                .map_err(|error| format!("in node {i}, {error}"))?;
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

    /// The box of the facets of a leaf, whose own box is given.
    fn leaf(&mut self, i: usize, bounds: &Aabb) -> Result<Aabb, String> {
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
            self.covered[leaf.facets[lane] as usize] |= points_in(bounds, facet);
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

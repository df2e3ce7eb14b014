//! Chapter 24: `collapse`, `wide_closest`.

use crate::exercise::exercises;
use crate::exercises::ch07_mesh::{Corners, MeshHitAnswer};
use crate::record::row;
use crate::tree_rows::{NodeRow, to_flat};
use glam::Vec3;
use raybook::accel::Tests;
use raybook::inside::wide_bvh::{CHILDREN, Link, TRIANGLES, Tree, binary, collapse};
use raybook::math::{aabb::Aabb, interval::Interval, ray::Ray};
use raybook::shape::mesh::Facet;

exercises! { ($) ch24_wide_bvh
    /// Make a tree of up to eight children per branch out of a binary tree: among a branch's children, replace the
    /// branch whose box has the largest area by its own two children, until there are eight children or no branch is
    /// left among them. Return each branch that stays, with its new children.
    Collapse: collapse(
        /// The binary tree: the root, then pairs of children.
        nodes: Vec<NodeRow>,
    ) -> (
        /// The branches that stay, in any order.
        families: Vec<FamilyRow>,
    ) {
        let nodes = binary(&to_flat(&nodes, 0));
        let families = collapse(&nodes).into_iter().map(|family| FamilyRow {
            branch: family.branch,
            children: family.children,
        });
        families.collect()
    }

    /// Return the nearest triangle of the tree that the ray hits with min < t < max: its distance and its number. Count
    /// every node that you open and every triangle that you test, and open and test as few as you can.
    WideClosest: wide_closest(
        /// The ray.
        ray: Ray,
        /// The distances that count: min < t < max, in metres.
        within: Interval,
        /// The nodes; the root is number 0.
        nodes: Vec<WideNode>,
        /// The leaves; their numbers count from 0.
        leaves: Vec<WideLeaf>,
        /// The triangles; their ids count from 0.
        triangles: Vec<Corners>,
    ) -> (
        /// The nearest hit, and the work that it took to find it.
        answer: WideClosestAnswer,
    ) |q| {
        let mut count = Tests::default();
        let hit = tree(q).and_then(|tree| tree.closest(&q.ray, q.within, &mut count));
        WideClosestAnswer {
            nodes: count.boxes as u32,
            tests: count.shapes as u32,
            hit: hit.map(|hit| MeshHitAnswer {
                t: hit.t,
                id: hit.id,
            }),
        }
    }
}

row! {
    /// A branch that stays, and its new children.
    pub struct FamilyRow {
        /// The number of the branch, from 0.
        pub branch: u32,
        /// The numbers of the nodes that become its children.
        pub children: Vec<u32>,
    }
}

row! {
    /// A child of a node.
    pub struct WideChild {
        /// The least corner of its box, in metres.
        pub min: Vec3,
        /// The greatest corner of its box, in metres.
        pub max: Vec3,
        /// 1 for a leaf, 0 for a node.
        pub leaf: u32,
        /// The number of the leaf or the node, from 0.
        pub index: u32,
    }
}

row! {
    /// A node.
    pub struct WideNode {
        /// The children, at most eight.
        pub children: Vec<WideChild>,
    }
}

row! {
    /// A leaf.
    pub struct WideLeaf {
        /// The numbers of its triangles, at most four.
        pub triangles: Vec<u32>,
    }
}

row! {
    /// The nearest triangle, and the work that it took to find it.
    pub struct WideClosestAnswer {
        /// The number of nodes opened: the boxes of all children of a node are tested at once.
        pub nodes: u32,
        /// The number of triangles tested.
        pub tests: u32,
        /// The nearest hit; none for a miss.
        pub hit: Option<MeshHitAnswer>,
    }
}

/// The tree of a question. Children that do not exist are left out, and a child comes after its parent.
fn tree(q: &WideClosest) -> Option<Tree> {
    let corners = q.triangles.iter().map(|t| [t.p0, t.p1, t.p2]).zip(0..);
    let facets: Vec<_> = corners.map(|(corners, id)| Facet { corners, id }).collect();
    let leaf = |leaf: &WideLeaf| {
        let exist = leaf.triangles.iter().copied();
        let exist = exist.filter(|&i| (i as usize) < facets.len());
        exist.take(TRIANGLES).collect()
    };
    let node = |(i, node): (usize, &WideNode)| {
        let exist = node.children.iter().filter(|child| {
            let index = child.index as usize;
            match child.leaf {
                0 => i < index && index < q.nodes.len(),
                _ => index < q.leaves.len(),
            }
        });
        let child = |child: &WideChild| {
            let (min, max) = (child.min, child.max);
            let index = child.index as usize;
            let link = match child.leaf {
                0 => Link::node(index),
                _ => Link::leaf(index),
            };
            (Aabb { min, max }, link)
        };
        exist.take(CHILDREN).map(child).collect()
    };
    let nodes: Vec<_> = q.nodes.iter().enumerate().map(node).collect();
    let leaves: Vec<_> = q.leaves.iter().map(leaf).collect();
    Tree::new(facets, &leaves, &nodes).ok()
}

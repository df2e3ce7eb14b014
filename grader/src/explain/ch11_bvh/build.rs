//! The tree that the cheapest cuts make.

use super::cut::{around, best_cut};
use crate::explain::Explained;
use crate::explain::diagram::{Diagram, Ink};
use crate::explain::tree::area;
use crate::explain::view::{AXES, View, middle, shrunk};
use crate::explain::way::Way;
use glam::{DVec2, Vec3};
use raybook_workbook::exercises::ch11_bvh::{BvhBuild, BvhBuildAnswer};
use raybook_workbook::tree_rows::NodeRow;
use std::collections::VecDeque;

/// A node that is still to be cut, or not: its number, and the boxes below it.
type Growing = (usize, Vec<u32>);

/// The tree over all boxes, depth first, the left child before the right one; or level by level.
fn grown(q: &BvhBuild, way: &mut Way, by_levels: bool) -> BvhBuildAnswer {
    let mut tree = BvhBuildAnswer {
        nodes: Vec::new(),
        order: Vec::new(),
    };
    if q.boxes.is_empty() {
        way.remark("There are no boxes: the tree has no nodes.");
        return tree;
    }
    tree.nodes.push(NodeRow {
        min: Vec3::ZERO,
        max: Vec3::ZERO,
        first: 0,
        count: 0,
    });
    let all: Vec<u32> = (0..q.boxes.len() as u32).collect();
    let mut to_do = VecDeque::from([(0, all)]);
    while let Some((node, some)) = to_do.pop_front() {
        let children = grow(q, way, &mut tree, node, &some).into_iter().flatten();
        if by_levels {
            to_do.extend(children);
        } else {
            children.rev().for_each(|child| to_do.push_front(child));
        }
    }
    tree
}

/// Cuts a node over some boxes, or makes it a leaf: the children that it gets.
fn grow(
    q: &BvhBuild,
    way: &mut Way,
    tree: &mut BvhBuildAnswer,
    node: usize,
    some: &[u32],
) -> Option<[Growing; 2]> {
    let n = some.len();
    // Until now a child has its parent's box.
    let NodeRow { min, max, .. } = tree.nodes[node];
    let own = around(&q.boxes, some);
    let of_parent = if node == 0 { own } else { [min, max] };
    let [min, max] = way.made("to give a child a box of its own", of_parent, own);
    way.number(format!("node {node}: its number of boxes"), "", n as f64);
    // The steps of the first cut are told; the others go the same way.
    let cut = if node == 0 {
        best_cut(way, &q.boxes, some)
    } else {
        way.silently(|way| best_cut(way, &q.boxes, some))
    };
    let whole = way.part("the area of a node's box", area(own));
    // Both sides are reckoned as leaves here: as a rule it is right, and cheap.
    let branch = way.part("the cost of opening a branch, times its area", whole);
    let sides = cut.as_ref().map_or(f64::INFINITY, |cut| cut.cost);
    let leaf = way.part(
        "the cost of the leaf: its area times its number",
        n as f64 * whole,
    );
    let saves = way.is_less("a cut is cheaper than the leaf", branch + sides, leaf);
    let most = way.part("most", q.most.into());
    let is_full = way.is_less("a leaf would have more boxes than `most`", most, n as f64);
    let few = way.limit(
        "the number of boxes up to which a node stays a leaf, whatever a cut costs",
        1,
    );
    let pays = saves && n > few;
    let Some(cut) = cut.filter(|_| pays || is_full) else {
        way.remark("A leaf: a cut would cost the branch, and save no more.");
        let first = way.part("the place of a leaf's first box", tree.order.len() as f64);
        let count = way.part("the number of a leaf's boxes", n as f64);
        tree.nodes[node] = NodeRow {
            min,
            max,
            first: first as u32,
            count: count as u32,
        };
        let begin = tree.order.len() as u32;
        let places = (begin..begin + n as u32).collect();
        let numbers = "to write the boxes' own numbers into the order, not places in it";
        tree.order.extend(way.made(numbers, places, some.to_vec()));
        return None;
    };
    let first = tree.nodes.len();
    way.remark(format!(
        "Cut along {} into node {first}, with {}, and node {}, with {}.",
        AXES[cut.axis],
        cut.left.len(),
        first + 1,
        cut.right.len()
    ));
    tree.nodes[node] = NodeRow {
        min,
        max,
        first: first as u32,
        count: 0,
    };
    let [min, max] = own;
    let child = NodeRow {
        min,
        max,
        first: 0,
        count: 0,
    };
    tree.nodes.extend([child.clone(), child]);
    Some([(first, cut.left), (first + 1, cut.right)])
}

impl Explained for BvhBuild {
    const WAYS: &'static [fn(&Self, &mut Way) -> BvhBuildAnswer] =
        &[Self::work, |asked, way| grown(asked, way, true)];

    fn work(&self, way: &mut Way) -> BvhBuildAnswer {
        grown(self, way, false)
    }

    fn draw(&self, right: &BvhBuildAnswer, yours: Option<&BvhBuildAnswer>) -> Option<Diagram> {
        let all: Vec<_> = (0..self.boxes.len() as u32).collect();
        let [min, max] = around(&self.boxes, &all).map(Vec3::as_dvec3);
        let view = View::least(max - min);
        let mut drawing = Diagram::new(format!("The leaves' boxes, {}", view.words()));
        for (tree, share, ink) in [(Some(right), 1.0, Ink::Right), (yours, 0.9, Ink::Yours)] {
            let leaves = tree.into_iter().flat_map(|tree| &tree.nodes);
            let leaves = leaves.filter(|row| row.count > 0);
            for row in leaves.take(self.boxes.len()) {
                let seen = view.rectangle(row.min.as_dvec3(), row.max.as_dvec3());
                drawing.area(&shrunk(seen, share), ink);
            }
        }
        for (i, row) in self.boxes.iter().enumerate() {
            let seen = view.rectangle(row.min.as_dvec3(), row.max.as_dvec3());
            let mut outline = seen.to_vec();
            outline.push(seen[0]);
            drawing.line(&outline, Ink::Guide);
            if self.boxes.len() <= 24 {
                drawing.label(middle(&seen), DVec2::ZERO, format!("{i}"), Ink::Guide);
            }
        }
        Some(drawing)
    }
}

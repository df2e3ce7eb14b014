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

/// Puts a node's subtree over some boxes into the tree.
fn grow(q: &BvhBuild, way: &mut Way, tree: &mut BvhBuildAnswer, node: usize, some: &[u32]) {
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
    let Some(cut) = cut.filter(|_| saves || is_full) else {
        way.remark("A leaf: a cut would cost the branch, and save no more.");
        tree.nodes[node] = NodeRow {
            min,
            max,
            first: tree.order.len() as u32,
            count: n as u32,
        };
        let begin = tree.order.len() as u32;
        let places = (begin..begin + n as u32).collect();
        let numbers = "to write the boxes' own numbers into the order, not places in it";
        tree.order.extend(way.made(numbers, places, some.to_vec()));
        return;
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
    grow(q, way, tree, first, &cut.left);
    grow(q, way, tree, first + 1, &cut.right);
}

impl Explained for BvhBuild {
    fn work(&self, way: &mut Way) -> BvhBuildAnswer {
        let mut tree = BvhBuildAnswer {
            nodes: Vec::new(),
            order: Vec::new(),
        };
        if self.boxes.is_empty() {
            way.remark("There are no boxes: the tree has no nodes.");
            return tree;
        }
        tree.nodes.push(NodeRow {
            min: Vec3::ZERO,
            max: Vec3::ZERO,
            first: 0,
            count: 0,
        });
        let all: Vec<_> = (0..self.boxes.len() as u32).collect();
        grow(self, way, &mut tree, 0, &all);
        tree
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

//! What a search in a tree costs: each node by the share of rays that meet its box.

use super::drawn;
use crate::explain::Explained;
use crate::explain::diagram::Diagram;
use crate::explain::tree::{self, area};
use crate::explain::way::Way;
use raybook_workbook::exercises::ch11_bvh::SahCost;
use raybook_workbook::tree_rows::NodeRow;

/// The area of a node's box, its steps written down.
pub fn area_by_steps(way: &mut Way, row: &NodeRow) -> f64 {
    let max = way.part("max of a node", row.max.as_dvec3());
    let min = way.part("min of a node", row.min.as_dvec3());
    let size = way.part("a node's extents", max - min);
    let x = way.part("the extent along x", size.x);
    let y = way.part("the extent along y", size.y);
    let z = way.part("the extent along z", size.z);
    let xy = way.part("x · y", x * y);
    let yz = way.part("y · z", y * z);
    let zx = way.part("z · x", z * x);
    way.part("x · y · z, the volume", xy * z);
    let half = way.part("x · y + y · z + z · x", xy + yz + zx);
    way.part("a node's area", 2.0 * half)
}

/// The same from the leaves up: what a search below a node costs a ray that meets the node's box.
fn from_below(q: &SahCost, way: &mut Way) -> f32 {
    let branch = way.part("branch", f64::from(q.branch));
    let shape = way.part("shape", f64::from(q.shape));
    let areas = q.nodes.iter().map(|row| area([row.min, row.max]));
    let areas: Vec<_> = areas.collect();
    let mut costs = vec![0.0; q.nodes.len()];
    for (i, row) in q.nodes.iter().enumerate().rev() {
        let first = row.first as usize;
        costs[i] = if row.count > 0 {
            shape * f64::from(row.count)
        } else if first > i {
            let second = way.part("the number of a branch's second child", first as f64 + 1.0);
            let right = (second as usize).min(costs.len() - 1);
            let left = first.min(right);
            let of = way.part("the area of a branch", areas[i]);
            let [of_left, of_right] = [left, right].map(|child| areas[child] / of);
            let of_left = way.part("the share of a branch's left child", of_left);
            let of_right = way.part("the share of a branch's right child", of_right);
            let left = way.part("the cost of a branch's left child", costs[left]);
            let right = way.part("the cost of a branch's right child", costs[right]);
            branch + of_left * left + of_right * right
        } else {
            branch
        };
    }
    costs.first().map_or(0.0, |cost| *cost as f32)
}

impl Explained for SahCost {
    const WAYS: &'static [fn(&Self, &mut Way) -> f32] = &[Self::work, from_below];

    fn work(&self, way: &mut Way) -> f32 {
        let branch = way.part("branch", f64::from(self.branch));
        let shape = way.part("shape", f64::from(self.shape));
        let of_root = self
            .nodes
            .first()
            .map_or(0.0, |root| area_by_steps(way, root));
        let of_root = way.number("the area of the root's box", "m²", of_root);
        if way.is_zero("the root's box has no area", of_root) {
            way.remark("There is nothing to be searched.");
            return 0.0;
        }
        let mut cost = way.part("what the sum begins with", 0.0);
        for i in way.rounds("the nodes", self.nodes.len()) {
            let row = &self.nodes[i];
            let of_node = area_by_steps(way, row);
            let of_node = way.part("the area of a node in the sum", of_node);
            let is_branch = way.is_zero("a node is a branch", row.count.into());
            let of_node = if is_branch {
                way.part("a branch's area", of_node)
            } else {
                way.part("a leaf's area", of_node)
            };
            let share = way.part("a node's area over the root's", of_node / of_root);
            let count = way.part("a leaf's number of shapes", f64::from(row.count));
            let what = if row.count == 0 {
                format!("node {i}, a branch: its area/the root's · branch")
            } else {
                format!(
                    "node {i}, a leaf of {}: its area/the root's · {} · shape",
                    row.count, row.count
                )
            };
            let price = if is_branch { branch } else { count * shape };
            cost += way.number(what, "", share * price);
        }
        way.number("the sum: the cost of a search", "", cost) as f32
    }

    fn draw(&self, _: &f32, _: Option<&f32>) -> Option<Diagram> {
        let of_root = self
            .nodes
            .first()
            .map_or(1.0, |root| area([root.min, root.max]));
        let mut drawing = Diagram::new(
            "The tree from its root down: each node with its number, and the share of the rays through the root that meet its box",
        );
        drawing.keyed = false;
        let share = |i: usize| {
            let row = &self.nodes[i];
            format!(": {:.0} %", 100.0 * area([row.min, row.max]) / of_root)
        };
        tree::draw(&mut drawing, &drawn(&self.nodes, |_| true, share));
        Some(drawing)
    }
}

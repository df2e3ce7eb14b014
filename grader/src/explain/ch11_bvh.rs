//! Chapter 11: the price of a tree of boxes, its best cut, the tree that the cuts make, and the search in it.

use super::Explained;
use super::ch06_triangle;
use super::diagram::{Diagram, Ink};
use super::tree::{self, Node, area, enters};
use super::view::{AXES, View, middle, shrunk};
use super::way::Way;
use glam::{DVec2, Vec3, dvec2};
use raybook_workbook::exercises::ch07_mesh::MeshHitAnswer;
use raybook_workbook::exercises::ch11_bvh::{
    BvhBuild, BvhBuildAnswer, BvhClosest, BvhClosestAnswer, SahCost, SahSplit,
};
use raybook_workbook::tree_rows::{BoxRow, NodeRow};

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

impl Explained for SahCost {
    fn work(&self, way: &mut Way) -> f32 {
        let [branch, shape] = [self.branch, self.shape].map(f64::from);
        let of_root = self
            .nodes
            .first()
            .map_or(0.0, |root| area([root.min, root.max]));
        let of_root = way.number("the area of the root's box", "m²", of_root);
        if of_root == 0.0 {
            way.remark("There is nothing to be searched.");
            return 0.0;
        }
        let mut cost = 0.0;
        for (i, row) in self.nodes.iter().enumerate() {
            let share = area([row.min, row.max]) / of_root;
            let what = if row.count == 0 {
                format!("node {i}, a branch: its area/the root's · branch")
            } else {
                format!(
                    "node {i}, a leaf of {}: its area/the root's · {} · shape",
                    row.count, row.count
                )
            };
            let price = if row.count == 0 {
                branch
            } else {
                f64::from(row.count) * shape
            };
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

/// A cut of boxes in two, and what it costs: the sum of area times number over both sides.
struct Cut {
    axis: usize,
    left: Vec<u32>,
    right: Vec<u32>,
    cost: f64,
}

/// The box around some boxes.
fn around(boxes: &[BoxRow], some: &[u32]) -> [Vec3; 2] {
    let some = some.iter().map(|&i| &boxes[i as usize]);
    some.fold([Vec3::INFINITY, Vec3::NEG_INFINITY], |[min, max], b| {
        [min.min(b.min), max.max(b.max)]
    })
}

/// The cheapest cut of some boxes along an axis.
fn cut_along(boxes: &[BoxRow], some: &[u32], axis: usize) -> Option<Cut> {
    let mut sorted = some.to_vec();
    let middle = |i: &u32| {
        let BoxRow { min, max } = &boxes[*i as usize];
        f64::from(min[axis]) + f64::from(max[axis])
    };
    sorted.sort_by(|a, b| middle(a).total_cmp(&middle(b)));
    let cost = |side: &[u32]| area(around(boxes, side)) * side.len() as f64;
    let cuts = (1..sorted.len()).map(|i| {
        let (left, right) = sorted.split_at(i);
        (i, cost(left) + cost(right))
    });
    let (i, cost) = cuts.min_by(|a, b| a.1.total_cmp(&b.1))?;
    let right = sorted.split_off(i);
    Some(Cut {
        axis,
        left: sorted,
        right,
        cost,
    })
}

/// The cheapest cut of some boxes along any axis, the steps to it written down.
fn best_cut(way: &mut Way, boxes: &[BoxRow], some: &[u32]) -> Option<Cut> {
    let cuts = [0, 1, 2].map(|axis| cut_along(boxes, some, axis));
    for cut in cuts.iter().flatten() {
        let (name, left, right) = (AXES[cut.axis], cut.left.len(), cut.right.len());
        let words = format!(
            "the best along {name}, {left} on the left and {right} on the right: areas times numbers"
        );
        way.number(words, "m²", cut.cost);
    }
    let best = cuts.into_iter().flatten();
    best.min_by(|a, b| a.cost.total_cmp(&b.cost))
}

impl Explained for SahSplit {
    fn work(&self, way: &mut Way) -> Vec<u32> {
        let all: Vec<_> = (0..self.boxes.len() as u32).collect();
        let Some(cut) = best_cut(way, &self.boxes, &all) else {
            way.remark("Fewer than two boxes cannot be cut.");
            return all;
        };
        way.remark(format!("The cheapest of them is along {}.", AXES[cut.axis]));
        cut.left
    }

    fn draw(&self, right: &Vec<u32>, yours: Option<&Vec<u32>>) -> Option<Diagram> {
        let all: Vec<_> = (0..self.boxes.len() as u32).collect();
        let [min, max] = around(&self.boxes, &all);
        let mut size = max.as_dvec3() - min.as_dvec3();
        // The axis of the cut is to be seen.
        if let Some(cut) = best_cut(&mut Way::default(), &self.boxes, &all) {
            size[cut.axis] = f64::INFINITY;
        }
        let view = View::least(size);
        let mut drawing = Diagram::new(format!(
            "The boxes by their numbers and the boxes around both sides, {}; marked are those on the left",
            view.words()
        ));
        for side in [true, false] {
            let some: Vec<_> = all
                .iter()
                .copied()
                .filter(|i| right.contains(i) == side)
                .collect();
            if !some.is_empty() {
                let corners = around(&self.boxes, &some).map(Vec3::as_dvec3);
                let ink = if side { Ink::Right } else { Ink::Shape };
                drawing.area(&view.rectangle(corners[0], corners[1]), ink);
            }
        }
        for (i, row) in (0..).zip(&self.boxes) {
            let seen = view.rectangle(row.min.as_dvec3(), row.max.as_dvec3());
            let mut outline = seen.to_vec();
            outline.push(seen[0]);
            drawing.line(&outline, Ink::Guide);
            let middle = middle(&seen);
            let ink = if right.contains(&i) {
                Ink::Right
            } else {
                Ink::Guide
            };
            drawing.point(middle, ink);
            if yours.is_some_and(|yours| yours.contains(&i)) {
                drawing.point(middle, Ink::Yours);
            }
            if self.boxes.len() <= 24 {
                drawing.label(middle, dvec2(0.9, 0.5), format!("{i}"), ink);
            }
        }
        Some(drawing)
    }
}

/// Puts a node's subtree over some boxes into the tree.
fn grow(q: &BvhBuild, way: &mut Way, tree: &mut BvhBuildAnswer, node: usize, some: &[u32]) {
    let n = some.len();
    let [min, max] = around(&q.boxes, some);
    way.number(format!("node {node}: its number of boxes"), "", n as f64);
    // The steps of the first cut are told; the others go the same way.
    let cut = if node == 0 {
        best_cut(way, &q.boxes, some)
    } else {
        way.silently(|way| best_cut(way, &q.boxes, some))
    };
    let whole = area([min, max]);
    // Both sides are reckoned as leaves here: as a rule it is right, and cheap.
    let is_worth = |cut: &Cut| whole + cut.cost < n as f64 * whole || n > q.most as usize;
    let Some(cut) = cut.filter(is_worth) else {
        way.remark("A leaf: a cut would cost the branch, and save no more.");
        tree.nodes[node] = NodeRow {
            min,
            max,
            first: tree.order.len() as u32,
            count: n as u32,
        };
        tree.order.extend(some);
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
    tree.nodes
        .extend([tree.nodes[node].clone(), tree.nodes[node].clone()]);
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

/// A search in a tree, while it runs.
struct Search<'a> {
    q: &'a BvhClosest,
    /// The nearest hit among the triangles that were tested.
    nearest: Option<(f64, u32)>,
    boxes: u32,
    tests: u32,
    /// The nodes that are opened or whose shapes are tested.
    met: Vec<usize>,
}

impl Search<'_> {
    fn visit(&mut self, way: &mut Way, node: usize) {
        let Some(row) = self.q.nodes.get(node) else {
            return;
        };
        self.met.push(node);
        if row.count > 0 {
            let last = row.first.saturating_add(row.count);
            way.remark(format!(
                "Node {node} is a leaf with {} of the triangles.",
                row.count
            ));
            for id in row.first..last.min(self.q.triangles.len() as u32) {
                self.test(way, id);
            }
            return;
        }
        let mut below = Vec::new();
        for child in children(row) {
            let Some(row) = self.q.nodes.get(child).filter(|_| child > node) else {
                continue;
            };
            self.boxes += 1;
            match enters(&self.q.ray, self.q.within, self.limit(), [row.min, row.max]) {
                Some(enter) => {
                    let name = format!("node {node} is opened: the ray enters node {child} at t =");
                    below.push((way.number(name, "m", enter), child));
                }
                None => way.remark(format!(
                    "Node {node} is opened: the ray does not enter node {child} where it could count."
                )),
            }
        }
        below.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (enter, child) in below {
            if enter <= self.limit() {
                self.visit(way, child);
            } else {
                way.remark(format!(
                    "Node {child} begins behind the nearest hit: it is left out."
                ));
            }
        }
    }

    fn test(&mut self, way: &mut Way, id: u32) {
        let q = self.q;
        let triangle = &q.triangles[id as usize];
        let corners = [triangle.p0, triangle.p1, triangle.p2];
        self.tests += 1;
        // Its own steps are those of `triangle_hit`.
        match way.silently(|way| ch06_triangle::meets(way, &q.ray, q.within, corners)) {
            Some([t, ..]) => {
                way.number(format!("triangle {id} is hit at t ="), "m", t);
                if t < self.limit() {
                    self.nearest = Some((t, id));
                }
            }
            None => way.remark(format!("Triangle {id} is not hit.")),
        }
    }

    /// What lies behind it does not count.
    fn limit(&self) -> f64 {
        self.nearest.map_or(f64::INFINITY, |(t, _)| t)
    }
}

fn search<'a>(q: &'a BvhClosest, way: &mut Way) -> Search<'a> {
    let mut search = Search {
        q,
        nearest: None,
        boxes: 0,
        tests: 0,
        met: Vec::new(),
    };
    search.visit(way, 0);
    search
}

impl Explained for BvhClosest {
    fn work(&self, way: &mut Way) -> BvhClosestAnswer {
        let search = search(self, way);
        let (boxes, tests) = (search.boxes, search.tests);
        way.number("boxes tested", "", boxes.into());
        way.number("triangles tested", "", tests.into());
        let hit = search
            .nearest
            .map(|(t, id)| MeshHitAnswer { t: t as f32, id });
        BvhClosestAnswer { boxes, tests, hit }
    }

    fn draw(&self, right: &BvhClosestAnswer, yours: Option<&BvhClosestAnswer>) -> Option<Diagram> {
        let search = search(self, &mut Way::default());
        let words = |answer: &BvhClosestAnswer| {
            format!(
                "{} boxes and {} triangles tested",
                answer.boxes, answer.tests
            )
        };
        let yours = yours.map_or(String::new(), |yours| format!("; yours: {}", words(yours)));
        let mut drawing = Diagram::new(format!(
            "The tree from its root down: what the search opens is green, the rest it need not look into. The reference: {}{yours}",
            words(right)
        ));
        drawing.keyed = false;
        let met = |i| search.met.contains(&i);
        tree::draw(&mut drawing, &drawn(&self.nodes, met, |_| String::new()));
        Some(drawing)
    }
}

//! The search for the nearest hit in a tree.

use super::{children, drawn};
use crate::explain::Explained;
use crate::explain::diagram::Diagram;
use crate::explain::nearest::Nearest;
use crate::explain::rays;
use crate::explain::tree::{self, enters};
use crate::explain::way::Way;
use raybook::math::interval::Interval;
use raybook_workbook::exercises::ch11_bvh::{BvhClosest, BvhClosestAnswer};

/// A search in a tree, while it runs.
struct Search<'a> {
    q: &'a BvhClosest,
    within: Interval,
    nearest: Nearest,
    boxes: u32,
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
            let end = last.min(self.q.triangles.len() as u32).max(row.first);
            for place in way.rounds("a leaf's triangles", (end - row.first) as usize) {
                let id = row.first + place as u32;
                let triangle = &self.q.triangles[id as usize];
                let corners = [triangle.p0, triangle.p1, triangle.p2];
                let (name, asked) = (format!("triangle {id}"), (&self.q.ray, self.within));
                self.nearest.test(way, asked, (&name, id), corners);
            }
            return;
        }
        let mut below = Vec::new();
        let children = children(row);
        for place in way.rounds("a branch's children", children.len()) {
            let child = children[place];
            let Some(row) = self.q.nodes.get(child).filter(|_| child > node) else {
                continue;
            };
            self.boxes += 1;
            let limit = self.nearest.limit();
            match enters(&self.q.ray, self.within, limit, [row.min, row.max]) {
                Some(enter) => {
                    let name = format!("node {node} is opened: the ray enters node {child} at t =");
                    below.push((way.number(name, "m", enter), child));
                }
                None => way.remark(format!(
                    "Node {node} is opened: the ray does not enter node {child} where it could count."
                )),
            }
        }
        let is_sorted = below.is_sorted_by(|a, b| a.0 <= b.0);
        if way.decides("the second child is nearer than the first", !is_sorted) {
            below.reverse();
        }
        for (enter, child) in below {
            let is_behind = enter > self.nearest.limit();
            if way.decides("a child begins behind the nearest hit", is_behind) {
                way.remark(format!(
                    "Node {child} begins behind the nearest hit: it is left out."
                ));
            } else {
                self.visit(way, child);
            }
        }
    }
}

fn search<'a>(q: &'a BvhClosest, way: &mut Way) -> Search<'a> {
    let mut search = Search {
        q,
        within: rays::interval(way, q.within),
        nearest: Nearest::default(),
        boxes: 0,
        met: Vec::new(),
    };
    search.visit(way, 0);
    search
}

impl Explained for BvhClosest {
    fn work(&self, way: &mut Way) -> BvhClosestAnswer {
        let search = search(self, way);
        let (boxes, tests) = (search.boxes, search.nearest.tests);
        let boxes = way.number("boxes tested", "", boxes.into()) as u32;
        let tests = way.number("triangles tested", "", tests.into()) as u32;
        let hit = search.nearest.answer(way);
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

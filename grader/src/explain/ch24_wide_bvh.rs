//! Chapter 24: a binary tree made wide, and the search in a wide tree.

use super::Explained;
use super::ch11_bvh::{area_by_steps, children, drawn};
use super::diagram::{Diagram, Ink};
use super::nearest::Nearest;
use super::rays;
use super::tree::{self, Node, enters};
use super::way::Way;
use raybook::inside::wide_bvh::CHILDREN;
use raybook::math::interval::Interval;
use raybook_workbook::exercises::ch24_wide_bvh::{
    Collapse, FamilyRow, WideClosest, WideClosestAnswer,
};

fn is_branch(q: &Collapse, node: u32) -> bool {
    q.nodes.get(node as usize).is_some_and(|row| row.count == 0)
}

fn area_of(q: &Collapse, way: &mut Way, node: u32) -> f64 {
    area_by_steps(way, &q.nodes[node as usize])
}

/// The children of a branch that exist.
fn below(q: &Collapse, branch: u32) -> impl Iterator<Item = u32> {
    let count = q.nodes.len();
    let children = children(&q.nodes[branch as usize]).into_iter();
    let exist = children.filter(move |&child| child > branch as usize && child < count);
    exist.map(|child| child as u32)
}

impl Explained for Collapse {
    fn work(&self, way: &mut Way) -> Vec<FamilyRow> {
        let mut families = Vec::new();
        let mut to_do: Vec<u32> = (0..1).filter(|&root| is_branch(self, root)).collect();
        if to_do.is_empty() {
            way.remark("The root is no branch: there are no families.");
        }
        while let Some(branch) = to_do.pop() {
            let mut family: Vec<u32> = below(self, branch).collect();
            way.remark(format!(
                "Branch {branch} stays. Its two children are its first members."
            ));
            let most = way.limit("the most children of a branch", CHILDREN);
            while family.len() < most {
                let branches = (0..family.len()).filter(|&i| is_branch(self, family[i]));
                let of = |way: &mut Way, i: usize| {
                    let area = area_of(self, way, family[i]);
                    (i, way.part("a branch's area", area))
                };
                let areas: Vec<_> = way.silently(|way| branches.map(|i| of(way, i)).collect());
                if areas.is_empty() {
                    way.remark("No branch is left among them.");
                    break;
                }
                let smallness: Vec<_> = areas.iter().map(|(_, area)| -area).collect();
                let largest = way.least("the branch with the largest area", &smallness);
                let (largest, area) = areas[largest];
                let gives_way = family.remove(largest);
                way.number(
                    format!("node {gives_way} is its largest branch, and gives way to its children: its area"),
                    "m²",
                    area,
                );
                family.extend(below(self, gives_way));
            }
            way.number("its children", "", family.len() as f64);
            to_do.extend(family.iter().copied().filter(|&node| is_branch(self, node)));
            families.push(FamilyRow {
                branch,
                children: family,
            });
        }
        families
    }

    fn draw(&self, right: &Vec<FamilyRow>, yours: Option<&Vec<FamilyRow>>) -> Option<Diagram> {
        let mut drawing = Diagram::new(
            "The binary tree from its root down: the branches that stay are green, and marked those that stay in your tree",
        );
        let stays = |families: &[FamilyRow], node: usize| {
            families.iter().any(|family| family.branch as usize == node)
        };
        let nodes = drawn(&self.nodes, |i| stays(right, i), |_| String::new());
        let places = tree::draw(&mut drawing, &nodes);
        for (i, place) in places.into_iter().enumerate() {
            let is_yours = yours.is_some_and(|yours| stays(yours, i));
            if let Some(place) = place.filter(|_| is_yours) {
                drawing.point(place, Ink::Yours);
            }
        }
        Some(drawing)
    }
}

/// A search in a wide tree, while it runs.
struct Search<'a> {
    q: &'a WideClosest,
    within: Interval,
    nearest: Nearest,
    opened: Vec<u32>,
    leaves: Vec<u32>,
}

impl Search<'_> {
    fn open(&mut self, way: &mut Way, node: u32) {
        let q = self.q;
        let Some(row) = q.nodes.get(node as usize) else {
            return;
        };
        self.opened.push(node);
        way.remark(format!(
            "Node {node} is opened: the boxes of its {} children are tested at once.",
            row.children.len()
        ));
        let mut met = Vec::new();
        for child in &row.children[way.rounds("a node's children", row.children.len())] {
            let enter = enters(
                &q.ray,
                self.within,
                self.nearest.limit(),
                [child.min, child.max],
            );
            let what = if child.leaf == 0 { "node" } else { "leaf" };
            if let Some(enter) = enter {
                let name = format!("the ray enters {what} {} at t =", child.index);
                met.push((way.number(name, "m", enter), child));
            }
        }
        met.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (enter, child) in met {
            let is_behind = enter > self.nearest.limit();
            if way.decides("a child begins behind the nearest hit", is_behind) {
                let what = if child.leaf == 0 { "Node" } else { "Leaf" };
                way.remark(format!(
                    "{what} {} begins behind the nearest hit: it is left out.",
                    child.index
                ));
            } else if child.leaf != 0 {
                self.test(way, child.index);
            } else if child.index > node {
                self.open(way, child.index);
            }
        }
    }

    fn test(&mut self, way: &mut Way, leaf: u32) {
        let q = self.q;
        let Some(row) = q.leaves.get(leaf as usize) else {
            return;
        };
        self.leaves.push(leaf);
        for &id in &row.triangles[way.rounds("a leaf's triangles", row.triangles.len())] {
            let Some(triangle) = q.triangles.get(id as usize) else {
                continue;
            };
            let corners = [triangle.p0, triangle.p1, triangle.p2];
            let name = format!("leaf {leaf}: triangle {id}");
            self.nearest
                .test(way, (&q.ray, self.within), (&name, id), corners);
        }
    }
}

fn search<'a>(q: &'a WideClosest, way: &mut Way) -> Search<'a> {
    let mut search = Search {
        q,
        within: rays::interval(way, q.within),
        nearest: Nearest::default(),
        opened: Vec::new(),
        leaves: Vec::new(),
    };
    search.open(way, 0);
    search
}

impl Explained for WideClosest {
    fn work(&self, way: &mut Way) -> WideClosestAnswer {
        let search = search(self, way);
        let (nodes, tests) = (search.opened.len() as u32, search.nearest.tests);
        let nodes = way.number("nodes opened", "", nodes.into()) as u32;
        let tests = way.number("triangles tested", "", tests.into()) as u32;
        let hit = search.nearest.answer(way);
        WideClosestAnswer { nodes, tests, hit }
    }

    fn draw(
        &self,
        right: &WideClosestAnswer,
        yours: Option<&WideClosestAnswer>,
    ) -> Option<Diagram> {
        let search = search(self, &mut Way::default());
        let words = |answer: &WideClosestAnswer| {
            format!(
                "{} nodes opened and {} triangles tested",
                answer.nodes, answer.tests
            )
        };
        let yours = yours.map_or(String::new(), |yours| format!("; yours: {}", words(yours)));
        let mut drawing = Diagram::new(format!(
            "The tree from its root down, leaves with an L: what the search opens is green. The reference: {}{yours}",
            words(right)
        ));
        drawing.keyed = false;
        let count = self.nodes.len();
        let inner = self.nodes.iter().enumerate().map(|(i, node)| Node {
            name: i.to_string(),
            is_met: search.opened.contains(&(i as u32)),
            // Behind all nodes come the leaves.
            children: node
                .children
                .iter()
                .map(|child| child.index as usize + if child.leaf == 0 { 0 } else { count })
                .collect(),
        });
        let leaves = (0..self.leaves.len()).map(|i| Node {
            name: format!("L{i}"),
            is_met: search.leaves.contains(&(i as u32)),
            children: Vec::new(),
        });
        let nodes: Vec<_> = inner.chain(leaves).collect();
        tree::draw(&mut drawing, &nodes);
        Some(drawing)
    }
}

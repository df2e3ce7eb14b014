//! The octree that is worth its price.

use super::{MOST, leaves};
use crate::explain::Explained;
use crate::explain::diagram::{Diagram, Ink};
use crate::explain::view::{View, shrunk};
use crate::explain::way::Way;
use glam::Vec3;
use raybook::inside::octree::child_cell;
use raybook::math::aabb::Aabb;
use raybook_workbook::exercises::ch05_box::Corners;
use raybook_workbook::exercises::ch10_octree::OctreeBuild;
use raybook_workbook::octree_rows::{NodeRow, TreeRow};

/// A leaf that is still to be cut, or not.
struct Growing {
    node: usize,
    cell: Aabb,
    shapes: Vec<u32>,
    depth: u32,
    copies: f64,
}

/// The children in the upper half of their parent along x, y and z, one bit each.
const UPPER: [u8; 3] = [0b1010_1010, 0b1100_1100, 0b1111_0000];

/// Which children of a cell a box reaches or touches, one bit each.
fn reached(way: &mut Way, shape: &Corners, cell: &Aabb) -> u8 {
    let middle = child_cell(cell, 0).max;
    let mut bits = u8::MAX;
    for axis in way.rounds("the axes along which a shape reaches a child", 3) {
        let [begin, end] = [shape.min, shape.max].map(|corner| f64::from(corner[axis]));
        let [low, middle, high] = [cell.min, middle, cell.max].map(|p| f64::from(p[axis]));
        let in_lower = way.is_at_most("a shape begins in the lower half", begin, middle);
        let in_upper = way.is_at_most("a shape ends in the upper half", middle, end);
        if !in_lower || end < low {
            bits &= UPPER[axis];
        }
        if !in_upper || high < begin {
            bits &= !UPPER[axis];
        }
    }
    bits
}

/// The copies that are left to a child of a cell with n shapes, of which a cut makes Σ nᵢ.
fn left_to_a_child(way: &mut Way, copies: f64, [below, n]: [f64; 2]) -> f64 {
    let named = way.part("Σ nᵢ/n, by which the copies are lowered", below / n);
    let fewer = way.made("to divide the copies by 1 at least", named, named.max(1.0));
    way.part("the copies that are left to a child", copies / fewer)
}

/// Why a cell stays a leaf, if it does: a cut is too dear, makes too many copies, or is too deep.
fn stays([is_dear, is_many, is_deep]: [bool; 3]) -> Option<&'static str> {
    if is_dear {
        Some("That is not below n: it stays a leaf.")
    } else if is_many {
        Some("It would be worth its price, but the limit allows no more copies: it stays a leaf.")
    } else {
        is_deep.then_some(
            "It would be worth its price, but the limit allows no more depth: it stays a leaf.",
        )
    }
}

impl Explained for OctreeBuild {
    fn work(&self, way: &mut Way) -> TreeRow {
        let leaf = |first: usize, count: usize| NodeRow {
            inner: 0,
            first: first as u32,
            count: count as u32,
        };
        let mut tree = TreeRow {
            nodes: vec![leaf(0, 0)],
            names: Vec::new(),
        };
        let mut to_do = vec![Growing {
            node: 0,
            cell: Aabb::new(self.min, self.max),
            shapes: (0..self.shapes.len() as u32).collect(),
            depth: 0,
            copies: self.copies.into(),
        }];
        if self.shapes.is_empty() {
            way.remark("There are no shapes: the root is an empty leaf.");
        }
        let opening = way.part("opening", f64::from(self.opening));
        let few = way.limit(
            "the number of shapes up to which a cell stays a leaf, whatever a cut costs",
            0,
        );
        let price = way.part("the price ¼ of a shape in a child", 0.25);
        while let Some(growing) = to_do.pop() {
            let Growing {
                node,
                cell,
                shapes,
                depth,
                copies,
            } = growing;
            let cells: [Aabb; 8] = std::array::from_fn(|child| child_cell(&cell, child));
            let reach = |&shape: &u32| reached(way, &self.shapes[shape as usize], &cell);
            let reach: Vec<_> = shapes.iter().map(reach).collect();
            let n = shapes.len() as f64;
            let copies = way.part("the copies that are allowed in a cell", copies);
            let below: u32 = reach.iter().map(|bits| bits.count_ones()).sum();
            if shapes.is_empty() {
                continue; // It stays an empty leaf.
            }
            let n = way.number(
                format!("node {node}, at depth {depth}: n, its shapes"),
                "",
                n,
            );
            let below = way.number("Σ nᵢ, those of its children", "", below.into());
            let cost = way.number("opening + ¼ Σ nᵢ", "", opening + price * below);
            let named = way.part("Σ nᵢ/n, the copies that a cut makes", below / n);
            let is_dear =
                way.is_at_most("a cut costs no less than the leaf", n, cost) || shapes.len() <= few;
            let is_many = way.is_less("a cut makes too many copies", copies, named);
            let is_deep = way.is_at_most(
                "the tree is as deep as it may be",
                self.depth.into(),
                depth.into(),
            );
            if let Some(why) = stays([is_dear, is_many, is_deep]) {
                way.remark(why);
                let begin = way.part(
                    "the place where a leaf's names begin",
                    tree.names.len() as f64,
                );
                let count = way.part("the number of a leaf's names", shapes.len() as f64);
                tree.nodes[node] = leaf(begin as usize, count as usize);
                tree.names.extend(shapes);
                continue;
            }
            let first = tree.nodes.len();
            way.remark(format!(
                "That is below n: it is cut into the nodes {first} to {}.",
                first + 7
            ));
            let number = way.part("the number of a cell's first child", first as f64);
            tree.nodes[node] = NodeRow {
                inner: 1,
                first: number as u32,
                count: 0,
            };
            tree.nodes.extend((0..8).map(|_| leaf(0, 0)));
            let left = left_to_a_child(way, copies, [below, n]);
            let places = way.in_order("the places of a cell's children", (0..8).collect());
            for child in way.rounds("a cell's children", 8).rev() {
                let inside = shapes.iter().zip(&reach);
                let inside = inside.filter(|(_, bits)| *bits >> child & 1 != 0);
                to_do.push(Growing {
                    node: first + places[child],
                    cell: cells[child],
                    shapes: inside.map(|(shape, _)| *shape).collect(),
                    depth: depth + 1,
                    copies: left,
                });
            }
        }
        tree
    }

    fn draw(&self, right: &TreeRow, yours: Option<&TreeRow>) -> Option<Diagram> {
        let view = View::along(2);
        let mut drawing = Diagram::new(format!(
            "The leaves that have shapes, and the shapes' boxes, {}",
            view.words()
        ));
        let root = Aabb::new(self.min, self.max);
        for (tree, share, ink) in [(Some(right), 0.97, Ink::Right), (yours, 0.85, Ink::Yours)] {
            let Some(tree) = tree else { continue };
            let mut squares: Vec<_> = leaves(root, &tree.nodes)
                .into_iter()
                .filter(|(node, _)| tree.nodes[*node].count > 0)
                .map(|(_, cell)| view.rectangle(cell.min.as_dvec3(), cell.max.as_dvec3()))
                .collect();
            // Of leaves behind each other one is enough.
            squares.dedup();
            for square in squares.into_iter().take(MOST) {
                drawing.area(&shrunk(square, share), ink);
            }
        }
        let [min, max] = [self.min, self.max].map(Vec3::as_dvec3);
        view.lattice(&mut drawing, [min, max], [2; 3]);
        for corners in self.shapes.iter().take(MOST) {
            let [low, high] = [corners.min, corners.max].map(Vec3::as_dvec3);
            drawing.area(&view.rectangle(low, high), Ink::Shape);
        }
        Some(drawing)
    }
}

//! The leaves on a ray's way.

use super::leaves;
use crate::explain::Explained;
use crate::explain::diagram::{Diagram, Ink};
use crate::explain::rays;
use crate::explain::view::{View, middle, shrunk};
use crate::explain::way::Way;
use glam::{Vec3, dvec2};
use raybook::inside::octree::child_cell;
use raybook::math::aabb::Aabb;
use raybook_workbook::exercises::ch10_octree::OctreeWalk;

/// The leaves with shapes below a node that the ray passes through, front to back.
fn visit(q: &OctreeWalk, way: &mut Way, node: usize, cell: Aabb, found: &mut Vec<u32>) {
    let (o, d) = rays::parts(&q.ray);
    let within = [q.within.min, q.within.max].map(f64::from);
    let [min, max] = [cell.min, cell.max].map(Vec3::as_dvec3);
    let Some(row) = q.nodes.get(node) else {
        return;
    };
    let is_empty = row.inner == 0 && row.count == 0;
    if way.decides("a leaf is empty", is_empty) {
        if node == 0 {
            way.remark("The root is an empty leaf: there is nothing to list.");
        }
        return;
    }
    let clipped = rays::clipped((o, d), within, min, max);
    let meets = way.decides("the ray meets a node's cell", clipped.is_some());
    let Some([enter, leave]) = clipped.or(meets.then_some(within)).filter(|_| meets) else {
        if node == 0 {
            way.remark("The ray misses the root's cell.");
        }
        return;
    };
    let kind = if row.inner == 0 { "a leaf" } else { "opened" };
    way.pair(
        format!("node {node}, {kind}: the ray enters and leaves its cell at t ="),
        "m",
        dvec2(enter, leave),
    );
    if row.inner == 0 {
        found.push(node as u32);
        return;
    }
    let first = row.first as usize;
    if first <= node {
        return; // A child comes after its parent.
    }
    // Along an axis on which the ray moves down, the upper half comes first.
    let backward = (0..3).filter(|&axis| d[axis].is_sign_negative());
    let mirror = backward.fold(0, |bits, axis| bits | 1 << axis);
    let mirrored = way.decides("the ray moves down along an axis", mirror != 0);
    let mirror = if mirrored { mirror } else { 0 };
    for i in 0..8 {
        let child = i ^ mirror;
        visit(q, way, first + child, child_cell(&cell, child), found);
    }
}

impl Explained for OctreeWalk {
    fn work(&self, way: &mut Way) -> Vec<u32> {
        let mut found = Vec::new();
        visit(self, way, 0, Aabb::new(self.min, self.max), &mut found);
        found
    }

    fn draw(&self, right: &Vec<u32>, yours: Option<&Vec<u32>>) -> Option<Diagram> {
        let view = View::least(self.ray.direction.as_dvec3());
        let mut drawing = Diagram::new(format!(
            "The leaves on the ray's way, {}; the right ones with their numbers",
            view.words()
        ));
        let all = leaves(Aabb::new(self.min, self.max), &self.nodes);
        let square = |node: &u32, share: f64| {
            let (_, cell) = all.iter().find(|(leaf, _)| *leaf == *node as usize)?;
            let square = view.rectangle(cell.min.as_dvec3(), cell.max.as_dvec3());
            Some(shrunk(square, share))
        };
        for square in right.iter().filter_map(|node| square(node, 0.96)) {
            drawing.area(&square, Ink::Right);
        }
        for square in yours
            .into_iter()
            .flatten()
            .filter_map(|node| square(node, 0.75))
        {
            drawing.area(&square, Ink::Yours);
        }
        // The outlines of what the ray passes through: those behind and before it would only cover them.
        let [min, max] = [self.min, self.max].map(Vec3::as_dvec3);
        view.lattice(&mut drawing, [min, max], [2; 3]);
        for node in right {
            let Some(mut outline) = square(node, 1.0).map(Vec::from) else {
                continue;
            };
            outline.push(outline[0]);
            drawing.line(&outline, Ink::Guide);
        }
        rays::across(&mut drawing, &view, &self.ray, self.within, [min, max]);
        if right.len() < 16 {
            for node in right {
                let Some(square) = square(node, 1.0) else {
                    continue;
                };
                drawing.label(
                    middle(&square),
                    dvec2(0.0, 0.0),
                    format!("{node}"),
                    Ink::Right,
                );
            }
        }
        Some(drawing)
    }
}

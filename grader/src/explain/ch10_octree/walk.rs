//! The leaves on a ray's way.

use super::leaves;
use crate::explain::Explained;
use crate::explain::diagram::{Diagram, Ink};
use crate::explain::rays;
use crate::explain::view::{View, fill_both, middle};
use crate::explain::way::Way;
use glam::{BVec3, DVec3, Vec3, dvec2};
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
    for i in way.rounds("a node's children, in the order of the ray", 8) {
        let child = i ^ mirror;
        visit(q, way, first + child, child_cell(&cell, child), found);
    }
}

/// The same from the children that the ray passes through, sorted by where it enters them.
fn below(q: &OctreeWalk, way: &mut Way, node: usize, cell: Aabb, found: &mut Vec<u32>) {
    let Some(row) = q.nodes.get(node) else {
        return;
    };
    if row.inner == 0 {
        if row.count > 0 {
            found.push(node as u32);
        }
        return;
    }
    let ray = rays::parts(&q.ray);
    let within = [q.within.min, q.within.max].map(f64::from);
    let first = row.first as usize;
    let met = (0..8).filter_map(|child| {
        let cell = child_cell(&cell, child);
        let [min, max] = [cell.min, cell.max].map(Vec3::as_dvec3);
        let [enter, leave] = rays::clipped(ray, within, min, max)?;
        (leave - enter > TOUCH).then_some((enter, first + child, cell))
    });
    let mut met: Vec<_> = met.collect();
    met.sort_by(|a, b| a.0.total_cmp(&b.0));
    let met = way.in_order("a node's children that the ray passes through", met);
    for i in way.rounds("a node's children that the ray passes through", met.len()) {
        let (_, child, cell) = met[i];
        if child > node {
            below(q, way, child, cell, found);
        }
    }
}

/// The same, below the root.
fn by_children(q: &OctreeWalk, way: &mut Way) -> Vec<u32> {
    let mut found = Vec::new();
    let root = Aabb::new(q.min, q.max);
    let (ray, within) = (rays::parts(&q.ray), [q.within.min, q.within.max]);
    let is_leaf = q.nodes.first().is_some_and(|row| row.inner == 0);
    if way.decides("the root is a leaf itself", is_leaf) {
        let inside = rays::clipped(
            ray,
            within.map(f64::from),
            q.min.as_dvec3(),
            q.max.as_dvec3(),
        );
        if is_leaf && inside.is_some() {
            below(q, way, 0, root, &mut found);
        }
    } else if !is_leaf {
        below(q, way, 0, root, &mut found);
    }
    found
}

/// The same in any order: the leaves in which the ray stays for a while, each with the middle of the stay.
fn stays(
    q: &OctreeWalk,
    way: &mut Way,
    node: usize,
    [min, max]: [DVec3; 2],
    found: &mut Vec<(f64, u32)>,
) {
    let Some(row) = q.nodes.get(node) else {
        return;
    };
    let begin = way.part("within.min", f64::from(q.within.min));
    let end = way.part("within.max", f64::from(q.within.max));
    let inside = rays::clipped(rays::parts(&q.ray), [begin, end], min, max);
    let Some([enter, leave]) = inside.filter(|[enter, leave]| leave - enter > TOUCH) else {
        return;
    };
    if row.inner == 0 {
        let empty = way.part("the number of shapes of an empty leaf", 0.0);
        if way.is_less("a leaf has shapes", empty, row.count.into()) {
            let number = way.part("the number of a leaf", node as f64);
            let middle = 0.5 * (enter + leave);
            let middle = way.made(
                "to sort the leaves by where the ray is in them",
                0.0,
                middle,
            );
            found.push((middle, number as u32));
        }
        return;
    }
    let middle = way.part("a cell's middle", 0.5 * (min + max));
    way.part("half of a cell's extents", 0.5 * (max - min));
    for i in way.rounds("a node's children", 8) {
        let halves = DVec3::from([0, 1, 2].map(|axis| (i >> axis & 1) as f64));
        let halves = way.part(
            "a child's halves along (x, y, z): 0, or 1 for the upper one",
            halves,
        );
        let weights = way.part("the weights of x, y and z", DVec3::new(1.0, 2.0, 4.0));
        let first = way.part("the number of the first child", f64::from(row.first));
        let number = way.part("a child's number", first + halves.dot(weights)) as usize;
        let above = BVec3::new(i & 1 != 0, i & 2 != 0, i & 4 != 0);
        let part = [
            DVec3::select(above, middle, min),
            DVec3::select(above, max, middle),
        ];
        if number > node {
            stays(q, way, number, part, found);
        }
    }
}

/// A ray that is no longer than this in a cell, in metres, only touches it.
const TOUCH: f64 = 1e-9;

/// The same, sorted at the end.
fn by_sorting(q: &OctreeWalk, way: &mut Way) -> Vec<u32> {
    let mut found = Vec::new();
    let root = [q.min, q.max].map(Vec3::as_dvec3);
    stays(q, way, 0, root, &mut found);
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found.into_iter().map(|(_, number)| number).collect()
}

impl Explained for OctreeWalk {
    const WAYS: &'static [fn(&Self, &mut Way) -> Vec<u32>] = &[Self::work, by_sorting, by_children];

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
        let cell = |node: u32| {
            let (_, cell) = all.iter().find(|(leaf, _)| *leaf == node as usize)?;
            Some(view.rectangle(cell.min.as_dvec3(), cell.max.as_dvec3()))
        };
        fill_both(&mut drawing, right, yours, [0.96, 0.75], cell);
        // The outlines of what the ray passes through: those behind and before it would only cover them.
        let [min, max] = [self.min, self.max].map(Vec3::as_dvec3);
        view.lattice(&mut drawing, [min, max], [2; 3]);
        for node in right {
            let Some(mut outline) = cell(*node).map(Vec::from) else {
                continue;
            };
            outline.push(outline[0]);
            drawing.line(&outline, Ink::Guide);
        }
        rays::across(&mut drawing, &view, &self.ray, self.within, [min, max]);
        if right.len() < 16 {
            for node in right {
                let Some(square) = cell(*node) else {
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

//! Chapter 10: the child of a point, the octree that is worth its price, and the leaves on a ray's way.

use super::Explained;
use super::diagram::{Diagram, Ink};
use super::rays;
use super::view::{AXES, View, middle, shrunk};
use super::way::Way;
use glam::{DVec2, DVec3, Vec3, dvec2};
use raybook::inside::octree::child_cell;
use raybook::math::aabb::Aabb;
use raybook_workbook::exercises::ch10_octree::{OctreeBuild, OctreeChild, OctreeWalk, reached};
use raybook_workbook::octree_rows::{NodeRow, TreeRow};

/// The same by the share of the cell that lies below the point, in halves.
fn by_halves(asked: &OctreeChild, way: &mut Way) -> u32 {
    let [min, max, p] = [asked.min, asked.max, asked.p].map(Vec3::as_dvec3);
    let low = way.part("min in p − min", min);
    let above = way.part("p − min", p - low);
    let size = way.part("max − min", max - min);
    let halves = way.part("2·(p − min)/(max − min)", 2.0 * above / size);
    let whole = way.part("the same, rounded down", halves.floor());
    let digits = way.part("the same, 1 at most", whole.min(DVec3::ONE));
    let weights = way.part("the weights of x, y and z", DVec3::new(1.0, 2.0, 4.0));
    way.part("4·z + 2·y + x", digits.dot(weights)) as u32
}

impl Explained for OctreeChild {
    const WAYS: &'static [fn(&Self, &mut Way) -> u32] = &[Self::work, by_halves];

    fn work(&self, way: &mut Way) -> u32 {
        let [min, max, p] = [self.min, self.max, self.p].map(Vec3::as_dvec3);
        let min = way.part("min", min);
        let max = way.part("max", max);
        let p = way.part("p", p);
        let sum = way.part("min + max", min + max);
        let center = way.vector("the cell's middle, (min + max)/2", "m", 0.5 * sum);
        let mut digits = DVec3::ZERO;
        for (axis, name) in AXES.iter().enumerate() {
            let is_upper = way.decides("the point is in the upper half", p[axis] >= center[axis]);
            let half = ["lower half: 0", "upper half: 1"][usize::from(is_upper)];
            way.remark(format!("Along {name} the point is in the {half}."));
            digits[axis] = u8::from(is_upper).into();
        }
        let digits = way.part("the halves along (x, y, z), 0 or 1", digits);
        let weights = way.part("the weights of x, y and z", DVec3::new(1.0, 2.0, 4.0));
        way.number("4·z + 2·y + x", "", digits.dot(weights)) as u32
    }

    fn draw(&self, right: &u32, yours: Option<&u32>) -> Option<Diagram> {
        let [min, max, p] = [self.min, self.max, self.p].map(Vec3::as_dvec3);
        let mut drawing = Diagram::new(
            "The two layers of children, seen along z: x to the right, y upwards; each child with its number",
        );
        let size = (max - min).max(DVec3::splat(1e-30));
        // Side by side, in units of the cell's extents.
        let corner = |child: u32| {
            let layer = 1.3 * f64::from(child >> 2);
            dvec2(
                layer + 0.5 * f64::from(child & 1),
                0.5 * f64::from(child >> 1 & 1),
            )
        };
        let square = |child: u32, share: f64| {
            let (low, high) = (corner(child), corner(child) + 0.5);
            shrunk(
                [low, dvec2(high.x, low.y), high, dvec2(low.x, high.y)],
                share,
            )
        };
        drawing.area(&square(*right, 0.94), Ink::Right);
        if let Some(yours) = yours.filter(|child| **child < 8) {
            drawing.area(&square(*yours, 0.8), Ink::Yours);
        }
        for child in 0..8 {
            let mut outline = square(child, 1.0).to_vec();
            outline.push(outline[0]);
            drawing.line(&outline, Ink::Guide);
            drawing.label(
                corner(child) + dvec2(0.06, 0.06),
                DVec2::ZERO,
                format!("{child}"),
                Ink::Guide,
            );
        }
        for (layer, name) in ["the lower half along z", "the upper half along z"]
            .iter()
            .enumerate()
        {
            drawing.label(
                dvec2(1.3 * layer as f64 + 0.5, 1.0),
                dvec2(0.0, 1.0),
                *name,
                Ink::Shape,
            );
        }
        let layer = 1.3 * f64::from(right >> 2);
        let place = ((p - min) / size).clamp(DVec3::ZERO, DVec3::ONE);
        let place = dvec2(layer + place.x, place.y);
        drawing.point(place, Ink::Shape);
        drawing.label(place, dvec2(0.6, 0.8), "p", Ink::Shape);
        Some(drawing)
    }
}

/// A leaf that is still to be cut, or not.
struct Growing {
    node: usize,
    cell: Aabb,
    shapes: Vec<u32>,
    depth: u32,
    copies: f64,
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
            let reach = |&shape: &u32| reached(&self.shapes[shape as usize], &cells);
            let reach: Vec<_> = shapes.iter().map(reach).collect();
            let n = shapes.len() as f64;
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
            let is_dear = way.decides("a cut costs no less than the leaf", cost >= n);
            let is_many = way.decides("a cut makes too many copies", named > copies);
            let is_deep = way.decides("the tree is as deep as it may be", depth >= self.depth);
            let stop = if is_dear {
                Some("That is not below n: it stays a leaf.")
            } else if is_many {
                Some(
                    "It would be worth its price, but the limit allows no more copies: it stays a leaf.",
                )
            } else if is_deep {
                Some(
                    "It would be worth its price, but the limit allows no more depth: it stays a leaf.",
                )
            } else {
                None
            };
            if let Some(why) = stop {
                way.remark(why);
                tree.nodes[node] = leaf(tree.names.len(), shapes.len());
                tree.names.extend(shapes);
                continue;
            }
            let first = tree.nodes.len();
            way.remark(format!(
                "That is below n: it is cut into the nodes {first} to {}.",
                first + 7
            ));
            tree.nodes[node] = NodeRow {
                inner: 1,
                first: first as u32,
                count: 0,
            };
            tree.nodes.extend((0..8).map(|_| leaf(0, 0)));
            let left = way.part(
                "the copies that are left to a child",
                copies / named.max(1.0),
            );
            for child in (0..8).rev() {
                let inside = shapes.iter().zip(&reach);
                let inside = inside.filter(|(_, bits)| *bits >> child & 1 != 0);
                to_do.push(Growing {
                    node: first + child,
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

/// More rectangles than these nobody can tell apart.
const MOST: usize = 400;

/// The leaves of a list of nodes with their cells. A list of a student's may hold anything: a child that does not come after its
/// parent is left out.
fn leaves(root: Aabb, nodes: &[NodeRow]) -> Vec<(usize, Aabb)> {
    let (mut found, mut to_do) = (Vec::new(), vec![(0, root)]);
    // Each node has one parent, so there are not more visits than nodes.
    for _ in 0..nodes.len() {
        let Some((node, cell)) = to_do.pop() else {
            break;
        };
        let Some(row) = nodes.get(node) else { continue };
        let first = row.first as usize;
        if row.inner == 0 {
            found.push((node, cell));
        } else if first > node {
            to_do.extend(
                (0..8)
                    .rev()
                    .map(|child| (first + child, child_cell(&cell, child))),
            );
        }
    }
    found
}

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

//! A tree of boxes: how far its nodes are along a ray, and its drawing from the root down.

use super::diagram::{Diagram, Ink};
use super::rays;
use glam::{DVec2, DVec3, Vec3, dvec2};
use raybook::math::{interval::Interval, ray::Ray};

/// The distance at which a ray enters a box, before a limit.
pub fn enters(ray: &Ray, within: Interval, limit: f64, [min, max]: [Vec3; 2]) -> Option<f64> {
    let interval = [f64::from(within.min), limit.min(within.max.into())];
    let [min, max] = [min, max].map(Vec3::as_dvec3);
    rays::clipped(rays::parts(ray), interval, min, max).map(|[enter, _]| enter)
}

/// The surface area of a box.
pub fn area([min, max]: [Vec3; 2]) -> f64 {
    let size: DVec3 = max.as_dvec3() - min.as_dvec3();
    2.0 * (size.x * size.y + size.y * size.z + size.z * size.x)
}

/// A node of a drawn tree.
#[derive(Clone, Debug)]
pub struct Node {
    /// What it is called.
    pub name: String,
    /// Whether it is opened or tested.
    pub is_met: bool,
    /// The places of its children in the list.
    pub children: Vec<usize>,
}

/// More nodes than these have no room for their names.
const NAMED: usize = 48;

/// Draws a tree, its root at the top: in green what is met, in grey what is not. The first node is the root, and a child comes
/// after its parent; what does not is left out. Gives each node's place, if it is drawn.
pub fn draw(drawing: &mut Diagram, nodes: &[Node]) -> Vec<Option<DVec2>> {
    let mut places = vec![None; nodes.len()];
    if !nodes.is_empty() {
        place(nodes, 0, 0, &mut 0.0, &mut places);
    }
    drawing.stretched = true;
    for (i, node) in nodes.iter().enumerate() {
        for &child in &node.children {
            let is_met = node.is_met && nodes.get(child).is_some_and(|child| child.is_met);
            let ink = if is_met { Ink::Right } else { Ink::Guide };
            let ends = (places[i], places.get(child).copied().flatten());
            if let (Some(from), Some(to)) = ends {
                drawing.line(&[from, to], ink);
            }
        }
    }
    for (node, at) in nodes.iter().zip(&places) {
        let Some(at) = *at else { continue };
        let ink = if node.is_met { Ink::Right } else { Ink::Guide };
        drawing.point(at, ink);
        if nodes.len() <= NAMED {
            let beside = if node.children.is_empty() { -0.9 } else { 0.9 };
            drawing.label(at, dvec2(0.0, beside), node.name.clone(), ink);
        }
    }
    places
}

/// Gives the leaves below a node the next places from the left, and each branch the middle of its children.
fn place(
    nodes: &[Node],
    i: usize,
    depth: u32,
    next: &mut f64,
    places: &mut [Option<DVec2>],
) -> f64 {
    let children = nodes[i].children.iter();
    let below = children.filter(|&&child| child > i && child < nodes.len());
    let below: Vec<f64> = below
        .map(|&child| place(nodes, child, depth + 1, next, places))
        .collect();
    let x = if let (Some(first), Some(last)) = (below.first(), below.last()) {
        0.5 * (first + last)
    } else {
        *next += 1.0;
        *next
    };
    places[i] = Some(dvec2(x, -f64::from(depth)));
    x
}

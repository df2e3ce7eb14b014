//! The judge of `bvh_build`: by what a hierarchy must keep to and by its cost, not by its shape.

use super::sah_cost::node_area;
use raybook_workbook::exercises::ch11_bvh::{BvhBuildAnswer, BvhBuild};

/// The cost of a tree, if it is one.
pub(super) fn tree_cost(q: &BvhBuild, tree: &BvhBuildAnswer) -> Result<f32, String> {
    let mut met = vec![false; q.boxes.len()];
    if tree.order.len() != met.len() {
        return Err(format!(
            "the order has {} numbers, but there are {} boxes",
            tree.order.len(),
            met.len()
        ));
    }
    let mut used = vec![false; tree.nodes.len()];
    let mut sum = 0.0;
    let mut open = vec![0];
    while let Some(i) = open.pop() {
        let node = tree
            .nodes
            .get(i)
            .ok_or_else(|| format!("there is no node {i}"))?;
        if std::mem::replace(&mut used[i], true) {
            return Err(format!("node {i} is the child of two branches"));
        }
        let (first, count) = (node.first as usize, node.count as usize);
        let mut below = Vec::new();
        if count == 0 {
            for child in [first, first.saturating_add(1)] {
                let row = tree
                    .nodes
                    .get(child)
                    .ok_or_else(|| format!("node {i} has the child {child}, which is not there"))?;
                below.push((format!("node {child}"), row.min, row.max));
                open.push(child);
            }
        } else if count > q.most as usize {
            return Err(format!(
                "leaf {i} has {count} shapes; {} are allowed",
                q.most
            ));
        }
        for place in first..first.saturating_add(count) {
            let shape = tree.order.get(place).map(|&shape| shape as usize);
            let Some((shape, row)) = shape.and_then(|s| Some((s, q.boxes.get(s)?))) else {
                return Err(format!(
                    "leaf {i} has place {place} of the order, where no box is"
                ));
            };
            if std::mem::replace(&mut met[shape], true) {
                return Err(format!("box {shape} is in the tree twice"));
            }
            below.push((format!("box {shape}"), row.min, row.max));
        }
        let slack = 1e-4 * (node.max - node.min).abs().max_element().max(1e-3);
        for (name, min, max) in below {
            if !((min + slack).cmpge(node.min).all() && (max - slack).cmple(node.max).all()) {
                return Err(format!(
                    "{name} sticks out of node {i}, which should hold it"
                ));
            }
        }
        sum += node_area(node) * if count == 0 { 1.0 } else { count as f32 };
    }
    if let Some(lost) = met.iter().position(|met| !met) {
        return Err(format!("box {lost} is in no leaf"));
    }
    Ok(sum
        / tree
            .nodes
            .first()
            .map_or(1.0, node_area)
            .max(f32::MIN_POSITIVE))
}

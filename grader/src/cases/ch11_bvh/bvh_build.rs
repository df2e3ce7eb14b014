//! `bvh_build`: random questions, judge and mistakes.

use super::sah_cost::node_area;
use super::{around, center, cube, heaps, no_dearer, tree};
use crate::{Graded, Mistake, Verdict, traits};
use raybook::accel::bvh::build::Method;
use raybook::math::{aabb::Aabb, pcg::Pcg};
use raybook_workbook::exercise::Exercise;
use raybook_workbook::exercises::ch11_bvh::{BvhBuild, BvhBuildAnswer};
use raybook_workbook::tree_rows::NodeRow;

/// How much more than the reference's a tree may cost: neither is the best, and which cut is taken first decides more.
const DEARER: f32 = 0.25;

/// A tree that takes the boxes in this order and cuts off one after the other.
pub(super) fn chain(q: &BvhBuild) -> BvhBuildAnswer {
    let n = q.boxes.len() as u32;
    let order: Vec<_> = (0..n).collect();
    let node = |which: &[u32], first, count| {
        let Aabb { min, max } = around(&q.boxes, which);
        NodeRow {
            min,
            max,
            first,
            count,
        }
    };
    let mut nodes = vec![node(&order, u32::from(n > 1), u32::from(n < 2))];
    for i in 1..n {
        let rest = &order[i as usize..];
        let last = rest.len() == 1;
        let first = if last { i } else { 2 * i + 1 };
        nodes.push(node(&order[i as usize - 1..][..1], i - 1, 1));
        nodes.push(node(rest, first, u32::from(last)));
    }
    BvhBuildAnswer { nodes, order }
}

impl Graded for BvhBuild {
    fn random(rng: &mut Pcg) -> BvhBuild {
        BvhBuild {
            most: 4,
            boxes: heaps(rng),
        }
    }

    fn judge(q: &BvhBuild, golden: &BvhBuildAnswer, got: &BvhBuildAnswer) -> Verdict {
        no_dearer(
            "the tree",
            tree_cost(q, got)?,
            tree_cost(q, golden)?,
            DEARER,
        )
    }

    fn traits(q: &BvhBuild, got: &BvhBuildAnswer) -> Vec<f64> {
        let root = got
            .nodes
            .first()
            .map_or(1.0, node_area)
            .max(f32::MIN_POSITIVE);
        let n = q.boxes.len().max(1) as f64;
        let share = |node: &NodeRow| f64::from((node_area(node) / root).min(10.0));
        let sum = |f: &dyn Fn(&NodeRow) -> f64| got.nodes.iter().map(f).sum::<f64>();
        let leaves = sum(&|node| f64::from(node.count > 0)).max(1.0);
        vec![
            traits::log(sum(&|node| if node.count == 0 { share(node) } else { 0.0 }) + 0.1),
            traits::log(sum(&|node| share(node) * f64::from(node.count)) + 0.1),
            got.nodes.len() as f64 / (2.0 * n),
            got.nodes
                .iter()
                .map(|node| f64::from(node.count))
                .fold(0.0, f64::max)
                / n,
            sum(&|node| f64::from(node.count)) / leaves / f64::from(q.most.max(1)),
            got.order.len() as f64 / n,
            traits::distinct(got.order.iter().map(|i| f64::from(*i))),
            traits::distinct(
                got.nodes
                    .iter()
                    .filter(|node| node.count > 0)
                    .map(|node| f64::from(node.first)),
            ),
            f64::from(tree_cost(q, got).is_ok()),
        ]
    }

    const SLOW: bool = true;

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "splits by number",
            hint: "One box far away from nine others: who should share a side with it?",
            answer: |q| tree(&q.boxes, Method::Median, q.most),
        },
        Mistake {
            name: "cuts off one box at a time",
            hint: "How many boxes does a ray test in a tree that is one long branch?",
            answer: chain,
        },
        Mistake {
            name: "makes one leaf of all",
            hint: "A tree of one leaf is a list: what does a search in it cost?",
            answer: one_leaf,
        },
        Mistake {
            name: "gives every node the box of all",
            hint: "Which rays can be turned away at a box that is as large as the scene?",
            answer: |q| {
                let mut tree = BvhBuild::answer(q);
                let (min, max) = tree
                    .nodes
                    .first()
                    .map_or_else(Default::default, |n| (n.min, n.max));
                for node in &mut tree.nodes {
                    (node.min, node.max) = (min, max);
                }
                tree
            },
        },
        Mistake {
            name: "loses the last box",
            hint: "Count: how many boxes are in your leaves?",
            answer: |q| {
                let mut tree = BvhBuild::answer(q);
                tree.order.pop();
                tree
            },
        },
        Mistake {
            name: "puts the first box into every leaf",
            hint: "Where does the second leaf begin in the order?",
            answer: |q| {
                let mut tree = BvhBuild::answer(q);
                for node in tree.nodes.iter_mut().filter(|n| n.count > 0) {
                    node.first = 0;
                }
                tree
            },
        },
        Mistake {
            name: "makes boxes around the centres",
            hint: "A shape reaches beyond its centre: who finds the part outside the box?",
            answer: |q| {
                let points = q.boxes.iter().map(|row| cube(center(row), 0.0));
                let boxes: Vec<_> = points.collect();
                tree(&boxes, Method::Binned, q.most)
            },
        },
    ];
}

/// All boxes in one leaf.
fn one_leaf(q: &BvhBuild) -> BvhBuildAnswer {
    let order: Vec<_> = (0..q.boxes.len() as u32).collect();
    let Aabb { min, max } = around(&q.boxes, &order);
    let leaf = NodeRow {
        min,
        max,
        first: 0,
        count: order.len() as u32,
    };
    BvhBuildAnswer {
        nodes: vec![leaf],
        order,
    }
}

/// Whether a box holds another, which may stand out by `slack` on each side, in metres; a NaN is outside.
fn holds(whole: &Aabb, part: &Aabb, slack: f32) -> bool {
    (part.min + slack).cmpge(whole.min).all() && (part.max - slack).cmple(whole.max).all()
}

/// The cost of a tree, if it is one.
fn tree_cost(q: &BvhBuild, tree: &BvhBuildAnswer) -> Result<f32, String> {
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
                below.push((
                    format!("node {child}"),
                    Aabb {
                        min: row.min,
                        max: row.max,
                    },
                ));
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
            below.push((format!("box {shape}"), Aabb::from(row)));
        }
        let boxes = below.iter().map(|(_, bounds)| bounds);
        let whole = boxes.fold(Aabb::EMPTY, |whole, bounds| whole.union(bounds));
        let slack = 1e-4 * whole.size().abs().max_element().max(1e-3);
        let bounds = Aabb {
            min: node.min,
            max: node.max,
        };
        if let Some((name, _)) = below.iter().find(|(_, held)| !holds(&bounds, held, slack)) {
            return Err(format!(
                "{name} sticks out of node {i}, which should hold it"
            ));
        }
        // A box that is too large makes its children look cheap.
        if !holds(&whole, &bounds, slack) {
            return Err(format!(
                "the box of node {i} is larger than what it holds, which is from {} to {}",
                whole.min, whole.max
            ));
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

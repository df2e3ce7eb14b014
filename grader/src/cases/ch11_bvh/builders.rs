//! Trees of boxes by other rules than the surface-area heuristic: what mistaken builders make.

use super::{area, around, center};
use raybook::math::aabb::Aabb;
use raybook_workbook::exercises::ch11_bvh::{BvhBuild, BvhBuildAnswer};
use raybook_workbook::tree_rows::NodeRow;

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

/// All boxes in one leaf.
pub(super) fn one_leaf(q: &BvhBuild) -> BvhBuildAnswer {
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

/// What a cut is said to cost, from the areas of its two sides and the numbers of boxes in them.
type CutCost = fn([f32; 2], [usize; 2]) -> f32;

/// The tree of the cuts that cost least. What a leaf can hold is not cut.
pub(super) fn cut_by(q: &BvhBuild, cost: CutCost) -> BvhBuildAnswer {
    let node = |which: &[u32]| {
        let Aabb { min, max } = around(&q.boxes, which);
        NodeRow {
            min,
            max,
            first: 0,
            count: 0,
        }
    };
    let all: Vec<_> = (0..q.boxes.len() as u32).collect();
    let mut tree = BvhBuildAnswer {
        nodes: vec![node(&all)],
        order: Vec::new(),
    };
    let mut open = vec![(0, all)];
    while let Some((at, which)) = open.pop() {
        if which.len() <= q.most.max(1) as usize {
            tree.nodes[at].first = tree.order.len() as u32;
            tree.nodes[at].count = which.len() as u32;
            tree.order.extend(which);
            continue;
        }
        let sides = cheapest(q, which, cost);
        tree.nodes[at].first = tree.nodes.len() as u32;
        for side in sides {
            open.push((tree.nodes.len(), side.clone()));
            tree.nodes.push(node(&side));
        }
    }
    tree
}

/// The two sides of the cheapest cut between the sorted centres, along any axis.
fn cheapest(q: &BvhBuild, which: Vec<u32>, cost: CutCost) -> [Vec<u32>; 2] {
    let n = which.len();
    let mut best = (f32::INFINITY, which, n / 2);
    for axis in 0..3 {
        let mut sorted = best.1.clone();
        let place = |&i: &u32| center(&q.boxes[i as usize])[axis];
        sorted.sort_by(|a, b| place(a).total_cmp(&place(b)));
        let areas = |order: &mut dyn Iterator<Item = &u32>| -> Vec<f32> {
            let mut bounds = Aabb::EMPTY;
            let grown = order.map(|&i| {
                bounds = bounds.union(&Aabb::from(&q.boxes[i as usize]));
                area(bounds.min, bounds.max)
            });
            grown.collect()
        };
        let (below, above) = (areas(&mut sorted.iter()), areas(&mut sorted.iter().rev()));
        for cut in 1..n {
            let cost = cost([below[cut - 1], above[n - cut - 1]], [cut, n - cut]);
            if cost < best.0 {
                best = (cost, sorted.clone(), cut);
            }
        }
    }
    let (_, mut below, cut) = best;
    let above = below.split_off(cut);
    [below, above]
}

//! `bvh_build`: random questions, judge and mistakes.

use super::sah_cost::node_area;
use super::sah_split::cuts;
use super::{area, around, center, crowd, cube, heaps, no_dearer, tree};
use crate::{Flaw, Graded, Mistake, Verdict, sample, traits};
use raybook::accel::bvh::build::Method;
use raybook::math::{aabb::Aabb, pcg::Pcg};
use raybook_workbook::exercise::Exercise;
use raybook_workbook::exercises::ch11_bvh::{BvhBuild, BvhBuildAnswer};
use raybook_workbook::tree_rows::{BoxRow, NodeRow};
use std::cmp::Ordering;

/// How much more than the reference's the tree of this number of boxes may cost: neither is the best, and the fewer boxes there are,
/// the more does it matter which cut is taken first. Cuts at one of eight places, or along the longest axis only, cost up to 12 % more
/// among a hundred boxes and up to 5 % among a thousand; areas without one of three sides 20 to 35 % there, halves by number 50 %.
fn dearer(boxes: usize) -> f32 {
    match boxes {
        0..100 => 0.25,
        100..1000 => 0.15,
        _ => 0.08,
    }
}

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

    fn crowded(rng: &mut Pcg, count: usize) -> Option<BvhBuild> {
        Some(BvhBuild {
            most: 4,
            boxes: crowd(rng, count),
        })
    }

    fn is_sound(q: &BvhBuild) -> bool {
        q.boxes.iter().all(|b| sample::is_box(b.min, b.max))
    }

    fn judge(q: &BvhBuild, golden: &BvhBuildAnswer, got: &BvhBuildAnswer) -> Verdict {
        no_dearer(
            "the tree",
            tree_cost(q, got)?,
            tree_cost(q, golden)?,
            dearer(q.boxes.len()),
        )
        .map_err(|why| match wrong_choice(q, got) {
            Some(choice) => format!("{why}: {choice}"),
            None => why,
        })
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

    /// The nodes by levels, the child with the lower corner first, and each leaf's boxes by number, where it is a tree.
    fn canonical(q: &BvhBuild, tree: BvhBuildAnswer) -> BvhBuildAnswer {
        if tree.nodes.is_empty() || tree_cost(q, &tree).is_err() {
            return tree;
        }
        let mut one = BvhBuildAnswer {
            nodes: vec![tree.nodes[0].clone()],
            order: Vec::new(),
        };
        let mut i = 0;
        while i < one.nodes.len() {
            let first = one.nodes[i].first as usize;
            let count = one.nodes[i].count as usize;
            if count == 0 {
                one.nodes[i].first = one.nodes.len() as u32;
                let mut children = tree.nodes[first..first + 2].to_vec();
                let corner = |node: &NodeRow| [node.min.to_array(), node.max.to_array()].concat();
                children.sort_by(|a, b| {
                    let both = corner(a).into_iter().zip(corner(b));
                    both.map(|(a, b)| a.total_cmp(&b))
                        .fold(Ordering::Equal, Ordering::then)
                });
                one.nodes.extend(children);
            } else {
                one.nodes[i].first = one.order.len() as u32;
                let mut shapes = tree.order[first..first + count].to_vec();
                shapes.sort_unstable();
                one.order.extend(shapes);
            }
            i += 1;
        }
        one
    }

    const SLOW: bool = true;

    const FLAWS: &'static [Flaw] = &[
        Flaw {
            complaint: "the order has",
            name: "loses boxes on the way into the order, or puts some there twice",
            hint: "Count: how long is the order, and how many boxes are there?",
        },
        Flaw {
            complaint: "there is no node",
            name: "makes no node where there must be one",
            hint: "How many nodes does a tree of one box have?",
        },
        Flaw {
            complaint: "which is not there",
            name: "gives a branch children that are not in the list of nodes",
            hint: "How long is the list of nodes at the moment when a branch's two children are appended?",
        },
        Flaw {
            complaint: "is the child of two branches",
            name: "gives two branches the same child",
            hint: "The two children of a branch are side by side, from its `first`: does another branch use one of these places?",
        },
        Flaw {
            complaint: "are allowed",
            name: "puts more boxes into a leaf than are allowed",
            hint: "What makes a leaf final: that a cut would not pay, that there are few enough boxes in it, or both?",
        },
        Flaw {
            complaint: "of the order, where no box is",
            name: "lets leaves name places or boxes that are not there",
            hint: "Does a leaf begin where the order ended before its own boxes were appended? Do your boxes count from 0?",
        },
        Flaw {
            complaint: "is in the tree twice",
            name: "puts a box into two leaves",
            hint: "Draw the order as a line: which piece of it belongs to which leaf?",
        },
        Flaw {
            complaint: "sticks out of node",
            name: "gives nodes boxes that do not hold what is below them",
            hint: "From which boxes, and from how many of them, is a node's own box made?",
        },
        Flaw {
            complaint: "is larger than what it holds",
            name: "gives nodes boxes that are larger than what they hold",
            hint: "From which boxes is a node's own box made: from those below it, or from more?",
        },
        Flaw {
            complaint: "is in no leaf",
            name: "loses boxes",
            hint: "Count: how many boxes are in your leaves?",
        },
        Flaw {
            complaint: "half of its boxes on each side",
            name: "puts half of the boxes on each side of every cut",
            hint: "One box far away from nine others: who should share a side with it?",
        },
        Flaw {
            complaint: "a leaf, and a cut would be cheaper",
            name: "stops cutting where a cut would be cheaper than the leaf",
            hint: "A leaf of four costs four tests wherever the ray is in it: what would two leaves of two cost, and how often would each be opened?",
        },
        Flaw {
            complaint: "is cut, and a leaf would be cheaper",
            name: "goes on cutting where a leaf would be cheaper",
            hint: "Two boxes that lie in the same place: what does a ray gain if they are in two leaves?",
        },
        Flaw {
            complaint: "another cut of its boxes",
            name: "does not find the cheapest cut",
            hint: "Of each cut: is its cost the area of a side's box times the number of boxes in it, summed over both sides? Do you try all three axes and all places between the sorted centres, and take the least?",
        },
    ];

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
    // Where a node begins is the cause of what is wrong with its box: the boxes come last.
    let mut holdings = Vec::new();
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
        holdings.push((i, node, below));
    }
    if let Some(lost) = met.iter().position(|met| !met) {
        return Err(format!("box {lost} is in no leaf"));
    }
    let mut sum = 0.0;
    for (i, node, below) in holdings {
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
        sum += node_area(node) * node.count.max(1) as f32;
    }
    Ok(sum
        / tree
            .nodes
            .first()
            .map_or(1.0, node_area)
            .max(f32::MIN_POSITIVE))
}

/// The first choice in a tree that costs more than it need: of a leaf, or of a cut.
fn wrong_choice(q: &BvhBuild, tree: &BvhBuildAnswer) -> Option<String> {
    let below = |node: usize| {
        let (mut shapes, mut open) = (Vec::new(), vec![node]);
        while let Some(row) = open.pop().and_then(|i| tree.nodes.get(i)) {
            let (first, count) = (row.first as usize, row.count as usize);
            if count == 0 {
                open.extend([first, first + 1]);
            }
            shapes.extend(tree.order.get(first..first + count).unwrap_or_default());
        }
        shapes
    };
    let mut halves = true;
    let mut first = None;
    let mut open = vec![0];
    while let Some(i) = open.pop() {
        let shapes = below(i);
        let boxes: Vec<_> = shapes
            .iter()
            .map(|&i| q.boxes[i as usize].clone())
            .collect();
        let cut = |sides: &[Vec<u32>; 2]| sides.each_ref().map(|side| price_of(&boxes, side));
        let best = cuts(&boxes, center)
            .iter()
            .map(|(_, sides)| cut(sides).iter().sum::<f32>())
            .fold(f32::INFINITY, f32::min);
        let row = &tree.nodes[i];
        let own = node_area(row);
        let leaf = own * shapes.len() as f32;
        if row.count > 0 {
            if own + best < 0.99 * leaf {
                let count = row.count;
                first.get_or_insert(format!(
                    "node {i} is a leaf, and a cut would be cheaper: it holds {count} boxes"
                ));
            }
            continue;
        }
        let children = [row.first as usize, row.first as usize + 1];
        let sides = children.map(below);
        halves &= sides[0].len().abs_diff(sides[1].len()) <= 1;
        let paid: f32 = sides.iter().map(|side| price_of(&q.boxes, side)).sum();
        if shapes.len() <= q.most as usize && own + best > 1.01 * leaf {
            first.get_or_insert(format!("node {i} is cut, and a leaf would be cheaper"));
        } else if paid > 1.1 * best {
            let more = 100.0 * (paid / best - 1.0);
            first.get_or_insert(format!(
                "node {i} is cut so that it costs {more:.0} % more than another cut of its boxes"
            ));
        }
        open.extend(children);
    }
    let many = tree.nodes.len() > 6;
    if halves && many {
        return Some("each branch has half of its boxes on each side".to_owned());
    }
    first
}

/// The area around some of these boxes, times their number.
fn price_of(boxes: &[BoxRow], which: &[u32]) -> f32 {
    let Aabb { min, max } = around(boxes, which);
    area(min, max) * which.len() as f32
}

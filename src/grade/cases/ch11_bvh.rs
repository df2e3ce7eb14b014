//! Chapter 11: `sah_cost`, `sah_split`, `bvh_build`, `bvh_closest`.

use crate::accel::bvh::COST;
use crate::accel::bvh::build::cost::Cost;
use crate::accel::bvh::build::{Method, build};
use crate::accel::ray_box::RayBox;
use crate::grade::examine::Examiner;
use crate::grade::{Edge, Graded, Mistake, Picture, Verdict, judge, sample};
use crate::image::rgb::Rgb;
use crate::lab::palette::viridis;
use crate::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use crate::shape::{Shape, mesh::Facet};
use crate::workbook::exercise::Exercise;
use crate::workbook::exercises::ch07_mesh::{Corners, MeshHitAnswer};
use crate::workbook::exercises::ch11_bvh::{
    BvhBuild, BvhBuildAnswer, BvhBuildQuestion, BvhClosest, BvhClosestAnswer, BvhClosestQuestion,
    SahCost, SahCostQuestion, SahSplit, SahSplitQuestion,
};
use crate::workbook::tree_rows::{BoxRow, NodeRow, to_rows};
use glam::{Vec3, vec3};
use rand::RngExt;

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&SahCost, &SahSplit, &BvhBuild, &BvhClosest];

fn area(min: Vec3, max: Vec3) -> f32 {
    let size = max - min;
    2.0 * (size.x * size.y + size.y * size.z + size.z * size.x)
}

fn around(boxes: &[BoxRow], which: &[u32]) -> Aabb {
    let corners = which.iter().filter_map(|&i| boxes.get(i as usize));
    Aabb::of(corners.flat_map(|row| [row.min, row.max]))
}

fn cube(center: Vec3, half: f32) -> BoxRow {
    BoxRow {
        min: center - half,
        max: center + half,
    }
}

/// Boxes of different sizes in a few heaps of different numbers: what a split by number alone gets wrong.
fn heaps(rng: &mut Pcg) -> Vec<BoxRow> {
    let mut boxes = Vec::new();
    for count in [1, 2, 5] {
        let center = sample::point(rng, 8.0);
        for _ in 0..count + rng.random_range(0..2) {
            let half = vec3(
                sample::number(rng, 0.1, 0.8),
                sample::number(rng, 0.1, 0.8),
                sample::number(rng, 0.1, 0.8),
            );
            let at = center + sample::point(rng, 1.5);
            boxes.push(BoxRow {
                min: at - half,
                max: at + half,
            });
        }
    }
    boxes
}

/// The tree over boxes by a method, with leaves of at most so many shapes.
fn tree(boxes: &[BoxRow], method: Method, most: u32) -> BvhBuildAnswer {
    let boxes: Vec<_> = boxes.iter().map(Aabb::from).collect();
    let flat = build(&boxes, method, &Cost { most, ..COST });
    BvhBuildAnswer {
        nodes: to_rows(&flat),
        order: flat.order,
    }
}

/// Σ of a price per node times a measure of its box, by that of the root's.
fn weighted(
    q: &SahCostQuestion,
    measure: fn(&NodeRow) -> f32,
    price: fn(&SahCostQuestion, &NodeRow) -> f32,
) -> f32 {
    let sum: f32 = q.nodes.iter().map(|n| measure(n) * price(q, n)).sum();
    sum / q.nodes.first().map_or(1.0, measure)
}

fn node_area(node: &NodeRow) -> f32 {
    area(node.min, node.max)
}

fn node_price(q: &SahCostQuestion, node: &NodeRow) -> f32 {
    match node.count {
        0 => q.branch,
        count => q.shape * count as f32,
    }
}

impl Graded for SahCost {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "forgets to divide by the root's area",
            hint: "Make everything twice as large: does a search take longer?",
            answer: |q| SahCost::answer(q) * q.nodes.first().map_or(1.0, node_area),
        },
        Mistake {
            name: "counts the leaves only",
            hint: "Who comes to a leaf has opened branches before: for free?",
            answer: |q| weighted(&free(q, true), node_area, node_price),
        },
        Mistake {
            name: "counts the branches only",
            hint: "What does a search do once it is in a leaf?",
            answer: |q| weighted(&free(q, false), node_area, node_price),
        },
        Mistake {
            name: "gives every leaf the price of one shape",
            hint: "Does a leaf of five shapes cost as much as a leaf of one?",
            answer: |q| {
                weighted(
                    q,
                    node_area,
                    |q, n| {
                        if n.count == 0 { q.branch } else { q.shape }
                    },
                )
            },
        },
        Mistake {
            name: "weighs by volume",
            hint: "How large is the chance that a ray meets a flat box, which has no volume?",
            answer: |q| weighted(q, |n| (n.max - n.min).element_product(), node_price),
        },
        Mistake {
            name: "leaves out the root",
            hint: "A ray that meets the root's box opens the root, with what probability?",
            answer: |q| SahCost::answer(q) - q.nodes.first().map_or(0.0, |n| node_price(q, n)),
        },
        Mistake {
            name: "counts every node as often as another",
            hint: "Do as many rays meet a small box as a large one?",
            answer: |q| weighted(q, |_| 1.0, node_price),
        },
        Mistake {
            name: "weighs by the longest side",
            hint: "Lines through a box are counted by its surface, not by a length.",
            answer: |q| weighted(q, |n| (n.max - n.min).max_element(), node_price),
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let leaf = |min, max, first, count| NodeRow {
            min,
            max,
            first,
            count,
        };
        let branch = |min, max, first| leaf(min, max, first, 0);
        let (o, one) = (Vec3::ZERO, Vec3::ONE);
        let root = branch(o, vec3(4.0, 1.0, 1.0), 1);
        let halves = vec![
            root.clone(),
            leaf(o, one, 0, 2),
            leaf(vec3(3.0, 0.0, 0.0), vec3(4.0, 1.0, 1.0), 2, 3),
        ];
        let overlapping = vec![
            root.clone(),
            leaf(o, vec3(3.0, 1.0, 1.0), 0, 1),
            leaf(vec3(1.0, 0.0, 0.0), vec3(4.0, 1.0, 1.0), 1, 1),
        ];
        let flat = vec![
            branch(o, vec3(4.0, 0.0, 2.0), 1),
            leaf(o, vec3(1.0, 0.0, 2.0), 0, 4),
            leaf(vec3(2.0, 0.0, 0.0), vec3(4.0, 0.0, 1.0), 4, 2),
        ];
        let chain = vec![
            root,
            leaf(o, one, 0, 1),
            branch(vec3(1.0, 0.0, 0.0), vec3(4.0, 1.0, 1.0), 3),
            leaf(vec3(1.0, 0.0, 0.0), vec3(2.0, 1.0, 1.0), 1, 1),
            leaf(vec3(2.5, 0.0, 0.0), vec3(4.0, 1.0, 1.0), 2, 2),
        ];
        let edge = |name, branch, shape, nodes| {
            let question = SahCostQuestion {
                branch,
                shape,
                nodes,
            };
            Edge::new(name, question)
        };
        vec![
            edge("one leaf is all", 1.0, 1.0, vec![leaf(o, one, 0, 6)]),
            edge("two leaves", 1.0, 1.0, halves.clone()),
            edge("dear branches", 3.0, 1.0, halves.clone()),
            edge("dear shapes", 1.0, 2.5, halves),
            edge("boxes that overlap", 1.0, 1.0, overlapping),
            edge("flat boxes", 1.0, 1.0, flat),
            edge("a branch in a branch", 1.0, 1.0, chain),
        ]
    }

    fn random(rng: &mut Pcg) -> SahCostQuestion {
        let boxes = heaps(rng);
        SahCostQuestion {
            branch: sample::number(rng, 0.5, 2.0),
            shape: sample::number(rng, 0.5, 2.0),
            nodes: tree(&boxes, Method::Median, 8).nodes,
        }
    }

    fn judge(_q: &SahCostQuestion, golden: &f32, got: &f32) -> Verdict {
        judge::number("the cost", "", *golden, *got)
    }
}

/// The question where branches, or shapes, cost nothing.
fn free(q: &SahCostQuestion, branches: bool) -> SahCostQuestion {
    let mut q = q.clone();
    if branches {
        q.branch = 0.0;
    } else {
        q.shape = 0.0;
    }
    q
}

/// All cuts between neighbouring centres along an axis: the axis, and who is on the left and on the right.
fn cuts(boxes: &[BoxRow], key: fn(&BoxRow) -> Vec3) -> Vec<(usize, [Vec<u32>; 2])> {
    let mut cuts = Vec::new();
    for axis in 0..3 {
        let mut order: Vec<_> = (0..boxes.len() as u32).collect();
        order.sort_by(|&a, &b| {
            key(&boxes[a as usize])[axis].total_cmp(&key(&boxes[b as usize])[axis])
        });
        for left in 1..boxes.len() {
            let (left, right) = order.split_at(left);
            cuts.push((axis, [left.to_vec(), right.to_vec()]));
        }
    }
    cuts
}

fn center(row: &BoxRow) -> Vec3 {
    0.5 * (row.min + row.max)
}

/// The left side of the cut that is least by some measure of a side, left plus right.
fn least(q: &SahSplitQuestion, side: fn(&Aabb, f32) -> f32) -> Vec<u32> {
    cut_with(q, |_, sides| {
        let measure = |s: &Vec<u32>| side(&around(&q.boxes, s), s.len() as f32);
        measure(&sides[0]) + measure(&sides[1])
    })
}

fn cut_with(q: &SahSplitQuestion, cost: impl Fn(usize, &[Vec<u32>; 2]) -> f32) -> Vec<u32> {
    let cuts = cuts(&q.boxes, center);
    let best = cuts
        .into_iter()
        .min_by(|a, b| cost(a.0, &a.1).total_cmp(&cost(b.0, &b.1)));
    best.map_or(Vec::new(), |(_, [left, _])| left)
}

fn sah(bounds: &Aabb, count: f32) -> f32 {
    area(bounds.min, bounds.max) * count
}

/// The axis along which all boxes together are longest.
fn longest(q: &SahSplitQuestion) -> usize {
    let all: Vec<_> = (0..q.boxes.len() as u32).collect();
    around(&q.boxes, &all).size().max_position()
}

fn split_cost(q: &SahSplitQuestion, left: &[u32]) -> Result<f32, String> {
    let n = q.boxes.len() as u32;
    if let Some(i) = left.iter().find(|&&i| i >= n) {
        return Err(format!("there is no box {i}: there are {n}, from 0"));
    }
    if let Some(twice) = (0..n).find(|i| left.iter().filter(|j| *j == i).count() > 1) {
        return Err(format!("box {twice} is on the left more than once"));
    }
    let right: Vec<_> = (0..n).filter(|i| !left.contains(i)).collect();
    if left.is_empty() || right.is_empty() {
        return Err("all boxes are on the same side".to_owned());
    }
    let side = |side: &[u32]| sah(&around(&q.boxes, side), side.len() as f32);
    Ok(side(left) + side(&right))
}

impl Graded for SahSplit {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "puts half of the boxes on each side",
            hint: "One box far away from nine others: who should share a side with it?",
            answer: |q| {
                cut_with(q, |axis, [left, right]| {
                    let off = left.len().abs_diff(right.len());
                    off as f32 + if axis == longest(q) { 0.0 } else { 100.0 }
                })
            },
        },
        Mistake {
            name: "tries the longest axis only",
            hint: "Is the best cut always across the longest side?",
            answer: |q| {
                cut_with(q, |axis, sides| {
                    let [left, right] =
                        [0, 1].map(|i| sah(&around(&q.boxes, &sides[i]), sides[i].len() as f32));
                    left + right + if axis == longest(q) { 0.0 } else { 1e9 }
                })
            },
        },
        Mistake {
            name: "tries the x axis only",
            hint: "Stack the boxes along y: where do you cut?",
            answer: |q| {
                cut_with(q, |axis, sides| {
                    let [left, right] =
                        [0, 1].map(|i| sah(&around(&q.boxes, &sides[i]), sides[i].len() as f32));
                    left + right + 1e9 * axis as f32
                })
            },
        },
        Mistake {
            name: "does not multiply by the number of shapes",
            hint: "What does a ray that meets a side's box do there, and how often?",
            answer: |q| least(q, |bounds, _| area(bounds.min, bounds.max)),
        },
        Mistake {
            name: "weighs by volume",
            hint: "How large is the chance that a ray meets a flat box, which has no volume?",
            answer: |q| least(q, |bounds, count| bounds.size().element_product() * count),
        },
        Mistake {
            name: "weighs by the longest side",
            hint: "Lines through a box are counted by its surface, not by a length.",
            answer: |q| least(q, |bounds, count| bounds.size().max_element() * count),
        },
        Mistake {
            name: "takes the dearest cut",
            hint: "A cost is something to keep small: which way round do you compare?",
            answer: |q| least(q, |bounds, count| -sah(bounds, count)),
        },
        Mistake {
            name: "cuts off a single box",
            hint: "If the left side has one box, how much work is left on the right?",
            answer: |q| cut_with(q, |axis, [left, _]| left.len() as f32 + 0.1 * axis as f32),
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let row = |centers: &[[f32; 3]]| {
            let boxes = centers.iter().map(|&c| cube(c.into(), 0.5));
            SahSplitQuestion {
                boxes: boxes.collect(),
            }
        };
        let along = |at: &[f32], axis: usize| {
            let mut centers = vec![[0.0; 3]; at.len()];
            for (center, &at) in centers.iter_mut().zip(at) {
                center[axis] = at;
            }
            row(&centers)
        };
        let mut one_large = along(&[0.0, 2.0, 4.0, 6.0], 0);
        one_large.boxes.push(cube(vec3(1.0, 0.0, 0.0), 4.0));
        let tiles = [0.0, 1.0, 5.0, 6.0].map(|x| BoxRow {
            min: vec3(x, 0.0, 0.0),
            max: vec3(x + 1.0, 0.0, 3.0),
        });
        vec![
            Edge::new("two boxes", along(&[0.0, 3.0], 0)),
            Edge::new("one far away", along(&[0.0, 1.0, 2.0, 3.0, 20.0], 0)),
            Edge::new("a stack along y", along(&[0.0, 1.0, 7.0, 8.0, 9.0], 1)),
            Edge::new("a row along z", along(&[0.0, 6.0, 7.0], 2)),
            Edge::new("the same box four times", along(&[1.0; 4], 0)),
            Edge::new("in no order", along(&[9.0, 0.0, 8.0, 1.0, 2.0], 0)),
            Edge::new("one large box among small ones", one_large),
            Edge::new(
                "flat boxes",
                SahSplitQuestion {
                    boxes: tiles.into(),
                },
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> SahSplitQuestion {
        SahSplitQuestion { boxes: heaps(rng) }
    }

    fn judge(q: &SahSplitQuestion, golden: &Vec<u32>, got: &Vec<u32>) -> Verdict {
        let (best, cost) = (split_cost(q, golden)?, split_cost(q, got)?);
        no_dearer("this split", cost, best, judge::RELATIVE)
    }
}

/// A cost that may exceed the reference's by some part of it.
fn no_dearer(what: &str, got: f32, reference: f32, part: f32) -> Verdict {
    if got <= reference * (1.0 + part) {
        Ok(())
    } else {
        Err(format!(
            "{what} costs {got:.3}, {:.0} % more than {reference:.3}",
            100.0 * (got / reference - 1.0)
        ))
    }
}

/// A tree may cost so much more than the reference's: neither is the best, and which cut is taken first decides more.
const DEARER: f32 = 0.25;

/// The cost of a tree, if it is one.
fn tree_cost(q: &BvhBuildQuestion, tree: &BvhBuildAnswer) -> Result<f32, String> {
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

/// A tree that takes the boxes in this order and cuts off one after the other.
fn chain(q: &BvhBuildQuestion) -> BvhBuildAnswer {
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

    fn edges() -> Vec<Edge<Self>> {
        let row = |at: &[f32], most| BvhBuildQuestion {
            most,
            boxes: at
                .iter()
                .map(|&x| cube(vec3(x, 0.5 * x, 1.0), 0.5))
                .collect(),
        };
        let mut hay = row(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0], 2);
        hay.boxes.push(cube(vec3(2.0, 2.0, 2.0), 6.0));
        let grid = (0..9).map(|i| cube(vec3((i % 3) as f32 * 2.0, 0.0, (i / 3) as f32 * 3.0), 0.5));
        vec![
            Edge::new("a single box", row(&[1.0], 4)),
            Edge::new("two boxes far from each other", row(&[0.0, 30.0], 4)),
            Edge::new("two heaps", row(&[0.0, 0.5, 1.0, 20.0, 20.5, 21.0], 4)),
            Edge::new("one far away", row(&[0.0, 1.0, 2.0, 3.0, 4.0, 40.0], 4)),
            Edge::new(
                "growing distances",
                row(&[1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0], 2),
            ),
            Edge::new("the same box six times", row(&[1.0; 6], 6)),
            Edge::new("a large box over small ones", hay),
            Edge::new(
                "three rows of three",
                BvhBuildQuestion {
                    most: 1,
                    boxes: grid.collect(),
                },
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> BvhBuildQuestion {
        BvhBuildQuestion {
            most: 4,
            boxes: heaps(rng),
        }
    }

    fn judge(q: &BvhBuildQuestion, golden: &BvhBuildAnswer, got: &BvhBuildAnswer) -> Verdict {
        no_dearer(
            "the tree",
            tree_cost(q, got)?,
            tree_cost(q, golden)?,
            DEARER,
        )
    }
}

/// All boxes in one leaf.
fn one_leaf(q: &BvhBuildQuestion) -> BvhBuildAnswer {
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

#[expect(
    clippy::struct_excessive_bools,
    reason = "each is a mistake of its own"
)]
/// How a search goes.
#[derive(Clone, Copy)]
struct How {
    /// Looks at the boxes.
    boxes: bool,
    /// The nearer child first, or the farther one.
    near_first: bool,
    /// The second child, too.
    both: bool,
    /// A hit ends the interval.
    shortens: bool,
    /// The nearest hit stays; else the last.
    nearest: bool,
    /// Stops after the first leaf with a hit.
    stops: bool,
}

const WELL: How = How {
    boxes: true,
    near_first: true,
    both: true,
    shortens: true,
    nearest: true,
    stops: false,
};

struct Search<'a> {
    q: &'a BvhClosestQuestion,
    how: How,
    within: Interval,
    found: BvhClosestAnswer,
}

fn search(q: &BvhClosestQuestion, how: How) -> BvhClosestAnswer {
    let found = BvhClosestAnswer {
        boxes: 0,
        tests: 0,
        hit: None,
    };
    let within = q.within;
    let mut search = Search {
        q,
        how,
        within,
        found,
    };
    search.open(0);
    search.found
}

impl Search<'_> {
    fn open(&mut self, node: usize) {
        let Some(node) = self.q.nodes.get(node) else {
            return;
        };
        let stopped = self.how.stops && self.found.hit.is_some();
        let first = node.first as usize;
        if node.count > 0 && !stopped {
            (first..first + node.count as usize).for_each(|id| self.test(id));
        } else if !stopped {
            let children = [first, first + 1].map(|child| (self.enters(child), child));
            let mut met: Vec<_> = children
                .into_iter()
                .filter_map(|(t, child)| Some((t?, child)))
                .collect();
            met.sort_by(|a, b| a.0.total_cmp(&b.0));
            if !self.how.near_first {
                met.reverse();
            }
            met.truncate(if self.how.both { 2 } else { 1 });
            for (t, child) in met {
                if t < self.within.max {
                    self.open(child);
                }
            }
        }
    }

    fn enters(&mut self, child: usize) -> Option<f32> {
        let node = &self.q.nodes[child];
        let (min, max) = (node.min, node.max);
        self.found.boxes += 1;
        if self.how.boxes {
            RayBox::new(&self.q.ray).enters(&Aabb { min, max }, self.within)
        } else {
            Some(self.within.min)
        }
    }

    fn test(&mut self, id: usize) {
        self.found.tests += 1;
        let t = &self.q.triangles[id];
        let facet = Facet {
            corners: [t.p0, t.p1, t.p2],
            id: id as u32,
        };
        if let Some(hit) = facet.hit(&self.q.ray, self.within) {
            if self.how.shortens {
                self.within = self.within.before(hit.t);
            }
            let nearer = self.found.hit.as_ref().is_none_or(|best| hit.t < best.t);
            if nearer || !self.how.nearest {
                self.found.hit = Some(MeshHitAnswer {
                    t: hit.t,
                    id: hit.id,
                });
            }
        }
    }
}

impl Graded for BvhClosest {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "tests every triangle",
            hint: "The hit is right, but the boxes are there to spare you tests: ask them first.",
            answer: |q| BvhClosestAnswer {
                boxes: 0,
                ..search(
                    q,
                    How {
                        boxes: false,
                        ..WELL
                    },
                )
            },
        },
        Mistake {
            name: "opens every box",
            hint: "What does it mean for all that is in a box if the ray misses the box?",
            answer: |q| {
                search(
                    q,
                    How {
                        boxes: false,
                        ..WELL
                    },
                )
            },
        },
        Mistake {
            name: "does not shorten the interval for the second child",
            hint: "Something was hit in the first child: which boxes are still worth opening?",
            answer: |q| {
                search(
                    q,
                    How {
                        shortens: false,
                        ..WELL
                    },
                )
            },
        },
        Mistake {
            name: "returns the last hit instead of the nearest",
            hint: "A hit in the second child may lie behind one in the first: which one stays?",
            answer: |q| {
                let how = How {
                    shortens: false,
                    nearest: false,
                    ..WELL
                };
                search(q, how)
            },
        },
        Mistake {
            name: "opens the farther child first",
            hint: "Where is the nearest hit more likely, and what is spared if you find it first?",
            answer: |q| {
                search(
                    q,
                    How {
                        near_first: false,
                        ..WELL
                    },
                )
            },
        },
        Mistake {
            name: "never opens the farther child",
            hint: "The nearer box may be empty where the ray passes through it.",
            answer: |q| {
                search(
                    q,
                    How {
                        both: false,
                        ..WELL
                    },
                )
            },
        },
        Mistake {
            name: "stops at the first leaf with a hit",
            hint: "Boxes may overlap: can a triangle of the farther box be nearer?",
            answer: |q| {
                search(
                    q,
                    How {
                        stops: true,
                        ..WELL
                    },
                )
            },
        },
        Mistake {
            name: "ignores the interval's min",
            hint: "Can the ray hit what lies behind its origin?",
            answer: |q| {
                let mut q = q.clone();
                q.within.min = f32::NEG_INFINITY;
                search(&q, WELL)
            },
        },
    ];

    const PICTURE: Option<Picture<Self>> = Some(Picture {
        width: 96,
        height: 54,
        alt: "Tiles on a slanted wall, each in its colour",
        question: |x, y| {
            let toward = vec3((x as f32 - 47.5) / 54.0, (26.5 - y as f32) / 54.0, -1.0);
            let tiles = (0..24).map(|i| {
                let at = vec3((i % 6) as f32 - 2.5, (i / 6) as f32 - 1.5, 0.0);
                let tilt = vec3(0.0, 0.0, 0.3 * at.x);
                let [p0, p1, p2] = [
                    vec3(-0.45, -0.4, 0.0),
                    vec3(0.45, -0.4, 0.2),
                    vec3(0.0, 0.45, -0.1),
                ];
                [p0, p1, p2].map(|p| 0.6 * (p + at + tilt))
            });
            question(
                &tiles.collect::<Vec<_>>(),
                Ray::new(vec3(0.0, 0.0, 3.0), Dir3::new_or(toward, Dir3::Z)),
                Interval::AHEAD,
            )
        },
        colour: |_, answer| {
            let hit = answer.hit.as_ref();
            hit.map_or(Rgb::gray(0.1), |hit| {
                viridis((hit.id as f32 * 0.382).fract())
            })
        },
    });

    fn edges() -> Vec<Edge<Self>> {
        let wall = |z: f32| [vec3(-2.0, -2.0, z), vec3(2.0, -2.0, z), vec3(0.0, 3.0, z)];
        let walls = |zs: &[f32], ray, within| {
            question(
                &zs.iter().map(|&z| wall(z)).collect::<Vec<_>>(),
                ray,
                within,
            )
        };
        let ray = Ray::new(Vec3::ZERO, Dir3::Z);
        let ahead = Interval::AHEAD;
        let row = [2.0, 4.0, 6.0, 8.0, 10.0, 12.0, 14.0, 16.0];
        let minus_zero = Ray::new(Vec3::ZERO, Dir3::new_or(vec3(-0.0, -0.0, 1.0), Dir3::Z));
        let slanted = |z: f32| {
            [
                vec3(-2.0, -2.0, z - 3.0),
                vec3(2.0, -2.0, z - 3.0),
                vec3(0.0, 3.0, z + 4.0),
            ]
        };
        vec![
            Edge::new("eight walls ahead", walls(&row, ray, ahead)),
            Edge::new(
                "eight walls, from the other end",
                walls(
                    &row,
                    Ray::new(
                        vec3(0.0, 0.0, 18.0),
                        Dir3::new_or(vec3(0.0, 0.0, -1.0), Dir3::Z),
                    ),
                    ahead,
                ),
            ),
            Edge::new(
                "from between the walls",
                walls(&row, Ray::new(vec3(0.0, 0.0, 9.0), Dir3::Z), ahead),
            ),
            Edge::new(
                "past the walls",
                walls(&row, Ray::new(vec3(5.0, 0.0, 0.0), Dir3::Z), ahead),
            ),
            Edge::new(
                "the interval ends before the walls",
                walls(&row, ray, Interval::new(0.0, 1.0)),
            ),
            Edge::new(
                "the interval begins behind some walls",
                walls(&row, ray, Interval::new(5.0, 30.0)),
            ),
            Edge::new("a direction with two −0", walls(&row, minus_zero, ahead)),
            Edge::new("one leaf is all", walls(&[3.0], ray, ahead)),
            Edge::new(
                "the nearer box has the farther hit",
                question(
                    &[slanted(4.0), slanted(4.5), wall(3.0), wall(3.5)],
                    ray,
                    ahead,
                ),
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> BvhClosestQuestion {
        let triangles = (0..24).map(|_| {
            let center = sample::point(rng, 2.0);
            std::array::from_fn(|_| center + sample::point(rng, 1.0))
        });
        let triangles: Vec<_> = triangles.collect();
        let origin = sample::point(rng, 4.0);
        let toward = sample::point(rng, 1.5) - origin;
        let end = if rng.random_bool(0.2) {
            sample::number(rng, 2.0, 5.0)
        } else {
            f32::INFINITY
        };
        let ray = Ray::new(origin, Dir3::new_or(toward, Dir3::X));
        question(&triangles, ray, Interval::new(0.0, end))
    }

    fn judge(
        _q: &BvhClosestQuestion,
        golden: &BvhClosestAnswer,
        got: &BvhClosestAnswer,
    ) -> Verdict {
        judge::option(
            "a hit",
            golden.hit.as_ref(),
            got.hit.as_ref(),
            |golden, got| {
                judge::number("t", "m", golden.t, got.t)?;
                if golden.id == got.id {
                    Ok(())
                } else {
                    Err(format!(
                        "you returned triangle {}, and triangle {} is hit",
                        got.id, golden.id
                    ))
                }
            },
        )?;
        if got.hit.is_some() && got.tests == 0 {
            return Err("you found a hit without testing a triangle".to_owned());
        }
        few("triangle", golden.tests, got.tests)?;
        few("box", golden.boxes, got.boxes)
    }
}

/// Not many more tests than the reference's: half as many, and four, for another sound order of the children.
fn few(what: &str, golden: u32, got: u32) -> Verdict {
    if got <= golden + golden / 2 + 4 {
        Ok(())
    } else {
        Err(format!(
            "the hit is right, but it took {got} {what} tests; the reference needs {golden}"
        ))
    }
}

/// The question about triangles in a tree of small leaves.
fn question(triangles: &[[Vec3; 3]], ray: Ray, within: Interval) -> BvhClosestQuestion {
    let boxes: Vec<_> = triangles
        .iter()
        .map(|&corners| {
            let Aabb { min, max } = Aabb::of(corners);
            BoxRow { min, max }
        })
        .collect();
    let tree = tree(&boxes, Method::Binned, 2);
    let in_order = tree.order.iter().map(|&i| {
        let [p0, p1, p2] = triangles[i as usize];
        Corners { p0, p1, p2 }
    });
    BvhClosestQuestion {
        ray,
        within,
        triangles: in_order.collect(),
        nodes: tree.nodes,
    }
}

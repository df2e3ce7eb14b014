//! The tree of an answer to `bvh_build`: its cost, if it is one, and the first choice that makes it dear.

use super::sah_cost::node_area;
use super::sah_split::cuts;
use super::{area, around, center};
use raybook::math::aabb::Aabb;
use raybook_workbook::exercises::ch11_bvh::{BvhBuild, BvhBuildAnswer};
use raybook_workbook::tree_rows::{BoxRow, NodeRow};

/// Whether a box holds another, which may stand out by `slack` on each side, in metres; a NaN is outside.
fn holds(whole: &Aabb, part: &Aabb, slack: f32) -> bool {
    (part.min + slack).cmpge(whole.min).all() && (part.max - slack).cmple(whole.max).all()
}

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

/// What is wrong if the nodes stand depth first, and so the children of some branch not where a search finds them.
pub(super) fn apart(nodes: &[NodeRow]) -> Option<String> {
    let child = (0..2).find(|child| are_apart(nodes, *child))?;
    let which = ["first", "second"][child];
    Some(format!(
        "the nodes stand depth first, and each branch has the number of its {which} child: its two children must be side by side, from its `first`"
    ))
}

/// Whether the nodes stand depth first, as their boxes show, each branch has the number of its first child, 0, or of its second, 1, and
/// the children of some branch are not the two nodes from there.
fn are_apart(nodes: &[NodeRow], child: usize) -> bool {
    let holds = |outer: &NodeRow, inner: usize| {
        let inner = &nodes[inner];
        outer.min.cmple(inner.min).all() && inner.max.cmple(outer.max).all()
    };
    // From the last node to the first: all that have no branch yet, that with the least number last.
    let mut open = Vec::new();
    let mut apart = false;
    for (at, node) in nodes.iter().enumerate().rev() {
        if node.count == 0 {
            let (Some(one), Some(other)) = (open.pop(), open.pop()) else {
                return false;
            };
            let first = node.first as usize;
            if first != [one, other][child] || !holds(node, one) || !holds(node, other) {
                return false;
            }
            apart |= first != one || first + 1 != other;
        }
        open.push(at);
    }
    apart && open == [0]
}

/// What is wrong with a tree that is sound as soon as its branches have other numbers of children, its leaves begin at other places, or
/// its order is the other way round.
pub(super) fn misplaced(q: &BvhBuild, tree: &BvhBuildAnswer) -> Option<String> {
    let begun = |first: &dyn Fn(&NodeRow) -> Option<u32>| {
        let mut tree = tree.clone();
        for leaf in tree.nodes.iter_mut().filter(|node| node.count > 0) {
            leaf.first = first(leaf)?;
        }
        Some(tree)
    };
    let is_sound =
        |tree: Option<BvhBuildAnswer>| tree.is_some_and(|tree| tree_cost(q, &tree).is_ok());
    let place = |shape: u32| tree.order.iter().position(|other| *other == shape);
    let behind = is_sound(begun(&|leaf| leaf.first.checked_sub(leaf.count)));
    let late = is_sound(begun(&|leaf| leaf.first.checked_sub(1)));
    let why = if is_sound(by_rows(tree)) {
        "the nodes stand row by row, and each branch has the number after its own, and not that of its first child"
    } else if is_sound(begun(&|leaf| Some(place(leaf.first)? as u32))) {
        "each leaf has the number of its first box for its `first`, and not that box's place in the order"
    } else if behind && late {
        "each leaf begins behind its last box, one place too late"
    } else if behind {
        "each leaf begins behind its last box in the order"
    } else if late {
        "each leaf begins one place too late in the order"
    } else if is_sound(Some(BvhBuildAnswer {
        order: places(&tree.order),
        ..tree.clone()
    })) {
        "the order tells the place of each box, and not which box is at each place"
    } else {
        return None;
    };
    Some(why.to_owned())
}

/// A tree in which each branch has the number after its own for its first child: the same with the numbers that these have row by row.
/// None of other trees.
fn by_rows(tree: &BvhBuildAnswer) -> Option<BvhBuildAnswer> {
    let mut tree = tree.clone();
    let branches = tree.nodes.iter_mut().enumerate();
    let branches = branches.filter(|(_, node)| node.count == 0);
    for ((own, node), first) in branches.zip((1..).step_by(2)) {
        (node.first as usize == own + 1).then(|| node.first = first)?;
    }
    Some(tree)
}

/// The place of each number in a list; the place behind the last for a number that is not in the list.
pub(super) fn places(order: &[u32]) -> Vec<u32> {
    let mut places = vec![order.len() as u32; order.len()];
    for (place, &shape) in order.iter().enumerate() {
        if let Some(of_shape) = places.get_mut(shape as usize) {
            *of_shape = place as u32;
        }
    }
    places
}

/// The first choice in a tree that costs more than it need: of a leaf, or of a cut.
pub(super) fn wrong_choice(q: &BvhBuild, tree: &BvhBuildAnswer) -> Option<String> {
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

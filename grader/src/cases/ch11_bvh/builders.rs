//! Trees of boxes by other rules than the surface-area heuristic: what mistaken builders make.

use super::{area, around, center};
use crate::Graded;
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

/// Two sides of a node's boxes, and what they are said to cost.
pub(super) struct Cut {
    sides: [Vec<u32>; 2],
    cost: f32,
}

/// A rule by which at least two boxes are cut in two, as many cuts below the root as it is told.
pub(super) type Cutting = fn(&BvhBuild, &[u32], usize) -> Cut;

/// The cheapest cut of all.
pub(super) const ALL_CUTS: Cutting = |q, which, _| cheapest(q, which, 0..3, Side::by_area);

/// The cut whose sides have the least areas, however many boxes are in them.
pub(super) const WITHOUT_NUMBERS: Cutting = |q, which, _| cheapest(q, which, 0..3, Side::area);

/// The cut whose sides have the least volumes, times their numbers of boxes.
pub(super) const BY_VOLUMES: Cutting = |q, which, _| {
    cheapest(q, which, 0..3, |side| {
        side.around.size().element_product() * side.count
    })
};

/// The cut whose sides have the least sums of extents, times their numbers of boxes.
pub(super) const BY_EXTENTS: Cutting = |q, which, _| {
    cheapest(q, which, 0..3, |side| {
        side.around.size().element_sum() * side.count
    })
};

/// The cheapest cut, if the right side had what the left one lacks of the area of the node's box.
pub(super) const WHOLE_LESS_LEFT: Cutting = |q, which, _| {
    swept(q, rows(q, which, 0..3), |left, right| {
        let rest = left.with(right).area() - left.area();
        left.by_area() + rest * right.count
    })
};

/// The cut in the middle of the row, along x, y and z in turn from level to level.
pub(super) const IN_TURN: Cutting = |q, which, depth| middle(q, which, depth % 3);

/// Halves by number along x, where the cheapest cut says whether to cut at all.
pub(super) const HALVES_ALONG_X: Cutting = |q, which, depth| Cut {
    cost: ALL_CUTS(q, which, depth).cost,
    ..middle(q, which, 0)
};

/// The same along the axis along which the node's box is longest.
pub(super) const HALVES_ALONG_THE_LONGEST: Cutting = |q, which, depth| Cut {
    cost: ALL_CUTS(q, which, depth).cost,
    ..middle(q, which, longest(&around(&q.boxes, which)))
};

/// The cheapest cut along x.
pub(super) const ALONG_X: Cutting = |q, which, _| cheapest(q, which, [0], Side::by_area);

/// The cheapest cut along z.
pub(super) const ALONG_Z: Cutting = |q, which, _| cheapest(q, which, [2], Side::by_area);

/// The cheapest cut along the axis along which the node's box is longest.
pub(super) const ALONG_THE_LONGEST: Cutting =
    |q, which, _| cheapest(q, which, [longest(&around(&q.boxes, which))], Side::by_area);

/// The cut at the middle of the node's box.
pub(super) const AT_THE_MIDDLE: Cutting = |q, which, _| halved(q, which, &around(&q.boxes, which));

/// The cut at the middle of the box around the centres.
pub(super) const AT_THE_CENTERS_MIDDLE: Cutting = |q, which, _| {
    let centers = which.iter().map(|&i| center(&q.boxes[i as usize]));
    halved(q, which, &Aabb::of(centers))
};

/// The cut at the widest gap between two neighbouring centres, along all axes.
pub(super) const AT_THE_WIDEST_GAP: Cutting = |q, which, _| widest(q, which, 0..3, gaps);

/// The cut at the widest gap between two neighbouring centres, along the axis along which the node's box is longest.
pub(super) const AT_THE_WIDEST_GAP_ALONG_THE_LONGEST: Cutting = |q, which, _| {
    let axis = longest(&around(&q.boxes, which));
    widest(q, which, [axis], gaps)
};

/// The cut at the widest space between the boxes of one side and those of the other.
pub(super) const AT_THE_WIDEST_SPACE: Cutting = |q, which, _| widest(q, which, 0..3, spaces);

/// The cheapest cut, if a cut cost as much as its dearer side.
pub(super) const BY_THE_DEARER_SIDE: Cutting = |q, which, _| {
    swept(q, rows(q, which, 0..3), |left, right| {
        left.by_area().max(right.by_area())
    })
};

/// The cheapest cut of the row as it is stored.
pub(super) const UNSORTED: Cutting = |q, which, _| swept(q, [which.to_vec()], by_areas);

/// The dearest cut of all.
pub(super) const DEAREST: Cutting = |q, which, _| {
    let cut = swept(q, rows(q, which, 0..3), |left, right| {
        -by_areas(left, right)
    });
    Cut {
        cost: -cut.cost,
        ..cut
    }
};

/// The number of boxes and the cost of the cheapest cut, with the boxes in their order along z.
pub(super) const IN_THE_LAST_ROW: Cutting = |q, which, depth| {
    let Cut { sides, cost } = ALL_CUTS(q, which, depth);
    let row = sorted(q, which, 2);
    let (left, right) = row.split_at(sides[0].len());
    Cut {
        sides: [left.to_vec(), right.to_vec()],
        cost,
    }
};

/// When boxes that could be a leaf, or be cut like this, become a leaf.
pub(super) type Leaf = fn(&BvhBuild, &[u32], &Cut) -> bool;

/// A leaf as soon as the boxes fit in.
pub(super) const FITS: Leaf = |_, _, _| true;

/// A leaf where it costs no more than the branch and the cut.
pub(super) const CHEAPER: Leaf = |q, which, cut| {
    let own = area_around(q, which);
    own + cut.cost >= own * which.len() as f32
};

/// A leaf where it costs no more than the cut, as if the branch cost nothing.
pub(super) const CHEAPER_THAN_THE_CUT: Leaf =
    |q, which, cut| cut.cost >= area_around(q, which) * which.len() as f32;

/// A leaf where it has no more boxes than the branch and the cut cost, whose areas are not divided by the node's.
pub(super) const ABSOLUTE: Leaf = |_, which, cut| 1.0 + cut.cost >= which.len() as f32;

/// A leaf where it costs no more than the cut and a branch of price 2.
pub(super) const CHEAPER_THAN_TWO: Leaf = |q, which, cut| {
    let own = area_around(q, which);
    2.0 * own + cut.cost >= own * which.len() as f32
};

/// A leaf where it costs no more than the branch and the cut, if areas are divided by the root's.
pub(super) const CHEAPER_BY_THE_ROOT: Leaf = |q, which, cut| {
    let all: Vec<_> = (0..q.boxes.len() as u32).collect();
    let root = area_around(q, &all);
    root + cut.cost >= root * which.len() as f32
};

/// A leaf of a single box only.
pub(super) const SINGLE: Leaf = |_, which, _| which.len() == 1;

/// The tree by these rules.
pub(super) fn built(q: &BvhBuild, cutting: Cutting, leaf: Leaf) -> BvhBuildAnswer {
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
    let mut open = vec![(0, all, 0)];
    while let Some((at, which, depth)) = open.pop() {
        let fits = which.len() <= q.most.max(1) as usize;
        let cut = (which.len() > 1).then(|| cutting(q, &which, depth));
        let cut = cut.filter(|cut| !(fits && leaf(q, &which, cut)));
        let Some(cut) = cut else {
            tree.nodes[at].first = tree.order.len() as u32;
            tree.nodes[at].count = which.len() as u32;
            tree.order.extend(which);
            continue;
        };
        tree.nodes[at].first = tree.nodes.len() as u32;
        for side in cut.sides {
            open.push((tree.nodes.len(), side.clone(), depth + 1));
            tree.nodes.push(node(&side));
        }
    }
    tree
}

/// The right tree, but for where its leaves begin.
pub(super) fn with_first(q: &BvhBuild, first: fn(first: u32, count: u32) -> u32) -> BvhBuildAnswer {
    let mut tree = BvhBuild::right(q);
    for leaf in tree.nodes.iter_mut().filter(|node| node.count > 0) {
        leaf.first = first(leaf.first, leaf.count);
    }
    tree
}

/// The right tree with its nodes row by row, each branch with the number after its own for that of its first child.
pub(super) fn with_numbers_after_own(q: &BvhBuild) -> BvhBuildAnswer {
    let mut tree = BvhBuild::canonical(q, BvhBuild::right(q));
    for (own, node) in (0..).zip(&mut tree.nodes) {
        // The root of nothing is no branch, although it has no boxes.
        if node.count == 0 && !tree.order.is_empty() {
            node.first = own + 1;
        }
    }
    tree
}

/// The same tree with its nodes depth first, each branch with the number of its first child, 0, or of its second, 1.
pub(super) fn depth_first(tree: &BvhBuildAnswer, child: usize) -> BvhBuildAnswer {
    let mut made = BvhBuildAnswer {
        nodes: Vec::new(),
        order: Vec::new(),
    };
    // The root of nothing is no branch, although it has no boxes.
    if !tree.order.is_empty() {
        append(tree, 0, child, &mut made);
    }
    made
}

/// Appends a node and all below it.
fn append(tree: &BvhBuildAnswer, node: usize, child: usize, made: &mut BvhBuildAnswer) {
    let row = &tree.nodes[node];
    let (first, count) = (row.first as usize, row.count as usize);
    let own = made.nodes.len();
    made.nodes.push(row.clone());
    if count > 0 {
        made.nodes[own].first = made.order.len() as u32;
        made.order.extend(&tree.order[first..first + count]);
        return;
    }
    for below in 0..2 {
        if below == child {
            made.nodes[own].first = made.nodes.len() as u32;
        }
        append(tree, first + below, child, made);
    }
}

/// The area of the box around some boxes.
fn area_around(q: &BvhBuild, which: &[u32]) -> f32 {
    let Aabb { min, max } = around(&q.boxes, which);
    area(min, max)
}

/// A side of a cut: the box around its boxes, and how many these are.
#[derive(Clone, Copy)]
struct Side {
    around: Aabb,
    count: f32,
}

impl Side {
    fn area(&self) -> f32 {
        area(self.around.min, self.around.max)
    }

    /// What it costs by the surface-area heuristic.
    fn by_area(&self) -> f32 {
        self.area() * self.count
    }

    /// Both sides as one.
    fn with(&self, other: &Side) -> Side {
        Side {
            around: self.around.union(&other.around),
            count: self.count + other.count,
        }
    }
}

/// What a cut costs by the surface-area heuristic.
fn by_areas(left: &Side, right: &Side) -> f32 {
    left.by_area() + right.by_area()
}

/// The boxes in the order of their centres along an axis.
fn sorted(q: &BvhBuild, which: &[u32], axis: usize) -> Vec<u32> {
    let mut sorted = which.to_vec();
    let place = |&i: &u32| center(&q.boxes[i as usize])[axis];
    sorted.sort_by(|a, b| place(a).total_cmp(&place(b)));
    sorted
}

/// The cheapest of all cuts between the sorted centres along some axes, if a side costs this.
fn cheapest(
    q: &BvhBuild,
    which: &[u32],
    axes: impl IntoIterator<Item = usize>,
    price: fn(&Side) -> f32,
) -> Cut {
    swept(q, rows(q, which, axes), |left, right| {
        price(left) + price(right)
    })
}

/// The rows of the boxes by their centres along some axes.
fn rows(
    q: &BvhBuild,
    which: &[u32],
    axes: impl IntoIterator<Item = usize>,
) -> impl Iterator<Item = Vec<u32>> {
    axes.into_iter().map(move |axis| sorted(q, which, axis))
}

/// The cut of these rows with the least price. It is found in one sweep of each row: some rules make as many branches as there are
/// boxes, and look at all boxes below in each.
fn swept(
    q: &BvhBuild,
    rows: impl IntoIterator<Item = Vec<u32>>,
    price: impl Fn(&Side, &Side) -> f32,
) -> Cut {
    let mut best: Option<(f32, usize, Vec<u32>)> = None;
    for row in rows {
        let left = growing(q, row.iter());
        let mut right = growing(q, row.iter().rev());
        right.reverse();
        let mut cheaper = None;
        for at in 1..row.len() {
            let cost = price(&left[at - 1], &right[at]);
            let least = cheaper.map(|(cost, _)| cost);
            let least = least.or(best.as_ref().map(|best| best.0));
            if least.is_none_or(|least| cost < least) {
                cheaper = Some((cost, at));
            }
        }
        if let Some((cost, at)) = cheaper {
            best = Some((cost, at, row));
        }
    }
    let (cost, at, row) = best.expect("a row of at least two boxes has a cut");
    let (left, right) = row.split_at(at);
    Cut {
        sides: [left.to_vec(), right.to_vec()],
        cost,
    }
}

/// The first box of a row as a side, the first two together, and so on.
fn growing<'a>(q: &BvhBuild, row: impl Iterator<Item = &'a u32>) -> Vec<Side> {
    let mut around = Aabb::EMPTY;
    let grown = row.zip(1..).map(|(&i, count)| {
        around = around.union(&Aabb::from(&q.boxes[i as usize]));
        Side {
            around,
            count: count as f32,
        }
    });
    grown.collect()
}

/// The cut at the widest gap of the rows along these axes, where the gaps of a row are measured like this.
fn widest(
    q: &BvhBuild,
    which: &[u32],
    axes: impl IntoIterator<Item = usize>,
    gaps: fn(&BvhBuild, &[u32], usize) -> Vec<f32>,
) -> Cut {
    let mut best: Option<(f32, usize, usize)> = None;
    for axis in axes {
        let gaps = gaps(q, &sorted(q, which, axis), axis);
        for (at, gap) in (1..).zip(gaps) {
            if best.is_none_or(|(widest, ..)| gap > widest) {
                best = Some((gap, at, axis));
            }
        }
    }
    let (_, at, axis) = best.expect("a row of at least two boxes has a gap");
    sides(q, sorted(q, which, axis).split_at(at))
}

/// The gaps between neighbouring centres of a row along an axis.
fn gaps(q: &BvhBuild, row: &[u32], axis: usize) -> Vec<f32> {
    let place = |i: u32| center(&q.boxes[i as usize])[axis];
    let gaps = row.windows(2).map(|two| place(two[1]) - place(two[0]));
    gaps.collect()
}

/// The spaces between the boxes before each place of a row along an axis, and those behind it; below 0 where these overlap.
fn spaces(q: &BvhBuild, row: &[u32], axis: usize) -> Vec<f32> {
    let ends = row.iter().scan(f32::NEG_INFINITY, |end, &i| {
        *end = end.max(q.boxes[i as usize].max[axis]);
        Some(*end)
    });
    let begins = row.iter().rev().scan(f32::INFINITY, |begin, &i| {
        *begin = begin.min(q.boxes[i as usize].min[axis]);
        Some(*begin)
    });
    let mut begins: Vec<_> = begins.collect();
    begins.reverse();
    let behind = begins.into_iter().skip(1);
    behind.zip(ends).map(|(begin, end)| begin - end).collect()
}

/// A cut in the middle of the row, along an axis.
fn middle(q: &BvhBuild, which: &[u32], axis: usize) -> Cut {
    let sorted = sorted(q, which, axis);
    sides(q, sorted.split_at(sorted.len() / 2))
}

fn sides(q: &BvhBuild, (left, right): (&[u32], &[u32])) -> Cut {
    Cut {
        cost: area_around(q, left) * left.len() as f32 + area_around(q, right) * right.len() as f32,
        sides: [left.to_vec(), right.to_vec()],
    }
}

/// The axis along which a box is longest.
fn longest(bounds: &Aabb) -> usize {
    bounds.size().max_position()
}

/// A cut at the middle of a box along its longest axis: of the boxes, those with a smaller centre are on the left. The middle of
/// the row where a side would be empty.
fn halved(q: &BvhBuild, which: &[u32], bounds: &Aabb) -> Cut {
    let axis = longest(bounds);
    let sorted = sorted(q, which, axis);
    let is_left = |i: &u32| center(&q.boxes[*i as usize])[axis] < bounds.center()[axis];
    match sorted.partition_point(is_left) {
        left if left == 0 || left == sorted.len() => middle(q, which, axis),
        left => sides(q, sorted.split_at(left)),
    }
}

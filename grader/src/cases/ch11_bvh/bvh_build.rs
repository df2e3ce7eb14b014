//! `bvh_build`: random questions, judge and mistakes.

use super::builders::{
    along_the_longest, area_around, around_centers, built, by_all_cuts, dearest, depth_first, gaps,
    halved, longest, of_full_leaves, only, spaces, with_boxes, with_first, with_numbers_after_own,
};
use super::bvh_tree::{apart, misplaced, places, tree_cost, wrong_choice};
use super::sah_cost::node_area;
use super::{around, center, crowd, cube, heaps, no_dearer};
use crate::{Flaw, Graded, Mistake, Relation, Verdict, judge, sample, traits};
use rand::RngExt;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch11_bvh::{BvhBuild, BvhBuildAnswer};
use raybook_workbook::tree_rows::NodeRow;
use std::cmp::Ordering;

/// Of fewer boxes than these a tree may be dearer by chance.
const FEW: usize = 100;

/// What a function does whose nodes stand depth first, whatever tree they make.
const SECOND_CHILD: &str =
    "numbers the nodes depth first, and gives a branch the number of its second child";

/// The same, if a branch has the number of its other child.
const FIRST_CHILD: &str = "numbers the nodes depth first, so that a branch's second child comes after all below its first";

/// What a function does whose nodes stand row by row, and which takes them for depth first, whatever tree they make.
const NUMBER_AFTER_OWN: &str = "gives a branch the number after its own for that of its first child, which stands farther back in the list";

/// What a function does whose leaves begin at the number of a box, whatever tree they make.
const NUMBER_OF_A_BOX: &str =
    "writes the number of a leaf's first box where its place in the order belongs";

/// The same, if leaves begin where they end.
const END_OF_A_LEAF: &str = "takes the end of a leaf's part of the order for its beginning";

/// The same, if leaves begin one place too late.
const FROM_1: &str = "counts the places of the order from 1";

/// The same, if the order is the other way round.
const PLACES: &str = "writes the place of each box into the order, not the box at each place";

/// Whether an answer is a tree, or would be one if its nodes had other boxes.
fn is_tree_but_for_boxes(q: &BvhBuild, tree: &BvhBuildAnswer) -> bool {
    if tree_cost(q, tree).is_ok() {
        return true;
    }
    let around_all = |q: &BvhBuild, which: &[u32]| {
        let is_box = |i: &&u32| (**i as usize) < q.boxes.len();
        let which: Vec<_> = which.iter().filter(is_box).copied().collect();
        around(&q.boxes, &which)
    };
    let mended = with_boxes(q, tree.clone(), around_all);
    let is_misplaced = || apart(&tree.nodes).is_some() || misplaced(q, tree).is_some();
    tree_cost(q, &mended).is_ok() && !is_misplaced()
}

/// How much more than the reference's the tree of this number of boxes may cost: neither is the best, and the fewer boxes there
/// are, the more does it matter which cut is taken first. Cuts at one of eight places, or along the longest axis only, cost up to
/// 12 % more among a hundred boxes and up to 5 % among a thousand; areas without one of three sides 20 to 35 % there, halves by
/// number 50 %.
fn dearer(boxes: usize) -> f32 {
    match boxes {
        0..FEW => 0.25,
        FEW..1000 => 0.15,
        _ => 0.08,
    }
}

impl Graded for BvhBuild {
    fn random(rng: &mut Pcg) -> BvhBuild {
        // Of a small scene an area is less than a number of boxes, of a large one more.
        let scale = if rng.random_bool(0.3) { 0.05 } else { 1.0 };
        let mut boxes = heaps(rng);
        for b in &mut boxes {
            (b.min, b.max) = (scale * b.min, scale * b.max);
        }
        BvhBuild { most: 4, boxes }
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
        let cost = tree_cost(q, got).map_err(|why| {
            let known = apart(&got.nodes).or_else(|| misplaced(q, got));
            known.unwrap_or(why)
        })?;
        let least = tree_cost(q, golden)?;
        let is_dearer = no_dearer("the tree", cost, least, dearer(q.boxes.len()));
        is_dearer.or_else(|why| {
            // The cheapest cut of every node may make a dearer tree than the reference's, of few boxes only.
            if q.boxes.len() < FEW {
                let by_all_cuts = tree_cost(q, &by_all_cuts(q))?;
                if cost <= by_all_cuts * (1.0 + judge::RELATIVE) {
                    return Ok(());
                }
            }
            Err(match wrong_choice(q, got) {
                Some(choice) => format!("{why}: {choice}"),
                None => why,
            })
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

    /// The nodes by levels, the child with the lower corner first, and each leaf's boxes by number, where it is a tree, whatever the nodes' own
    /// boxes are.
    fn canonical(q: &BvhBuild, tree: BvhBuildAnswer) -> BvhBuildAnswer {
        if tree.nodes.is_empty() || !is_tree_but_for_boxes(q, &tree) {
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

    const EFFORT: usize = 10;

    const ALLOWS: &'static str = "The tree may cost 25 % more than the reference's: 15 % more from 100 boxes on, and 8 % from 1000 on. Boxes may stand in any order within a leaf.";

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
            complaint: "the number of its second child",
            name: SECOND_CHILD,
            hint: "A search finds both children of a branch at its `first`, side by side: which two nodes stand there in your list?",
        },
        Flaw {
            complaint: "the number of its first child",
            name: FIRST_CHILD,
            hint: "The two children of a branch stand side by side: how long is the list of nodes when you append the second of them, if the first is a branch?",
        },
        Flaw {
            complaint: "the number after its own",
            name: NUMBER_AFTER_OWN,
            hint: "How long is the list of nodes at the moment when a branch's first child is appended? Is that the branch's own number plus 1?",
        },
        Flaw {
            complaint: "the number of its first box",
            name: NUMBER_OF_A_BOX,
            hint: "A leaf's boxes stand side by side in the order: does `first` say where there, or which box of the question it is?",
        },
        Flaw {
            complaint: "behind its last box in the order",
            name: END_OF_A_LEAF,
            hint: "How long is the order before a leaf's boxes are appended, and how long after that? Which of the two is `first`?",
        },
        Flaw {
            complaint: "one place too late in the order",
            name: FROM_1,
            hint: "What is the number of the first place in a list?",
        },
        Flaw {
            complaint: "the order tells the place of each box",
            name: PLACES,
            hint: "A leaf begins at place 3 of the order: what must stand there, the number of a box, or the place of box 3?",
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
            hint: "One box lies far away from nine others: should any of the nine share a side with it?",
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

    const RELATIONS: &'static [Relation<Self>] = &[Relation::moved(|q| BvhBuild {
        boxes: q.boxes.iter().map(sample::moved_box).collect(),
        ..q.clone()
    })];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "cuts into halves by the number of boxes along x, and asks the cheapest cut only whether to cut at all",
            hint: "You have found the cheapest cut: on which side of it is each box, and on which side do you put it?",
            answer: |q| built(q, |how| how.place = |_, which, _| (0, which.len() / 2)),
        },
        Mistake {
            name: "cuts into halves by the number of boxes along the longest axis, and asks the cheapest cut only whether to cut at all",
            hint: "You have found the cheapest cut: on which side of it is each box, and on which side do you put it?",
            answer: |q| {
                built(q, |how| {
                    how.place =
                        |q, which, _| (along_the_longest(q, which, 0).start, which.len() / 2);
                })
            },
        },
        Mistake {
            name: "cuts every node into halves by the number of boxes",
            hint: "One box lies far away from nine others: should any of the nine share a side with it?",
            answer: |q| {
                of_full_leaves(q, |how| {
                    how.axes = |q, which, _| longest(&around_centers(q, which));
                    how.ranks = |row| only(row, row.order.len() / 2);
                    how.fits = |count, most| 2 * count <= most;
                })
            },
        },
        Mistake {
            name: "cuts into halves by the number of boxes along the longest axis of a node's box, and tries no other cut",
            hint: "One box lies far away from nine others: should any of the nine share a side with it?",
            answer: |q| {
                built(q, |how| {
                    how.axes = along_the_longest;
                    how.ranks = |row| only(row, row.order.len() / 2);
                })
            },
        },
        Mistake {
            name: "cuts into halves by the number of boxes along the longest axis of a node's box, and makes a leaf of all that it can hold",
            hint: "One box lies far away from nine others: should any of the nine share a side with it? And is a leaf always cheaper than a cut?",
            answer: |q| {
                of_full_leaves(q, |how| {
                    how.axes = along_the_longest;
                    how.ranks = |row| only(row, row.order.len() / 2);
                })
            },
        },
        Mistake {
            name: "cuts off one box at a time",
            hint: "How many boxes does a ray test in a tree that is one long branch?",
            answer: |q| {
                built(q, |how| {
                    how.is_sorted = false;
                    how.axes = |_, _, _| 0..1;
                    how.ranks = |row| only(row, 1);
                    how.is_leaf = |_| false;
                })
            },
        },
        Mistake {
            name: "makes one leaf of all",
            hint: "A tree of one leaf is a list: what does a search in it cost?",
            answer: |q| of_full_leaves(q, |how| how.fits = |_, _| true),
        },
        Mistake {
            name: "gives every node the box of all",
            hint: "Which rays can be turned away at a box that is as large as the scene?",
            answer: |q| {
                let mut tree = BvhBuild::right(q);
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
                let mut tree = BvhBuild::right(q);
                tree.order.pop();
                tree
            },
        },
        Mistake {
            name: "lets every leaf begin at the start of the order",
            hint: "Where does the second leaf begin in the order?",
            answer: |q| with_first(q, |_, _| 0),
        },
        Mistake {
            name: NUMBER_OF_A_BOX,
            hint: "A leaf's boxes stand side by side in the order: does `first` say where there, or which box of the question it is?",
            answer: |q| {
                let BvhBuildAnswer { mut nodes, order } = BvhBuild::right(q);
                for node in nodes.iter_mut().filter(|n| n.count > 0) {
                    node.first = *order.get(node.first as usize).unwrap_or(&node.first);
                }
                BvhBuildAnswer { nodes, order }
            },
        },
        Mistake {
            name: "makes a leaf of all that a leaf can hold, without asking whether a cut is cheaper",
            hint: "A leaf of four costs four tests wherever the ray is in it: what would two leaves of two cost, and how often would each be opened?",
            answer: |q| built(q, |how| how.is_leaf = |_| true),
        },
        Mistake {
            name: "forgets the cost of opening a branch",
            hint: "Is a branch free for a ray that enters it?",
            answer: |q| built(q, |how| how.opening = 0.0),
        },
        Mistake {
            name: "does not divide the cost of a cut by the area of the node's box",
            hint: "Of a scene measured in millimetres, an area is a million times as large as in metres: do you make the same tree of it?",
            answer: |q| built(q, |how| how.own = |_, _| 1.0),
        },
        Mistake {
            name: "makes leaves of single boxes only",
            hint: "Two boxes that lie in the same place: what does a ray gain if they are in two leaves?",
            answer: |q| built(q, |how| how.is_leaf = |_| false),
        },
        Mistake {
            name: "leaves the numbers of boxes out of the cost of a cut",
            hint: "A ray that enters a side tests what is in it: does a side of nine boxes cost as much as a side of one?",
            answer: |q| built(q, |how| how.count = |_| 1.0),
        },
        Mistake {
            name: "leaves the numbers of boxes out of the cost of a cut, and makes a leaf of all that it can hold",
            hint: "A ray that enters a side tests what is in it: does a side of nine boxes cost as much as a side of one?",
            answer: |q| of_full_leaves(q, |how| how.count = |_| 1.0),
        },
        Mistake {
            name: "weighs the sides of a cut by their volume",
            hint: "A flat box has no volume: do rays enter it?",
            answer: |q| built(q, |how| how.size = |around| around.size().element_product()),
        },
        Mistake {
            name: "weighs the sides of a cut by their volume, and makes a leaf of all that it can hold",
            hint: "A flat box has no volume: do rays enter it?",
            answer: |q| {
                of_full_leaves(q, |how| how.size = |around| around.size().element_product())
            },
        },
        Mistake {
            name: "adds the extents of a side's box for its area",
            hint: "In which unit is an area, and in which is your sum?",
            answer: |q| built(q, |how| how.size = |around| around.size().element_sum()),
        },
        Mistake {
            name: "tries cuts along x only",
            hint: "Two rows of boxes, one above the other: along which axis would you cut, and do you try it?",
            answer: |q| built(q, |how| how.axes = |_, _, _| 0..1),
        },
        Mistake {
            name: "tries cuts along x and y only",
            hint: "Two rows of boxes, one behind the other: along which axis would you cut, and do you try it?",
            answer: |q| built(q, |how| how.axes = |_, _, _| 0..2),
        },
        Mistake {
            name: "gives a branch the number of the second of its two children, which stand side by side",
            hint: "Both children stand side by side: which of them stands at the place that you name?",
            answer: |q| {
                built(q, |how| {
                    how.numbered = |mut tree| {
                        let is_branch = |node: &&mut NodeRow| node.count == 0;
                        let some = !tree.order.is_empty();
                        for branch in tree.nodes.iter_mut().filter(is_branch).filter(|_| some) {
                            branch.first += 1;
                        }
                        tree
                    };
                })
            },
        },
        Mistake {
            name: "tries cuts along x only, and makes a leaf of all that it can hold",
            hint: "Two rows of boxes, one above the other: along which axis would you cut, and do you try it?",
            answer: |q| of_full_leaves(q, |how| how.axes = |_, _, _| 0..1),
        },
        Mistake {
            name: "tries cuts along z only, or forgets the best along x and y",
            hint: "You keep the best cut while you try the places along an axis: what becomes of it when you go on to the next axis?",
            answer: |q| built(q, |how| how.axes = |_, _, _| 2..3),
        },
        Mistake {
            name: "tries cuts along z only, or forgets the best along x and y, and makes a leaf of all that it can hold",
            hint: "You keep the best cut while you try the places along an axis: what becomes of it when you go on to the next axis?",
            answer: |q| of_full_leaves(q, |how| how.axes = |_, _, _| 2..3),
        },
        Mistake {
            name: "tries cuts along the longest axis of a node's box only",
            hint: "Nine boxes lie side by side along x, and one far above them: must the best cut be along x?",
            answer: |q| built(q, |how| how.axes = along_the_longest),
        },
        Mistake {
            name: "tries cuts along the longest axis of a node's box only, and makes a leaf of all that it can hold",
            hint: "Nine boxes lie side by side along x, and one far above them: must the best cut be along x?",
            answer: |q| of_full_leaves(q, |how| how.axes = along_the_longest),
        },
        Mistake {
            name: "cuts at the middle of a node's box along its longest axis",
            hint: "One box lies far away from nine others: how many cuts does it take until a cut at the middle parts the nine?",
            answer: |q| {
                built(q, |how| {
                    how.axes = along_the_longest;
                    how.ranks = |row| halved(row, &around(&row.q.boxes, &row.order));
                })
            },
        },
        Mistake {
            name: "cuts at the middle of a node's box along its longest axis, and makes a leaf of all that it can hold",
            hint: "One box lies far away from nine others: how many cuts does it take until a cut at the middle parts the nine?",
            answer: |q| {
                of_full_leaves(q, |how| {
                    how.axes = along_the_longest;
                    how.ranks = |row| halved(row, &around(&row.q.boxes, &row.order));
                })
            },
        },
        Mistake {
            name: "cuts at the middle of the boxes' centres along their longest axis, and makes a leaf of all that it can hold",
            hint: "One box lies far away from nine others: how many cuts does it take until a cut at the middle parts the nine?",
            answer: |q| {
                of_full_leaves(q, |how| {
                    how.axes = |q, which, _| longest(&around_centers(q, which));
                    how.ranks = |row| halved(row, &around_centers(row.q, &row.order));
                })
            },
        },
        Mistake {
            name: "makes a node's box around the centres of its boxes",
            hint: "A shape reaches beyond its centre: which node finds the part outside the box?",
            answer: |q| {
                let points = q.boxes.iter().map(|row| cube(center(row), 0.0)).collect();
                Self::misread(q, |q| q.boxes = points)
            },
        },
        Mistake {
            name: "makes a node's box around the centres of its boxes, and cuts by the boxes themselves",
            hint: "A shape reaches beyond its centre: which node finds the part outside the box?",
            answer: |q| with_boxes(q, Self::right(q), around_centers),
        },
        Mistake {
            name: "divides the cost of a cut by the area of the root's box, not by that of the node's",
            hint: "A ray is already in the node's box: with what probability does it meet a side of the cut then?",
            answer: |q| {
                built(q, |how| {
                    how.own = |q, _| {
                        let all: Vec<_> = (0..q.boxes.len() as u32).collect();
                        area_around(q, &all)
                    };
                })
            },
        },
        Mistake {
            name: "lets a branch cost two tests, one for each child's box",
            hint: "What does the task say that opening a branch costs?",
            answer: |q| built(q, |how| how.opening = 2.0),
        },
        Mistake {
            name: "lets a leaf hold one box less than it may",
            hint: "How many boxes are in a leaf that is just full: is your comparison < or ≤?",
            answer: |q| Self::misread(q, |q| q.most = q.most.saturating_sub(1).max(1)),
        },
        Mistake {
            name: "takes the whole area less the left side's for that of the right side",
            hint: "Two boxes around the two halves of a cube: do their areas come to that of the cube?",
            answer: |q| {
                built(q, |how| {
                    how.right = |left, right, size| size(&left.union(right)) - size(left);
                })
            },
        },
        Mistake {
            name: "cuts the row in the middle, along x, y and z in turn, and makes a leaf of all that it can hold",
            hint: "One box lies far away from nine others: what does your rule know of areas?",
            answer: |q| {
                of_full_leaves(q, |how| {
                    how.axes = |_, _, depth| depth % 3..depth % 3 + 1;
                    how.ranks = |row| only(row, row.order.len() / 2);
                })
            },
        },
        Mistake {
            name: SECOND_CHILD,
            hint: "A search finds both children of a branch at its `first`, side by side: which two nodes stand there in your list?",
            answer: |q| built(q, |how| how.numbered = |tree| depth_first(&tree, 1)),
        },
        Mistake {
            name: NUMBER_AFTER_OWN,
            hint: "How long is the list of nodes at the moment when a branch's first child is appended? Is that the branch's own number plus 1?",
            answer: with_numbers_after_own,
        },
        Mistake {
            name: FIRST_CHILD,
            hint: "The two children of a branch stand side by side: how long is the list of nodes when you append the second of them, if the first is a branch?",
            answer: |q| built(q, |how| how.numbered = |tree| depth_first(&tree, 0)),
        },
        Mistake {
            name: END_OF_A_LEAF,
            hint: "How long is the order before a leaf's boxes are appended, and how long after that? Which of the two is `first`?",
            answer: |q| with_first(q, |first, count| first + count),
        },
        Mistake {
            name: FROM_1,
            hint: "What is the number of the first place in a list?",
            answer: |q| with_first(q, |first, _| first + 1),
        },
        Mistake {
            name: PLACES,
            hint: "A leaf begins at place 3 of the order: what must stand there, the number of a box, or the place of box 3?",
            answer: |q| {
                let tree = BvhBuild::right(q);
                BvhBuildAnswer {
                    order: places(&tree.order),
                    ..tree
                }
            },
        },
        Mistake {
            name: "cuts where the gap between two neighbouring centres is widest",
            hint: "Ten boxes are in a row, and only the last lies a little apart: how many boxes are on each side of your cut, and what does it cost?",
            answer: |q| built(q, |how| how.ranks = gaps),
        },
        Mistake {
            name: "cuts where the gap between two neighbouring centres is widest, and makes a leaf of all that it can hold",
            hint: "Ten boxes are in a row, and only the last lies a little apart: how many boxes are on each side of your cut, and what does it cost?",
            answer: |q| of_full_leaves(q, |how| how.ranks = gaps),
        },
        Mistake {
            name: "cuts where the gap between two neighbouring centres is widest, along the longest axis of a node's box only",
            hint: "Ten boxes are in a row, and only the last lies a little apart: how many boxes are on each side of your cut, and what does it cost?",
            answer: |q| built(q, |how| (how.axes, how.ranks) = (along_the_longest, gaps)),
        },
        Mistake {
            name: "cuts where the gap between two neighbouring centres is widest, along the longest axis of a node's box only, and makes a leaf of all that it can hold",
            hint: "Ten boxes are in a row, and only the last lies a little apart: how many boxes are on each side of your cut, and what does it cost?",
            answer: |q| of_full_leaves(q, |how| (how.axes, how.ranks) = (along_the_longest, gaps)),
        },
        Mistake {
            name: "cuts where the empty space between two sides is widest",
            hint: "Ten boxes are in a row, and only the last lies a little apart: how many boxes are on each side of your cut, and what does it cost?",
            answer: |q| built(q, |how| how.ranks = spaces),
        },
        Mistake {
            name: "cuts where the empty space between two sides is widest, and makes a leaf of all that it can hold",
            hint: "Ten boxes are in a row, and only the last lies a little apart: how many boxes are on each side of your cut, and what does it cost?",
            answer: |q| of_full_leaves(q, |how| how.ranks = spaces),
        },
        Mistake {
            name: "takes the cost of the dearer side for that of the cut",
            hint: "A ray may enter both sides of a cut: which of their costs does it pay on average?",
            answer: |q| built(q, |how| how.sum = f32::max),
        },
        Mistake {
            name: "takes the cost of the dearer side for that of the cut, and makes a leaf of all that it can hold",
            hint: "A ray may enter both sides of a cut: which of their costs does it pay on average?",
            answer: |q| of_full_leaves(q, |how| how.sum = f32::max),
        },
        Mistake {
            name: "cuts the boxes in the order in which they are stored, without sorting them",
            hint: "Two heaps of boxes are stored in turn: which cuts of the row part the heaps, as long as nobody sorts it?",
            answer: |q| built(q, |how| how.is_sorted = false),
        },
        Mistake {
            name: "cuts the boxes in the order in which they are stored, without sorting them, and makes a leaf of all that it can hold",
            hint: "Two heaps of boxes are stored in turn: which cuts of the row part the heaps, as long as nobody sorts it?",
            answer: |q| of_full_leaves(q, |how| how.is_sorted = false),
        },
        Mistake {
            name: "takes the dearest cut",
            hint: "Print the costs of all cuts of the root, and that of the cut that you take: which of them is it?",
            answer: |q| built(q, |how| how.ranks = dearest),
        },
        Mistake {
            name: "takes the dearest cut, and makes a leaf of all that it can hold",
            hint: "Print the costs of all cuts of the root, and that of the cut that you take: which of them is it?",
            answer: |q| of_full_leaves(q, |how| how.ranks = dearest),
        },
        Mistake {
            name: "cuts at the best cut's place, but in the row that is sorted along z",
            hint: "After you have tried all three axes: along which of them is your row sorted, and along which was the best cut?",
            answer: |q| built(q, |how| how.place = |_, _, (_, at)| (2, at)),
        },
        Mistake {
            name: "cuts at the best cut's place, but in the row that is sorted along z, and makes a leaf of all that it can hold",
            hint: "After you have tried all three axes: along which of them is your row sorted, and along which was the best cut?",
            answer: |q| of_full_leaves(q, |how| how.place = |_, _, (_, at)| (2, at)),
        },
        Mistake {
            name: "ignores how many boxes a leaf may have",
            hint: "A leaf of ten boxes may be cheaper than any cut: may it stay a leaf, if `most` is four?",
            answer: |q| built(q, |how| how.fits = |_, _| true),
        },
    ];
}

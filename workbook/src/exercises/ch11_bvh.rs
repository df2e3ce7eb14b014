//! Chapter 11: `sah_cost`, `sah_split`, `bvh_build`, `bvh_closest`.

use raybook::accel::bvh::build::Method;
use raybook::inside::bvh::{self, COST, Cost, Item, build, sah_cost, sah_split};
use raybook::accel::{Accel, Tests};
use raybook::math::{aabb::Aabb, interval::Interval, ray::Ray};
use raybook::shape::mesh::Facet;
use crate::exercise::{Asked, Exercise};
use crate::exercises::ch07_mesh::{Corners, MeshHitAnswer};
use crate::row::row;
use crate::tree_rows::{BoxRow, NodeRow, to_flat, to_rows};

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[&SahCost, &SahSplit, &BvhBuild, &BvhClosest];

/// See [`Exercise::TASK`].
pub struct SahCost;

row! {
    /// A tree, and what a search of it pays.
    pub struct SahCostQuestion {
        /// The price of opening a branch.
        pub branch: f32,
        /// The price of testing a shape.
        pub shape: f32,
        /// The root, then pairs of children.
        pub nodes: Vec<NodeRow>,
    }
}

impl Exercise for SahCost {
    type Question = SahCostQuestion;
    type Answer = f32;
    const NAME: &'static str = "sah_cost";
    const ANSWER: &'static str = "cost";
    const TASK: &'static str = "Return the cost of a search by the surface-area heuristic: over all nodes, the area of the node's box by the root's, times the price of opening a branch or of testing all shapes of a leaf.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let tree = to_flat(&q.nodes, 0);
        let cost = Cost {
            branch: q.branch,
            block: q.shape,
            ..COST
        };
        sah_cost(tree.root.as_ref(), &tree.pairs, &cost)
    }
}

/// See [`Exercise::TASK`].
pub struct SahSplit;

row! {
    /// Two boxes or more.
    pub struct SahSplitQuestion {
        /// The shapes' boxes; their numbers count from 0.
        pub boxes: Vec<BoxRow>,
    }
}

impl Exercise for SahSplit {
    type Question = SahSplitQuestion;
    type Answer = Vec<u32>;
    const NAME: &'static str = "sah_split";
    const ANSWER: &'static str = "left";
    const TASK: &'static str = "Reorder the boxes so that the best split is a cut in the list, and return how many are on the left, and the cost: area times number, left plus right, the least of all cuts between neighbouring centres along an axis. The answer is the numbers of the left ones.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let mut items = items(&q.boxes);
        let (left, _) = sah_split(&mut items, &COST);
        items.iter().take(left).map(|item| item.index).collect()
    }
}

fn items(boxes: &[BoxRow]) -> Vec<Item> {
    let boxes = boxes.iter().map(Aabb::from).enumerate();
    boxes.map(|(i, bounds)| Item::new((i, &bounds))).collect()
}

/// See [`Exercise::TASK`].
pub struct BvhBuild;

row! {
    /// Boxes for a tree.
    pub struct BvhBuildQuestion {
        /// A leaf has at most so many shapes.
        pub most: u32,
        /// The shapes' boxes; their numbers count from 0.
        pub boxes: Vec<BoxRow>,
    }
}

row! {
    /// A tree.
    pub struct BvhBuildAnswer {
        /// The root, then pairs of children.
        pub nodes: Vec<NodeRow>,
        /// The numbers of the boxes, in the order of the leaves.
        pub order: Vec<u32>,
    }
}

impl Exercise for BvhBuild {
    type Question = BvhBuildQuestion;
    type Answer = BvhBuildAnswer;
    const NAME: &'static str = "bvh_build";
    const TASK: &'static str = "Build a hierarchy over the boxes from the top down, with a cost by the surface-area heuristic that is as small as you can make it if a branch and a shape cost 1 each.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let boxes: Vec<_> = q.boxes.iter().map(Aabb::from).collect();
        let cost = Cost {
            most: q.most,
            ..COST
        };
        let flat = build(&boxes, Method::Binned, &cost);
        BvhBuildAnswer {
            nodes: to_rows(&flat),
            order: flat.order,
        }
    }
}

/// See [`Exercise::TASK`].
pub struct BvhClosest;

row! {
    /// A ray, the distances that count, and a tree over triangles.
    pub struct BvhClosestQuestion {
        /// The ray.
        pub ray: Ray,
        /// Only t with min < t < max counts.
        pub within: Interval,
        /// The root, then pairs of children.
        pub nodes: Vec<NodeRow>,
        /// In the order of the leaves; their ids count from 0.
        pub triangles: Vec<Corners>,
    }
}

row! {
    /// The nearest triangle, and the work that it took to find it.
    pub struct BvhClosestAnswer {
        /// How many boxes were tested: two for each branch that was opened.
        pub boxes: u32,
        /// How many triangles were tested.
        pub tests: u32,
        /// The hit.
        pub hit: Option<MeshHitAnswer>,
    }
}

impl Exercise for BvhClosest {
    type Question = BvhClosestQuestion;
    type Answer = BvhClosestAnswer;
    const NAME: &'static str = "bvh_closest";
    const TASK: &'static str = "Return the nearest shape of the tree that the ray hits with min < t < max, and that hit, or None; count every box and every shape that you test, and test as few as you can.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let facets = q.triangles.iter().zip(0..).map(|(t, id)| Facet {
            corners: [t.p0, t.p1, t.p2],
            id,
        });
        let tree = to_flat(&q.nodes, q.triangles.len());
        let bvh = bvh::over(tree, facets.collect());
        let mut count = Tests::default();
        let closest = bvh.closest_counted(&q.ray, q.within, &mut count);
        BvhClosestAnswer {
            boxes: count.boxes as u32,
            tests: count.shapes as u32,
            hit: closest.map(|(_, hit)| MeshHitAnswer {
                t: hit.t,
                id: hit.id,
            }),
        }
    }
}

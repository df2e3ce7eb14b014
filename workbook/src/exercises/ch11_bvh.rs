//! Chapter 11: `sah_cost`, `sah_split`, `bvh_build`, `bvh_closest`.

use crate::exercise::exercises;
use crate::exercises::ch07_mesh::{Corners, MeshHitAnswer};
use crate::record::row;
use crate::tree_rows::{BoxRow, NodeRow, to_flat, to_rows};
use raybook::accel::bvh::build::Method;
use raybook::accel::{Accel, Tests};
use raybook::inside::bvh::{self, COST, Cost, Item, build, sah_cost, sah_split};
use raybook::math::{aabb::Aabb, interval::Interval, ray::Ray};
use raybook::shape::mesh::Facet;

exercises! { ($) ch11_bvh
    /// Return the cost of a search by the surface-area heuristic: over all nodes, the area of the node's box
    /// divided by the root's, times the cost of opening a branch or of testing all shapes of a leaf.
    SahCost: sah_cost(
        /// The cost of opening a branch, in any unit.
        branch: f32,
        /// The cost of testing a shape, in the same unit.
        shape: f32,
        /// The tree: the root, then pairs of children.
        nodes: Vec<NodeRow>,
    ) -> (
        /// The cost of a search, in the same unit.
        cost: f32,
    ) {
        let tree = to_flat(&nodes, 0);
        let cost = Cost {
            branch,
            block: shape,
            ..COST
        };
        sah_cost(tree.root.as_ref(), &tree.pairs, &cost)
    }

    /// Sort the boxes by their centres along an axis and cut the row between two neighbours: the cost is the area of
    /// the box around each side times the number of its boxes, left plus right. Return the numbers of the boxes on the
    /// left of the cheapest of all cuts along all three axes.
    ///
    /// In Rust: reorder the boxes so that the best split is a cut in the list, and return how many are on the left, and
    /// the cost.
    SahSplit: sah_split(
        /// The shapes' boxes; their numbers count from 0.
        boxes: Vec<BoxRow>,
    ) -> (
        /// The numbers of the boxes on the left, in any order.
        left: Vec<u32>,
    ) {
        let mut items = items(&boxes);
        let (left, _) = sah_split(&mut items, &COST);
        items.iter().take(left).map(|item| item.index).collect()
    }

    /// Build a bounding volume hierarchy over the boxes from the top down. Its cost by the surface-area heuristic shall
    /// be as small as you can make it, if opening a branch and testing a shape cost 1 each.
    ///
    /// In Rust: `split(items, &Extent::of(items), cost)` puts the items of the left side first, and returns their
    /// number, or None if a leaf costs less; for more than `cost.most` items, `halve` splits them all the same. No
    /// leaf has more than `levels` branches above it.
    BvhBuild: bvh_build(
        /// The maximum number of shapes in a leaf.
        most: u32,
        /// The shapes' boxes; their numbers count from 0.
        boxes: Vec<BoxRow>,
    ) -> (
        /// The tree.
        answer: BvhBuildAnswer,
    ) {
        let boxes: Vec<_> = boxes.iter().map(Aabb::from).collect();
        let cost = Cost {
            most,
            ..COST
        };
        let flat = build(&boxes, Method::Binned, &cost);
        BvhBuildAnswer {
            nodes: to_rows(&flat),
            order: flat.order,
        }
    }

    /// Return the nearest triangle of the tree that the ray hits with min < t < max: its distance and its number. Count
    /// every box and every triangle that you test, and test as few as you can.
    ///
    /// In Rust: `RayPair::new(ray, within, &root.bounds)` asks both boxes of a pair at once, which are two boxes for
    /// `count`; `any` below uses it in the same way. The shapes of `unbounded`, which are in no box, count too.
    BvhClosest: bvh_closest(
        /// The ray.
        ray: Ray,
        /// The distances that count: min < t < max, in metres.
        within: Interval,
        /// The tree: the root, then pairs of children.
        nodes: Vec<NodeRow>,
        /// The triangles, in the order of the leaves; their ids count from 0.
        triangles: Vec<Corners>,
    ) -> (
        /// The nearest hit, and the work that it took to find it.
        answer: BvhClosestAnswer,
    ) {
        let facets = triangles.iter().zip(0..).map(|(t, id)| Facet {
            corners: [t.p0, t.p1, t.p2],
            id,
        });
        let tree = to_flat(&nodes, triangles.len());
        let bvh = bvh::over(tree, facets.collect());
        let mut count = Tests::default();
        let closest = bvh.closest_counted(&ray, within, &mut count);
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

fn items(boxes: &[BoxRow]) -> Vec<Item> {
    let boxes = boxes.iter().map(Aabb::from).enumerate();
    boxes.map(|(i, bounds)| Item::new((i, &bounds))).collect()
}

row! {
    /// A tree.
    pub struct BvhBuildAnswer {
        /// The nodes: the root, then pairs of children.
        pub nodes: Vec<NodeRow>,
        /// The numbers of the boxes, in the order of the leaves.
        pub order: Vec<u32>,
    }
}

row! {
    /// The nearest triangle, and the work that it took to find it.
    pub struct BvhClosestAnswer {
        /// The number of boxes tested: two for each branch that was opened.
        pub boxes: u32,
        /// The number of triangles tested.
        pub tests: u32,
        /// The nearest hit; none for a miss.
        pub hit: Option<MeshHitAnswer>,
    }
}

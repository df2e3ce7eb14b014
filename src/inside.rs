//! Internals of the library that the course's exercises, figures and tests need: single steps of building and searching, and
//! the structures behind the accelerators.
//!
//! A user of the library does not need this module, and it is not stable: it changes with the internals. No arguments cause
//! undefined behaviour. But functions that get numbers that do not make a tree may panic, never end or overflow the stack.
//!
//! ```
//! use glam::{UVec3, Vec3};
//! use raybook::inside::grid::grid_resolution;
//!
//! // A thousand shapes in a cube, with one cell per shape.
//! assert_eq!(grid_resolution(Vec3::ONE, 1000, 1.0), UVec3::splat(10));
//! ```

pub use crate::accel::ray_box::RayBox;
pub use crate::sample::pattern::neighbours::{Neighbours, Space};

/// Internals of [`Grid`](crate::accel::grid::Grid), and what all grids share.
pub mod grid {
    pub use crate::accel::grid::build::voxels_of_triangle;
    pub use crate::accel::grid::resolution::grid_resolution;
    pub use crate::accel::lattice::{Lattice, range};
    pub use crate::accel::order::by_first_use;
    pub use crate::accel::overlap::triangle_meets_box;
    pub use crate::accel::walk::walk;

    use crate::accel::grid::Grid;
    use crate::shape::Shape;

    /// The lattice of the grid's cells.
    pub fn lattice<S: Shape>(grid: &Grid<S>) -> &Lattice {
        grid.lattice()
    }
}

/// Internals of [`TwoLevelGrid`](crate::accel::two_level_grid::TwoLevelGrid).
pub mod two_level_grid {
    pub use crate::accel::two_level_grid::levels::{Cut, Levels};
    pub use crate::accel::two_level_grid::refine::{Refined, refine_cell};
    pub use crate::accel::two_level_grid::walk::walk_two_levels;

    use crate::accel::two_level_grid::TwoLevelGrid;
    use crate::shape::Shape;

    /// The coarse and the fine cells.
    pub fn levels<S: Shape>(grid: &TwoLevelGrid<S>) -> &Levels {
        grid.levels()
    }
}

/// Internals of [`Octree`](crate::accel::octree::Octree).
pub mod octree {
    pub use crate::accel::octree::tree::{Kind, Node, Place, Tree, child_at, child_cell};
    pub use crate::accel::octree::walk::Walk;

    use crate::accel::octree::{Octree, build::Limits};
    use crate::math::aabb::Aabb;
    use crate::shape::Shape;

    /// The octree of the shapes 0, 1, … `count` − 1 in the cell `bounds`; `reached` returns which of eight cells a shape reaches,
    /// one bit each.
    pub fn build(
        bounds: Aabb,
        count: u32,
        limits: Limits,
        reached: &impl Fn(u32, &[Aabb; 8]) -> u8,
    ) -> Tree {
        crate::accel::octree::build::build(bounds, count, limits, reached)
    }

    /// The tree of cells.
    pub fn tree<S: Shape>(octree: &Octree<S>) -> &Tree {
        octree.tree()
    }

    /// The shapes, by the numbers that [`Tree::named`] gives them.
    pub fn shapes<S: Shape>(octree: &Octree<S>) -> &[S] {
        octree.shapes()
    }
}

/// Internals of [`Bvh`](crate::accel::bvh::Bvh).
pub mod bvh {
    pub use crate::accel::bvh::build::cost::{Cost, sah_cost};
    pub use crate::accel::bvh::build::flat::{Flat, Node};
    pub use crate::accel::bvh::build::item::Item;
    pub use crate::accel::bvh::build::sweep::sah_split;
    pub use crate::accel::bvh::pair::{Link, Pair, RayPair};
    pub use crate::accel::bvh::validate::validate;

    use crate::accel::bvh::{self, Bvh, build::Method};
    use crate::math::aabb::Aabb;
    use crate::shape::Shape;

    /// The prices of the steps of a search.
    pub const COST: Cost = bvh::COST;

    /// A tree over finite boxes within the [domain](crate::math::domain).
    pub fn build(boxes: &[Aabb], method: Method, cost: &Cost) -> Flat {
        bvh::build::build(boxes, method, cost)
    }

    /// The accelerator of a tree that has been built from the boxes of these shapes.
    pub fn over<S: Shape>(flat: Flat, shapes: Vec<S>) -> Bvh<S> {
        Bvh::from_flat(flat, shapes)
    }

    /// The root, and the pairs of all other nodes, depth-first.
    pub fn nodes<S: Shape>(bvh: &Bvh<S>) -> (Option<&Node>, &[Pair]) {
        bvh.nodes()
    }
}

/// Internals of [`WideBvh`](crate::accel::wide_bvh::WideBvh): a tree can be read, and made out of parts, which are checked.
///
/// Vector instructions rely on the contents of trees and of prepared rays. So no other code can write them. Links have no
/// bits to set,
///
/// ```compile_fail,E0423
/// let far = raybook::inside::wide_bvh::Link(3_000_000_000);
/// ```
///
/// a tree's lists, its nodes and its leaves cannot be changed,
///
/// ```compile_fail,E0616
/// # use raybook::{accel::wide_bvh::WideBvh, inside::wide_bvh};
/// let mut tree = wide_bvh::tree(&WideBvh::new(Vec::new())).clone();
/// tree.nodes.clear();
/// ```
///
/// ```compile_fail,E0616
/// # use raybook::inside::wide_bvh::Node;
/// fn widen(node: &mut Node) {
///     node.rows[0][0] = 0.0;
/// }
/// ```
///
/// and prepared rays, shears, stacks and the proofs that a processor has AVX2 or AVX-512 have no public name.
///
/// ```compile_fail,E0603
/// use raybook::accel::wide_bvh::ray::WideRay;
/// ```
///
/// ```compile_fail,E0603
/// use raybook::shape::triangle_watertight::Shear;
/// ```
///
/// ```compile_fail,E0603
/// use raybook::accel::wide_bvh::stack::Places;
/// ```
///
/// ```compile_fail,E0603
/// use raybook::accel::wide_bvh::avx2::Avx2;
/// ```
///
/// ```compile_fail,E0603
/// use raybook::accel::wide_bvh::avx512::Avx512;
/// ```
pub mod wide_bvh {
    pub use crate::accel::wide_bvh::collapse::{Family, binary, children, collapse, half_area};
    pub use crate::accel::wide_bvh::node::{CHILDREN, Leaf, Link, Node, TRIANGLES};
    pub use crate::accel::wide_bvh::optimal::collapse as collapse_optimally;
    pub use crate::accel::wide_bvh::tree::Tree;

    use crate::accel::bvh::build::{Method, cost::Cost, item::Item};
    use crate::accel::wide_bvh::{self, WideBvh};
    use crate::math::{aabb::Aabb, interval::Interval, ray::Ray};
    use crate::shape::{Hit, mesh::Facet};

    /// The prices of the steps of a search.
    pub const COST: Cost = wide_bvh::build::COST;

    /// The tree of facets with finite boxes; a leaf has at most `cost.most` facets, and at most [`TRIANGLES`].
    pub fn build(facets: Vec<Facet>, method: Method, cost: &Cost) -> Tree {
        wide_bvh::build::build(facets, method, cost)
    }

    /// The tree with cuts through triangles, even if they do not pay.
    pub fn cut(facets: Vec<Facet>) -> WideBvh {
        WideBvh::cut(facets)
    }

    /// Reorders at most 32 items by the best split; returns how many are on the left, and the price of both sides.
    pub fn split_of_few(items: &mut [Item], cost: &Cost) -> (usize, f32) {
        wide_bvh::spatial::few::best(items, cost)
    }

    /// The tree.
    pub fn tree(bvh: &WideBvh) -> &Tree {
        bvh.tree()
    }

    /// The nearest hit of each ray, with several rays in flight, even if the tree is so small that this does not pay.
    pub fn in_turns<'a>(
        bvh: &'a WideBvh,
        rays: &[Ray],
        within: Interval,
    ) -> Vec<Option<(&'a Facet, Hit)>> {
        bvh.in_turns(rays, within)
    }

    /// The boxes that a ray meets within an interval, one bit each, and the distances at which it enters them.
    pub fn meets(boxes: &[Aabb; CHILDREN], ray: &Ray, within: Interval) -> (u32, [f32; CHILDREN]) {
        wide_bvh::eight_boxes(boxes, ray, within)
    }
}

/// Internals of [`Scene`](crate::scene::world::Scene).
pub mod scene {
    use crate::accel::bvh::Bvh;
    use crate::scene::world::{Scene, Thing};

    /// The tree over the things, which every ray searches.
    pub fn things(scene: &Scene) -> &Bvh<Thing> {
        scene.things()
    }
}

/// Internals of [`denoise`](crate::image::denoise::denoise): what its loops give, compiled as all code is, and for the widest
/// vectors of the processor.
pub mod denoise {
    use crate::image::denoise::alike::{Alike, Compare};
    use crate::image::denoise::fit::{PLACE, Terms};
    use crate::image::denoise::{Guide, Spread};
    use crate::image::{Image, rgb::Rgb};
    use crate::vectors::{Loops, widest};
    use std::ops::Range;

    /// How much more the pixels of these rows differ than by noise from those that are a step away.
    pub fn differences(
        [picture, variance]: [&Image; 2],
        by: [isize; 2],
        rows: &Range<usize>,
    ) -> [Vec<f32>; 2] {
        let alike = Alike::new(picture, variance);
        let compare = || Compare(&alike, by, rows);
        [compare().run(), widest(compare())].map(|step| step.sums)
    }

    /// The plane around pixel `p`, fitted to the pixels `around` with their weights: for each pixel, its weighted colour and its weight.
    pub fn plane(picture: &Image, p: usize, around: &[(u32, f32)]) -> [Vec<(Rgb, f32)>; 2] {
        let place = |i| [i % picture.width(), i / picture.width()];
        let terms = |i| Terms::<PLACE>::of(place(i), Guide::default());
        let terms: Vec<_> = (0..picture.pixels().len()).map(terms).collect();
        let sums = |run: fn(Spread<'_, PLACE>)| {
            let mut sums = vec![(Rgb::BLACK, 0.0); terms.len()];
            run(Spread {
                pixels: picture.pixels(),
                terms: &terms,
                p,
                around,
                sums: &mut sums,
            });
            sums
        };
        [sums(|spread| spread.run()), sums(|spread| widest(spread))]
    }
}

/// Internals of [`Even`](crate::sample::even::Even).
pub mod even {
    /// A scramble of all binary digits at once.
    pub fn scramble(bits: u32, key: u32) -> u32 {
        crate::sample::even::scramble(bits, key)
    }
}

//! What an octree finds, and what it costs.

use crate::rays::ray;
use crate::triangle;
use glam::Vec3;
use proptest::prelude::*;
use raybook::accel::octree::{Octree, tree::Kind};
use raybook::accel::{Accel, list::List};
use raybook::lab::law::{Reach, fit, mean_tests};
use raybook::math::interval::Interval;

/// The law of this chapter, from 10² to 10⁶ triangles. What it costs to find a place in the tree is its depth, and that is
/// log₈ N plus what small leaves add. A ray through the whole soup also passes through leaves on its way, ∛N of them at
/// first; but a large soup is opaque, and the ray ends after as many leaves as before.
#[test]
fn nodes_grow_with_the_logarithm_of_the_number_of_triangles() {
    let near: Vec<_> = [100, 1000, 10_000, 100_000, 1_000_000]
        .map(|n| (f64::from(n), mean_tests(n, Reach::Near, Octree::new)))
        .into();
    let nodes: Vec<_> = near.iter().map(|&(n, tests)| (n, tests[0])).collect();
    let [a, b] = fit(&nodes);
    println!("nodes {nodes:?}: {a:.2} + {b:.2} log10 N");
    // A level has eight times as many cells: 1/log₁₀ 8 = 1.11 levels per power of ten; near a face a ray enters two cells.
    assert!(
        (1.1..1.7).contains(&b),
        "{b:.2} nodes more for ten times as many triangles"
    );
    for (n, count) in nodes {
        let law = a + b * n.log10();
        assert!(
            (count - law).abs() < 0.5,
            "{count:.2} nodes with {n} triangles, by the law {law:.2}"
        );
    }
    let tests = near.iter().map(|&(_, tests)| tests[1]);
    let (least, most) = tests.fold((f64::INFINITY, 0.0_f64), |(a, b), t| (a.min(t), b.max(t)));
    assert!(
        most < 1.5 * least,
        "triangles tested do not grow: {least:.1} to {most:.1}"
    );
}

proptest! {
    #[test]
    fn the_octree_agrees_with_the_list(
        corners in prop::collection::vec(prop::array::uniform3(prop::array::uniform3(-3_i8..4)), 0..40),
        from in prop::array::uniform3(-5_i8..6),
        to in prop::array::uniform3(-3_i8..4),
        scale in -6_i32..7,
    ) {
        // Whole numbers: corners and rays lie in planes of the tree, and rays meet edges.
        let scale = 10.0_f32.powi(scale);
        let point = |p: [i8; 3]| scale * Vec3::from_array(p.map(f32::from));
        let facets: Vec<_> = (0..).zip(&corners).map(|(id, &c)| triangle(id, c.map(point))).collect();
        let (from, to) = (point(from), point(to));
        prop_assume!(from != to);
        let ray = ray(from, to - from);
        let list = List::new(facets.clone());
        let expected = list.closest(&ray, Interval::AHEAD).map(|(_, hit)| hit.t);
        for octree in [Octree::of_facets(facets.clone()), Octree::new(facets)] {
            prop_assert_eq!(octree.validate(), Ok(()));
            let found = octree.closest(&ray, Interval::AHEAD).map(|(_, hit)| hit.t);
            let close = match (expected, found) {
                (Some(a), Some(b)) => (a - b).abs() <= 32.0 * f32::EPSILON * 10.0 * scale,
                (a, b) => a == b,
            };
            prop_assert!(close, "{:?} and not {:?}", found, expected);
            prop_assert_eq!(octree.any(&ray, Interval::AHEAD), found.is_some());
        }
    }

    #[test]
    fn kinds_survive_their_packing(first in 0..u32::MAX, count in 0..1_u32 << 31, occupied in 0..=255_u8) {
        use raybook::accel::octree::tree::Node;
        prop_assert_eq!(Node::leaf(first, count).kind(), Kind::Leaf { first, count });
        prop_assert_eq!(Node::inner(first, occupied).kind(), Kind::Inner { children: first, occupied });
    }
}

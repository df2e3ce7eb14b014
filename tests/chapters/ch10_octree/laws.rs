//! What an octree finds, and what it costs.

use crate::ch10_octree::whole::whole;
use proptest::prelude::*;
use raybook::accel::octree::Octree;
use raybook::inside::octree::Kind;
use raybook_chapters::shared::{law::Reach, law::fit, law::mean_tests};
use raybook_common::{STALE, measured};

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

#[test]
fn rays_that_go_as_far_as_they_can_visit_few_more_nodes_of_an_opaque_soup() {
    let [small, large] = [10_000, 1_000_000].map(|n| mean_tests(n, Reach::Inside, Octree::new)[0]);
    assert!(large < 2.0 * small, "{small:.1} nodes, and {large:.1}");
    let told = format!(
        "From a point in a soup to its first hit, a ray visits {small:.0} nodes if the soup has 10\u{a0}000 triangles, and {large:.0} if it has a \
        million, where $\\sqrt[3]{{N}}$ is 4.6 times as large.\n"
    );
    assert_eq!(measured("octree_soup", &told), told, "{STALE}");
}

proptest! {
    #[test]
    fn the_octree_agrees_with_the_list(whole in whole()) {
        for octree in [Octree::of_facets(whole.facets.clone()), Octree::new(whole.facets.clone())] {
            prop_assert_eq!(octree.validate(), Ok(()));
            whole.agrees(&octree)?;
        }
    }

    #[test]
    fn kinds_survive_their_packing(first in 0..u32::MAX, count in 0..1_u32 << 31, occupied in 0..=255_u8) {
        use raybook::inside::octree::Node;
        prop_assert_eq!(Node::leaf(first, count).kind(), Kind::Leaf { first, count });
        prop_assert_eq!(Node::inner(first, occupied).kind(), Kind::Inner { children: first, occupied });
    }
}

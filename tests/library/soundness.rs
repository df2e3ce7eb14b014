//! Whatever a program without `unsafe` asks, the library's own `unsafe` code does nothing undefined: all that can be called
//! of the wide tree is called with absurd arguments. What can no longer be written is in the examples of `src/inside.rs`,
//! which must not compile.
#![forbid(unsafe_code)]

use crate::laws::forms::config;
use crate::laws::wild::{direction, interval, vector};
use glam::{Vec3, vec3};
use proptest::prelude::*;
use raybook::accel::{
    Accel, Tests,
    bvh::build::Method,
    wide_bvh::{Kernel, WideBvh},
};
use raybook::inside::bvh;
use raybook::inside::wide_bvh::{CHILDREN, COST, Link, TRIANGLES, Tree, build, in_turns, meets};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::mesh::Facet;

/// A box, whatever its corners.
fn boxed() -> impl Strategy<Value = Aabb> {
    (vector(), vector()).prop_map(|(min, max)| Aabb { min, max })
}

/// Facets of any corners and any ids.
fn facets(n: usize) -> impl Strategy<Value = Vec<Facet>> {
    let corners = [vector(), vector(), vector()];
    let facet = (corners, any::<u32>()).prop_map(|(corners, id)| Facet { corners, id });
    prop::collection::vec(facet, 0..n)
}

/// A link, to what may not exist.
fn link() -> impl Strategy<Value = Link> {
    let number = prop_oneof![
        0..6_usize,
        any::<usize>(),
        Just(u32::MAX as usize),
        Just(1 << 31)
    ];
    (number, any::<bool>()).prop_map(|(i, leaf)| if leaf { Link::leaf(i) } else { Link::node(i) })
}

fn rays() -> impl Strategy<Value = Vec<Ray>> {
    let ray = (vector(), direction()).prop_map(|(o, d)| Ray::new(o, d));
    prop::collection::vec(ray, 1..20)
}

proptest! {
    #![proptest_config(config(3_000))]

    #[test]
    fn absurd_facets_and_rays_have_answers(facets in facets(40), rays in rays(), within in interval()) {
        let tree = WideBvh::new(facets.clone());
        let kernels = Kernel::all().into_iter();
        let trees: Vec<_> = kernels.map(|kernel| tree.clone().with(kernel)).collect();
        let many = in_turns(&tree, &rays, within);
        prop_assert_eq!(many.len(), rays.len());
        for (ray, answer) in rays.iter().zip(many) {
            let found = trees.iter().map(|tree| tree.closest(ray, within));
            for hit in found.chain([answer]).flatten() {
                prop_assert!(facets.iter().any(|f| f.id == hit.0.id), "{hit:?} is of no facet");
            }
            let _: Vec<bool> = trees.iter().map(|tree| tree.any(ray, within)).collect();
        }
    }

    #[test]
    fn absurd_boxes_are_met_or_not(boxes in prop::array::uniform8(boxed()), rays in rays(), within in interval()) {
        for ray in rays {
            prop_assert!(meets(&boxes, &ray, within).0 < 1 << CHILDREN, "eight bits for eight boxes");
        }
    }

    #[test]
    fn a_tree_of_absurd_parts_is_refused_or_answers(
        facets in facets(12),
        leaves in prop::collection::vec(prop::collection::vec(0..14_u32, 0..TRIANGLES + 2), 0..5),
        nodes in prop::collection::vec(prop::collection::vec((boxed(), link()), 0..CHILDREN + 2), 0..5),
        rays in rays(),
        within in interval(),
    ) {
        if let Ok(tree) = Tree::new(facets, &leaves, &nodes) {
            for ray in rays {
                let _ = tree.closest(&ray, within, &mut Tests::default());
            }
        }
    }
}

/// A box around the origin, which any ray through the origin meets.
const AROUND: Aabb = Aabb {
    min: Vec3::NEG_ONE,
    max: Vec3::ONE,
};

fn triangle() -> Facet {
    Facet {
        corners: [vec3(-1.0, -1.0, 0.0), vec3(1.0, -1.0, 0.0), Vec3::Y],
        id: 7,
    }
}

#[test]
fn parts_that_make_no_tree_are_refused() {
    let tree = |leaves: &[Vec<u32>], nodes: &[Vec<Link>]| {
        let boxed = |links: &Vec<Link>| links.iter().map(|&link| (AROUND, link)).collect();
        let nodes: Vec<_> = nodes.iter().map(boxed).collect();
        Tree::new(vec![triangle()], leaves, &nodes)
    };
    let ahead = Ray::new(vec3(0.0, 0.0, -2.0), Dir3::Z);
    let good = tree(&[vec![0]], &[vec![Link::node(1)], vec![Link::leaf(0)]]).expect("a tree");
    let hit = good.closest(&ahead, Interval::AHEAD, &mut ());
    assert_eq!(hit.map(|hit| (hit.t, hit.id)), Some((2.0, 7)));

    let leaf = || vec![vec![0]];
    for (why, leaves, nodes) in [
        ("a facet that is not there", vec![vec![1]], vec![]),
        ("nine facets in a leaf", vec![vec![0; 9]], vec![]),
        (
            "a leaf that is not there",
            leaf(),
            vec![vec![Link::leaf(1)]],
        ),
        (
            "a node that is not there",
            leaf(),
            vec![vec![Link::node(1)]],
        ),
        ("a node in itself", leaf(), vec![vec![Link::node(0)]]),
        (
            "a node in the one before",
            leaf(),
            vec![vec![Link::node(1)], vec![Link::node(0)]],
        ),
        ("nine children", leaf(), vec![vec![Link::leaf(0); 9]]),
        (
            "the last link of all",
            leaf(),
            vec![vec![Link::leaf(usize::MAX)]],
        ),
    ] {
        assert!(tree(&leaves, &nodes).is_err(), "{why} must be refused");
    }
}

#[test]
fn leaves_are_never_larger_than_the_instructions() {
    let many = vec![triangle(); 100];
    let greedy = bvh::Cost { most: 100, ..COST };
    let tree = build(many, Method::Binned, &greedy);
    let largest = tree.leaves().iter().map(|leaf| leaf.facets().count()).max();
    assert!(largest <= Some(TRIANGLES), "{largest:?} facets in a leaf");
}

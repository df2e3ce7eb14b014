//! The wide tree answers as the list does, bit for bit.

use crate::ch24_wide_bvh::scenes::{facets, ray, scaled, scene, with_degenerate};
use glam::{Vec3, vec3};
use proptest::prelude::*;
use raybook::accel::bvh::build::Method;
use raybook::accel::{
    Accel,
    list::List,
    wide_bvh::{Kernel, WideBvh},
};
use raybook::inside::wide_bvh::in_turns;
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::scene::soup::soup;
use raybook::shape::mesh::Facet;
use raybook::shape::{Hit, teapot};

/// An answer with its bits.
fn bits(answer: Option<(&Facet, Hit)>) -> Option<[u32; 4]> {
    answer.map(|(facet, hit)| {
        assert_eq!(
            facet.id, hit.id,
            "the hit belongs to the facet that comes with it"
        );
        [
            hit.t.to_bits(),
            hit.uv.x.to_bits(),
            hit.uv.y.to_bits(),
            hit.id,
        ]
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn all_kernels_agree_with_the_list_bit_for_bit(
        (facets, scale) in scene(),
        rays in prop::collection::vec(ray(), 1..40),
        method in prop_oneof![Just(Method::Binned), Just(Method::Sweep), Just(Method::Median)],
    ) {
        let list = List::new(facets.clone());
        let fast = WideBvh::build(facets, method);
        prop_assert_eq!(fast.validate(), Ok(()));
        let kernels = Kernel::all().into_iter();
        let trees: Vec<_> = kernels.map(|kernel| (kernel.name(), fast.clone().with(kernel))).collect();
        for one in rays {
            let (ray, within) = scaled(one, scale);
            let right = bits(list.closest(&ray, within));
            for (name, tree) in &trees {
                prop_assert_eq!(bits(tree.closest(&ray, within)), right, "{}", name);
                prop_assert_eq!(tree.any(&ray, within), right.is_some(), "{}, any", name);
                let many = in_turns(tree, &[ray; 3], within);
                prop_assert!(many.into_iter().all(|one| bits(one) == right), "{}, the batch", name);
            }
        }
    }

    #[test]
    fn facets_without_area_or_with_wild_corners_change_nothing(
        facets in with_degenerate(),
        rays in prop::collection::vec(ray(), 1..40),
    ) {
        let list = List::new(facets.clone());
        let tree = WideBvh::new(facets);
        prop_assert_eq!(tree.validate(), Ok(()));
        for (ray, within) in rays {
            prop_assert_eq!(bits(tree.closest(&ray, within)), bits(list.closest(&ray, within)));
        }
    }

    #[test]
    fn no_ray_makes_a_search_panic(
        facets in with_degenerate(),
        o in prop::array::uniform3(any::<f32>()),
        d in prop::array::uniform3(any::<f32>()),
        (min, max) in any::<(f32, f32)>(),
    ) {
        let tree = WideBvh::new(facets);
        let ray = Ray::new(o.into(), Dir3::new_or(d.into(), Dir3::X));
        for tree in Kernel::all().into_iter().map(|kernel| tree.clone().with(kernel)) {
            let within = Interval::new(min, max);
            let _ = (tree.closest(&ray, within), tree.any(&ray, within), in_turns(&tree, &[ray], within));
        }
    }
}

#[test]
fn a_batch_answers_each_ray_in_its_place() {
    let mesh = soup(3000, 5);
    let tree = WideBvh::new(mesh.facets());
    let mut rng = pcg::stream(4, 0);
    let rays: Vec<_> = (0..1000).map(|_| crossing(&mut rng)).collect();
    let many = in_turns(&tree, &rays, Interval::AHEAD);
    assert_eq!(many.len(), rays.len(), "an answer for each ray");
    let hits = many.iter().flatten().count();
    assert!(hits > 300, "the test must see hits; it saw {hits}");
    for (ray, one) in rays.iter().zip(many) {
        assert_eq!(
            bits(one),
            bits(tree.closest(ray, Interval::AHEAD)),
            "{ray:?}"
        );
    }
    let large = WideBvh::build(soup(600_000, 5).facets(), Method::Binned);
    assert!(large.bytes() > 48 << 20, "too large for a cache");
    for tree in [tree, large] {
        let many = tree.closest_many(&rays, Interval::AHEAD);
        assert!(
            many == in_turns(&tree, &rays, Interval::AHEAD),
            "whatever the tree's size"
        );
    }
}

/// A ray through the unit cube.
fn crossing(rng: &mut pcg::Pcg) -> Ray {
    use rand::RngExt;
    let mut at = || vec3(rng.random(), rng.random(), rng.random());
    let (a, b) = (at() * 3.0 - 1.0, at());
    Ray::new(a, Dir3::new_or(b - a, Dir3::X))
}

#[test]
fn a_deep_tree_needs_no_deeper_stack() {
    // Each is twice as large as the one before, so a cut takes off one at a time, and all of them are hit.
    let grown = (0..120).map(|i| {
        let z = 1.3_f32.powi(i);
        [vec3(-z, -z, z), vec3(z, -z, z), vec3(0.0, z, z)]
    });
    let facets = facets(grown);
    let tree = WideBvh::new(facets.clone());
    let list = List::new(facets);
    for i in 0..200 {
        let d = vec3(0.001 * i as f32, 0.0005 * i as f32 - 0.05, 1.0);
        let ray = Ray::new(Vec3::ZERO, Dir3::new_or(d, Dir3::Z));
        for min in [0.0, 10.0, 1e6] {
            let within = Interval::new(min, f32::INFINITY);
            assert_eq!(
                bits(tree.closest(&ray, within)),
                bits(list.closest(&ray, within)),
                "from {min}"
            );
        }
    }
}

#[test]
fn rays_in_the_faces_of_boxes_find_what_the_list_finds() {
    let facets = teapot::mesh(3).facets();
    let tree = WideBvh::new(facets.clone());
    let list = List::new(facets.clone());
    let mut hits = 0;
    for facet in &facets {
        for corner in facet.corners {
            for axis in 0..3 {
                for zero in [0.0, -0.0] {
                    let mut d = Vec3::splat(zero);
                    d[axis] = 1.0;
                    let ray = Ray::new(corner - 9.0 * d, Dir3::new_or(d, Dir3::X));
                    let right = bits(list.closest(&ray, Interval::AHEAD));
                    assert_eq!(bits(tree.closest(&ray, Interval::AHEAD)), right, "{ray:?}");
                    hits += usize::from(right.is_some());
                }
            }
        }
    }
    assert!(hits > 3000, "most of these rays hit a corner; {hits} did");
}

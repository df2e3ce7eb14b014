//! A tree over facets that have moved answers as a new one does.

use crate::ch24_wide_bvh::scenes::{facets, ray, scaled, scene};
use glam::{Vec3, vec3};
use proptest::prelude::*;
use raybook::accel::{Accel, Tests, wide_bvh::WideBvh};
use raybook::inside::wide_bvh;
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::scene::soup::soup;
use raybook::shape::{mesh::Facet, teapot};

/// The facets, each corner moved.
fn moved(facets: &[Facet], to: impl Fn(Vec3) -> Vec3) -> Vec<Facet> {
    let moved = |facet: &Facet| Facet {
        corners: facet.corners.map(&to),
        ..*facet
    };
    facets.iter().map(moved).collect()
}

/// Twisted around the y axis, by `by` radians per metre.
fn twisted(p: Vec3, by: f32) -> Vec3 {
    let (sin, cos) = (by * p.y).sin_cos();
    vec3(cos * p.x - sin * p.z, p.y, sin * p.x + cos * p.z)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn a_refitted_tree_answers_as_a_new_one(
        (facets, scale) in scene(),
        rays in prop::collection::vec(ray(), 1..40),
        by in -3.0_f32..3.0,
    ) {
        let now = moved(&facets, |p| twisted(p / scale, by) * scale);
        let new = WideBvh::new(now.clone());
        for mut tree in [WideBvh::new(facets.clone()), wide_bvh::cut(facets)] {
            tree.refit(now.clone());
            prop_assert_eq!(tree.validate(), Ok(()));
            for &one in &rays {
                let (ray, within) = scaled(one, scale);
                prop_assert_eq!(tree.closest(&ray, within), new.closest(&ray, within));
                prop_assert_eq!(tree.any(&ray, within), new.any(&ray, within));
            }
        }
    }
}

#[test]
fn a_small_movement_costs_few_steps_and_a_wild_one_many() {
    let before = soup(20_000, 4).facets();
    let steps = |tree: &WideBvh| {
        let mut tests = Tests::default();
        for i in 0..300 {
            let from = vec3(-1.0, 0.003 * i as f32, 0.5);
            let toward = vec3(1.0, 0.2, 0.001 * i as f32 - 0.15);
            let ray = Ray::new(from, Dir3::new_or(toward, Dir3::X));
            tree.closest_counted(&ray, Interval::AHEAD, &mut tests);
        }
        tests.boxes + tests.shapes
    };
    let compare = |by: f32| {
        let now = moved(&before, |p| twisted(p, by));
        let mut tree = WideBvh::new(before.clone());
        tree.refit(now.clone());
        steps(&tree) as f32 / steps(&WideBvh::new(now)) as f32
    };
    let (still, little, wild) = (compare(0.0), compare(0.1), compare(100.0));
    assert_eq!(still, 1.0, "without movement it is the same tree");
    assert!(little < 1.2, "{little} times the steps of a new tree");
    assert!(
        wild > 2.0,
        "{wild} times: the test must see a tree that no longer fits"
    );
}

#[test]
fn other_facets_than_before_make_a_new_tree() {
    let few = facets([[Vec3::ZERO, Vec3::X, Vec3::Z]]);
    let many = teapot::mesh(2).facets();
    let mut far = many.clone();
    far[7].corners[0].x = f32::INFINITY;
    let mut tree = WideBvh::new(Vec::new());
    for facets in [
        few.clone(),
        many.clone(),
        far.clone(),
        far,
        many,
        few,
        Vec::new(),
    ] {
        tree.refit(facets.clone());
        assert_eq!(tree.validate(), Ok(()));
        let new = WideBvh::new(facets);
        for i in 0..100 {
            let ray = Ray::new(vec3(0.05 * i as f32 - 2.5, 5.0, 0.1), -Dir3::Y);
            assert_eq!(
                tree.closest(&ray, Interval::AHEAD),
                new.closest(&ray, Interval::AHEAD),
                "{ray:?}"
            );
        }
    }
}

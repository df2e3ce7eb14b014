//! The drawn tree is the tree that the renderer follows.

use crate::ch13_reflection::rays::{random_direction, ray};
use crate::ch13_reflection::{see, whitted};
use glam::Vec2;
use raybook::math::pcg;
use raybook_chapters::shared::{ray_tree::Branch, ray_tree::End, ray_tree::Kind, ray_tree::grow};
use raybook_scenes::{Shot, gallery};

fn all(branch: &Branch) -> Vec<&Branch> {
    let below = branch.asks.iter().flat_map(all);
    std::iter::once(branch).chain(below).collect()
}

#[test]
fn a_tree_sees_what_the_renderer_sees() {
    let Shot { scene, camera, .. } = gallery::MARBLES.shot(96).expect("a scene");
    let mut rng = pcg::stream(13, 3);
    let middle = camera.central_ray(Vec2::splat(0.5));
    let (from, to) = (middle.origin, middle.at(8.0));
    let (mut deepest, mut limits) = (0, 0);
    for _ in 0..2000 {
        let ray = ray(from, to - from + 2.5 * *random_direction(&mut rng));
        let tree = grow(&whitted(5), &scene, &ray);
        let (drawn, seen) = (tree.sees, see(&scene, &ray, 5));
        for (drawn, seen) in drawn.channels().into_iter().zip(seen.channels()) {
            // The sums run in another order.
            assert!((drawn - seen).abs() < 1e-5, "{ray:?}: {drawn}, not {seen}");
        }
        let branches = all(&tree);
        assert!(
            branches.iter().all(|b| b.kind != Kind::Refracted),
            "nothing here is transparent"
        );
        let surfaces = branches.iter().filter(|b| b.end == End::Surface).count();
        deepest = deepest.max(surfaces);
        limits += branches.iter().filter(|b| b.end == End::Limit).count();
    }
    assert_eq!(
        deepest, 5,
        "some rays meet as many surfaces as are followed"
    );
    assert!(limits > 10, "and are ended there: {limits}");
}

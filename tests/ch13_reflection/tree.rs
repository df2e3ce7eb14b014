//! The drawn tree is the tree that the renderer follows.

use crate::rays::{random_direction, ray};
use crate::{see, whitted};
use raybook::lab::ray_tree::{Branch, End, Kind, grow};
use raybook::math::pcg;
use raybook::scene::marbles;

fn all(branch: &Branch) -> Vec<&Branch> {
    let below = branch.asks.iter().flat_map(all);
    std::iter::once(branch).chain(below).collect()
}

#[test]
fn a_tree_sees_what_the_renderer_sees() {
    let scene = marbles::scene();
    let mut rng = pcg::stream(13, 3);
    let [from, to] = marbles::VIEW;
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

#[test]
fn scan_tmp() {
    use glam::{Vec3, vec2};
    use raybook::camera::pinhole::Pinhole;
    use raybook::render::{local::Local, shadow, whitted::Whitted};
    fn show(b: &Branch) -> String {
        let c = match (b.kind, b.end) {
            (Kind::Light, End::Shadow) => "s",
            (Kind::Light, _) => "l",
            (_, End::Backdrop) => "B",
            (_, End::Limit) => "X",
            _ => "R",
        };
        let below: String = b.asks.iter().map(show).collect();
        if below.is_empty() {
            c.into()
        } else {
            format!("{c}({below})")
        }
    }
    let scene = marbles::scene();
    let [from, to] = marbles::VIEW;
    let camera = Pinhole::look_at(from, to, Vec3::Y, 0.042, 16.0 / 9.0).unwrap();
    let w = Whitted {
        local: Local {
            samples: 1,
            arrives: shadow::lit,
        },
        depth: 5,
    };
    for j in 0..40 {
        for i in 0..40 {
            let p = vec2(0.3 + 0.012 * i as f32, 0.6 + 0.01 * j as f32);
            let t = grow(&w, &scene, &camera.ray_through(p));
            let at = t
                .asks
                .iter()
                .find(|b| b.kind == Kind::Reflected)
                .map(|b| b.from);
            println!("SCAN {p} {} {at:?}", show(&t));
        }
    }
}

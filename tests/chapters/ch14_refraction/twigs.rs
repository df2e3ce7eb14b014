//! Rays that count for nearly nothing are not followed.

use glam::{Vec3, vec2};
use raybook::camera::Camera;
use raybook::camera::pinhole::Pinhole;
use raybook::math::pcg;
use raybook::render::local::{Local, NO_SHADOWS};
use raybook::render::whitted::Whitted;
use raybook_chapters::ch14_refraction::glassware::{self, Stuff};
use raybook_chapters::shared::{ray_tree::Branch, ray_tree::Kind, ray_tree::grow};
use raybook_common::{STALE, measured};

/// What the glass of the chapter's pictures is made of.
const STUFF: Stuff = Stuff {
    index: 1.5,
    liquid: 1.333,
    absorption: 1.0,
};

/// How many rays a tree has, without those to the lights.
fn rays(branch: &Branch) -> u64 {
    let below = branch.asks.iter().filter(|b| b.kind != Kind::Light);
    1 + below.map(rays).sum::<u64>()
}

#[test]
fn most_rays_of_the_whole_tree_count_for_nearly_nothing() {
    let scene = glassware::still_life(STUFF);
    let (from, to, focal_length) = glassware::VIEW;
    let camera = Pinhole::look_at(from, to, Vec3::Y, focal_length, 16.0 / 9.0).expect("a camera");
    let local = Local {
        samples: 1,
        arrives: NO_SHADOWS,
    };
    let whitted = Whitted { local, depth: 12 };
    let (mut whole, mut followed, mut worst) = (0, 0, 0.0_f32);
    // Every second pixel along each axis of the picture that the book shows.
    let (width, height) = (480, 270);
    for i in 0..width * height {
        let place = vec2((i % width) as f32 + 0.5, (i / width) as f32 + 0.5);
        let place = place / vec2(width as f32, height as f32);
        let ray = camera.central_ray(place);
        let tree = grow(&whitted, &scene, &ray);
        whole += rays(&tree);
        let seen = whitted.follow(&scene, &ray, &mut pcg::stream(14, 1));
        followed += seen.rays;
        worst = worst.max((tree.sees.g - seen.radiance.g).abs());
    }
    let times = whole as f64 / followed as f64;
    let told = format!(
        "With {width} × {height} rays spread evenly over the first picture, one ray in {times:.0} of the whole trees is traced, and no pixel loses more than {:.1} % of white.\n",
        100.0 * worst
    );
    assert_eq!(measured("twigs", &told), told, "{STALE}");
    assert!(times > 2.0, "{times} times fewer rays");
    assert!(worst < 0.05, "no pixel loses more light than {worst}");
}

//! Path tracing by three strategies: they look different, and mean the same.

use crate::ch17_rendering_equation::{ALL, direction, square};
use glam::{Vec3, vec2, vec3};
use raybook::camera::Camera;
use raybook::camera::pinhole::{PLANE_HEIGHT, Pinhole};
use raybook::math::ray::Ray;
use raybook::render::{mis::Strategy, path::Path};
use raybook::scene::world::Scene;
use raybook::scene::{cornell, plates};
use raybook_common::statistics::Mean;

/// The published view of the box, below the lamp.
const BOX: f32 = 0.3;
/// The view of the two rougher plates: on the smoother ones light sampling scatters beyond all bounds.
const PLATES: f32 = 0.68;

/// The mean radiance of a picture from some height down.
fn part((scene, camera): &(Scene, Pinhole), top: f32, path: Path, seed: u64, samples: u32) -> Mean {
    Mean::sampled(seed, samples, |rng| {
        let u = square(rng);
        let place = vec2(0.1, top) + vec2(0.8, 0.95 - top) * u;
        let ray = camera.central_ray(place);
        path.radiance(scene, &ray, rng).luminance()
    })
}

fn box_and_camera() -> (Scene, Pinhole) {
    let (eye, zoom) = (cornell::EYE, cornell::ZOOM * PLANE_HEIGHT);
    let camera = Pinhole::look_at(eye, eye + Vec3::Z, Vec3::Y, zoom, 1.0);
    (
        cornell::cornell_box(),
        camera.expect("the published camera"),
    )
}

#[test]
fn all_strategies_find_the_same_light_in_the_cornell_box() {
    let view = box_and_camera();
    for depth in [1, 2, 6] {
        let by = |strategy, samples| {
            let path = Path {
                depth,
                roulette_after: 2,
                strategy,
            };
            part(&view, BOX, path, 41, samples)
        };
        let (both, light) = (by(Strategy::Both, 1500), by(Strategy::Light, 1500));
        let surface = by(Strategy::Surface, 6000);
        both.assert_same(&light, &format!("light, depth {depth}"));
        both.assert_same(&surface, &format!("surface, depth {depth}"));
        assert!(
            both.error < 0.03 * both.mean,
            "depth {depth}: {both:?} says something"
        );
        let efficiency = (surface.error / both.error).powi(2) * 4.0;
        assert!(
            efficiency > 4.0,
            "next-event estimation pays in the box: {efficiency}"
        );
    }
}

#[test]
fn all_strategies_find_the_same_light_on_the_plates() {
    let camera = Pinhole::look_at(plates::EYE, plates::AT, Vec3::Y, 0.04, 1.5).expect("a camera");
    let view = (plates::plates(), camera);
    let by = |strategy| {
        let path = Path {
            depth: 1,
            roulette_after: 2,
            strategy,
        };
        part(&view, PLATES, path, 42, 3000)
    };
    let (both, light, surface) = (
        by(Strategy::Both),
        by(Strategy::Light),
        by(Strategy::Surface),
    );
    both.assert_same(&light, "light");
    both.assert_same(&surface, "surface");
}

#[test]
fn a_strategy_that_counts_light_twice_would_be_noticed() {
    let view = box_and_camera();
    let one = Path { depth: 1, ..ALL };
    let right = part(&view, BOX, one, 43, 3000);
    let light = part(
        &view,
        BOX,
        Path {
            strategy: Strategy::Light,
            ..one
        },
        44,
        3000,
    );
    let surface = part(
        &view,
        BOX,
        Path {
            strategy: Strategy::Surface,
            ..one
        },
        45,
        3000,
    );
    let twice = Mean {
        mean: light.mean + surface.mean,
        error: light.error.hypot(surface.error),
    };
    let z = (twice.mean - right.mean) / right.error.hypot(twice.error);
    assert!(z > 5.0, "both estimates added, without weights: {z}");
}

#[test]
fn more_surfaces_bring_more_light_and_ever_less_more() {
    let scene = cornell::cornell_box();
    let ray = Ray::new(vec3(0.278, 0.273, 0.05), direction(0.2, 1.0, 0.2)); // at the ceiling
    let seen = |depth| {
        let path = Path {
            depth,
            roulette_after: 20,
            ..ALL
        };
        Mean::sampled(46, 1500, |rng| path.radiance(&scene, &ray, rng).luminance()).mean
    };
    let [direct, two, three, four] = [1, 2, 3, 4].map(seen);
    assert_eq!(direct, 0.0, "no light of the lamp falls on the ceiling");
    let gains = [two - direct, three - two, four - three];
    assert!(
        gains[0] > gains[1] && gains[1] > gains[2] && gains[2] > 0.0,
        "each reflection brings less: {gains:?}"
    );
}

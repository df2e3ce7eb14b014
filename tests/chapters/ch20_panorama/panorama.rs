//! The environment camera: which direction each place is for.

use crate::ch20_panorama::direction;
use glam::{Vec2, Vec3, vec2, vec3};
use raybook::camera::{Camera, panorama::Panorama, pinhole::Pinhole, pose::Pose};
use raybook::light::environment::latlong;
use raybook::math::{dir3::Dir3, pcg};

/// What `f32` rounds of a direction: sines of up to π, then a sum of three products, then a length.
const ROUNDED: f32 = 1e-6;

fn turned() -> Pose {
    let camera = Pinhole::look_at(
        vec3(1.0, 2.0, 3.0),
        vec3(-4.0, 3.0, 0.5),
        Vec3::Y,
        0.05,
        1.0,
    );
    Pose::from(camera.expect("it looks somewhere"))
}

#[test]
fn the_six_directions_are_where_they_should_be() {
    let pose = turned();
    let camera = Panorama { pose };
    let cases = [
        ("the middle", vec2(0.5, 0.5), pose.forward),
        ("a quarter to the right", vec2(0.75, 0.5), pose.right),
        ("a quarter to the left", vec2(0.25, 0.5), -pose.right),
        ("the left edge", vec2(0.0, 0.5), -pose.forward),
        ("the right edge", vec2(1.0, 0.5), -pose.forward),
        ("the top edge", vec2(0.1, 0.0), pose.up),
        ("the bottom edge", vec2(0.9, 1.0), -pose.up),
    ];
    for (name, film, expected) in cases {
        let ray = camera.central_ray(film);
        assert_eq!(ray.origin, pose.position, "{name}: where the camera is");
        let off = ray.direction.distance(*expected);
        assert!(
            off < ROUNDED,
            "{name}: {:?}, not {expected:?}",
            ray.direction
        );
    }
}

#[test]
fn the_formula_of_the_comment_is_what_the_code_computes() {
    let pose = turned();
    let camera = Panorama { pose };
    let axes = [pose.forward, pose.right, pose.up].map(|axis| axis.as_dvec3());
    for (i, j) in (0..=64).flat_map(|j| (0..=64).map(move |i| (i, j))) {
        let (u, v) = (f64::from(i) / 64.0, f64::from(j) / 64.0);
        let (phi, theta) = (std::f64::consts::TAU * (u - 0.5), std::f64::consts::PI * v);
        let around = phi.cos() * axes[0] + phi.sin() * axes[1];
        let expected = theta.sin() * around + theta.cos() * axes[2];
        let film = vec2(u as f32, v as f32);
        let d = camera.central_ray(film).direction.as_dvec3();
        assert!(
            d.distance(expected) < f64::from(ROUNDED),
            "at {film}: {d}, not {expected}"
        );
    }
}

#[test]
fn a_level_panorama_is_the_inverse_of_the_map() {
    let camera = Panorama {
        pose: Pose::level(Vec3::ZERO),
    };
    let mut rng = pcg::stream(201, 0);
    for _ in 0..20_000 {
        let d = direction(&mut rng);
        let back = camera.central_ray(latlong::place(d)).direction;
        assert!(
            back.distance(*d) < 4.0 * ROUNDED,
            "{d:?} comes back as {back:?}"
        );
    }
}

#[test]
fn every_pixel_sees_its_own_texel_at_any_size() {
    let camera = Panorama {
        pose: Pose::level(Vec3::ZERO),
    };
    for (width, height) in [
        (1, 1),
        (2, 1),
        (7, 3),
        (96, 48),
        (1000, 500),
        (8192, 64),
        (64, 8192),
    ] {
        for y in 0..height {
            for x in (0..width).step_by(1 + width / 97) {
                let size = vec2(width as f32, height as f32);
                let film = (vec2(x as f32, y as f32) + 0.5) / size;
                let place = latlong::place(camera.central_ray(film).direction) * size;
                let texel = (place.x as usize, place.y as usize);
                assert_eq!(texel, (x, y), "of {width} × {height} texels");
            }
        }
    }
}

#[test]
fn a_camera_that_turns_to_the_right_shifts_the_picture_to_the_left() {
    let level = Pose::level(Vec3::ZERO);
    let right = Pose {
        forward: level.right,
        right: -level.forward,
        ..level
    };
    let at = |pose: Pose, film: Vec2| Panorama { pose }.central_ray(film).direction;
    for i in 0..1000 {
        let film = vec2((i as f32 * 0.618_034).fract(), (i as f32 + 0.5) / 1000.0);
        let before = at(level, vec2((film.x + 0.25).fract(), film.y));
        let off = at(right, film).distance(*before);
        assert!(off < 2.0 * ROUNDED, "at {film}: off by {off}");
    }
}

#[test]
fn the_lens_makes_no_difference() {
    let camera: &dyn Camera = &Panorama { pose: turned() };
    let film = vec2(0.3, 0.8);
    let rays = [Vec2::ZERO, vec2(0.9, 0.1)].map(|lens| camera.ray(film, lens));
    assert_eq!(rays[0], rays[1], "all rays start at one point");
}

#[test]
fn a_pose_and_what_it_sees_are_inverses() {
    let pose = turned();
    let mut rng = pcg::stream(202, 0);
    for _ in 0..1000 {
        let d = direction(&mut rng);
        let back = pose.ray(pose.seen(d)).direction;
        assert!(back.distance(*d) < ROUNDED, "{d:?} comes back as {back:?}");
    }
    let ahead = pose.seen(pose.forward);
    assert!(
        ahead.distance(-*Dir3::Z) < ROUNDED,
        "forward is −z for the camera, not {ahead:?}"
    );
}

//! Chapter 06: a ray meets a triangle.

mod agreement;
mod degenerate;

use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::math::pcg::{self, Pcg};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::{Hit, Shape, triangle::Triangle};
use raybook_chapters::ch06_triangle::{triangle_race::WAYS, triangle_race::questions};

/// In the plane z = 0, counter-clockwise seen from +z, with sides of 4 along x and 2 along y.
const FLAT: Triangle = Triangle {
    p0: Vec3::ZERO,
    e1: vec3(4.0, 0.0, 0.0),
    e2: vec3(0.0, 2.0, 0.0),
};

fn ray(origin: Vec3, toward: Vec3) -> Ray {
    Ray::new(origin, Dir3::new(toward).expect("a direction"))
}

fn vector(rng: &mut Pcg) -> Vec3 {
    let mut x = || 2.0 * rng.random::<f32>() - 1.0;
    vec3(x(), x(), x())
}

/// What all three ways answer; they have to agree to the last digit, so exact numbers only.
#[track_caller]
fn all_ways(triangle: &Triangle, ray: &Ray) -> Option<Hit> {
    let [a, b, c] = WAYS.map(|(_, way)| way(&(*triangle, *ray)));
    assert!(a == b && b == c, "{a:?}, {b:?} and {c:?} for {ray:?}");
    a
}

#[test]
fn hits_of_a_flat_triangle() {
    let down = |x, y| ray(vec3(x, y, 3.0), Vec3::NEG_Z);
    let rays = [
        ("inside", down(1.0, 0.5)),
        ("center", down(4.0 / 3.0, 2.0 / 3.0)),
        ("p0", down(0.0, 0.0)),
        ("p1", down(4.0, 0.0)),
        ("p2", down(0.0, 2.0)),
        ("side p0p1", down(2.0, 0.0)),
        ("side p0p2", down(0.0, 1.0)),
        ("side p1p2", down(2.0, 1.0)),
        ("past p0p1", down(2.0, -0.001)),
        ("past p0p2", down(-0.001, 1.0)),
        ("past p1p2", down(2.0, 1.001)),
        ("from behind", ray(vec3(1.0, 0.5, -2.0), Vec3::Z)),
        ("away", ray(vec3(1.0, 0.5, 3.0), Vec3::Z)),
        ("oblique", ray(vec3(-2.0, 0.5, 4.0), vec3(3.0, 0.0, -4.0))),
        ("from the surface", ray(vec3(1.0, 0.5, 0.0), Vec3::NEG_Z)),
        ("in the plane", ray(vec3(-1.0, 0.5, 0.0), Vec3::X)),
        ("along a side", ray(vec3(-1.0, 0.0, 0.0), Vec3::X)),
        ("beside the plane", ray(vec3(-1.0, 0.5, 1.0), Vec3::X)),
    ];
    raybook_common::snapshot(
        "ch06_triangle_flat",
        &raybook_common::hit_table(&FLAT, &rays),
    );
}

#[test]
fn edges_and_vertices_belong_to_the_triangle() {
    for (x, y) in [
        (0.0, 0.0),
        (4.0, 0.0),
        (0.0, 2.0),
        (2.0, 0.0),
        (0.0, 1.0),
        (2.0, 1.0),
    ] {
        let hit = all_ways(&FLAT, &ray(vec3(x, y, 3.0), Vec3::NEG_Z));
        assert_eq!(hit.map(|hit| hit.t), Some(3.0), "({x}, {y}) is on the edge");
    }
}

#[test]
fn the_back_side_is_hit_too_and_has_the_same_normal() {
    for question in questions(1000, &mut pcg::stream(6, 3)) {
        let (triangle, there) = question;
        let Some(hit) = triangle.hit(&there, Interval::AHEAD) else {
            continue;
        };
        let back = Ray::new(there.at(2.0 * hit.t), -there.direction);
        let from_behind = triangle
            .hit(&back, Interval::AHEAD)
            .expect("the same point");
        let normals = [(there, hit), (back, from_behind)]
            .map(|(ray, hit)| triangle.surface(&ray, &hit).normal);
        assert_eq!(
            normals[0], normals[1],
            "the normal does not depend on the ray"
        );
    }
}

#[test]
fn the_normal_is_on_the_side_from_which_the_corners_run_counter_clockwise() {
    let [p0, p1, p2] = FLAT.corners();
    assert_eq!(
        FLAT.normal(),
        Some(Dir3::Z),
        "seen from +z, x turns to y counter-clockwise"
    );
    for (a, b, c) in [(p1, p2, p0), (p2, p0, p1)] {
        assert_eq!(
            Triangle::new(a, b, c).normal(),
            Some(Dir3::Z),
            "whichever corner is first"
        );
    }
    for (a, b, c) in [(p0, p2, p1), (p1, p0, p2), (p2, p1, p0)] {
        assert_eq!(
            Triangle::new(a, b, c).normal(),
            Some(-Dir3::Z),
            "two corners swapped"
        );
    }
    for scale in [1e-18, 1e-6, 1e6, 1e18] {
        let scaled = Triangle::new(scale * p0, scale * p1, scale * p2);
        assert_eq!(
            scaled.normal(),
            Some(Dir3::Z),
            "a direction has no size, here {scale}"
        );
    }
}

#[test]
fn the_bounds_are_those_of_the_corners() {
    let corners = [
        vec3(1.0, 5.0, -2.0),
        vec3(-3.0, 2.0, 4.0),
        vec3(0.0, 7.0, 1.0),
    ];
    let triangle = Triangle::new(corners[0], corners[1], corners[2]);
    let bounds = Aabb {
        min: vec3(-3.0, 2.0, -2.0),
        max: vec3(1.0, 7.0, 4.0),
    };
    assert_eq!(
        triangle.corners(),
        corners,
        "these numbers are added and subtracted without rounding"
    );
    assert_eq!(
        triangle.bounds(),
        bounds,
        "the least and the greatest of each coordinate"
    );
    assert_eq!(
        FLAT.bounds().size().z,
        0.0,
        "a triangle square to an axis has a flat box"
    );
}

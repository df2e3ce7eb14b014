//! How Embree behaves at the limits, beside raybook: the rows of the table in `src/lib.rs` about one shape.

use glam::{Vec3, vec3};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::sphere::Sphere;
use raybook_common::oracle::target::Target;
use raybook_embree::embree::{Embree, Mode};

/// Whether raybook, Embree's fast mode and Embree's robust mode hit.
fn hits(target: &Target, ray: &Ray, within: Interval) -> [bool; 3] {
    let embree = Embree::new().expect("Embree works");
    let [fast, robust] = [Mode::Fast, Mode::Robust].map(|mode| {
        let scene = embree.scene(&target.solid, mode).expect("Embree works");
        scene.closest(ray, within).is_some()
    });
    [target.ask(ray, within).is_some(), fast, robust]
}

/// The triangle (0, 0), (2, 0), (0, 1) in the plane z = 0: all its numbers are exact.
fn triangle() -> Target {
    Target::triangle([Vec3::ZERO, vec3(2.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0)]).expect("finite")
}

fn ball() -> Target {
    Target::sphere(Sphere::new(Vec3::ZERO, 1.0))
}

/// The ray from (x, y, z) along −z.
fn down(x: f32, y: f32, z: f32) -> Ray {
    Ray::new(vec3(x, y, z), -Dir3::Z)
}

#[test]
fn the_beginning_of_the_interval_belongs_to_it_for_embree_robust_and_spheres() {
    let on_it = hits(&triangle(), &down(0.5, 0.25, 0.0), Interval::AHEAD);
    assert_eq!(
        on_it,
        [false, false, true],
        "a ray that starts on a triangle"
    );
    let on_it = hits(&ball(), &Ray::new(Vec3::Z, Dir3::Z), Interval::AHEAD);
    assert_eq!(
        on_it,
        [false, true, true],
        "a ray that starts on a sphere and leaves it"
    );
    let on_it = hits(&triangle(), &down(0.5, 0.25, 1.0), Interval::new(1.0, 2.0));
    assert!(
        !on_it[0] && !on_it[1],
        "an interval that begins where a triangle is: {on_it:?}"
    );
}

#[test]
fn the_end_of_the_interval_belongs_to_it_for_embree() {
    let at_it = hits(&triangle(), &down(0.5, 0.25, 1.0), Interval::new(0.0, 1.0));
    assert_eq!(
        at_it,
        [false, true, true],
        "an interval that ends on a triangle"
    );
    let at_it = hits(&ball(), &down(0.0, 0.0, 3.0), Interval::new(0.0, 2.0));
    assert_eq!(
        at_it,
        [false, true, true],
        "an interval that ends on a sphere"
    );
}

#[test]
fn both_sides_are_hit_and_the_normal_stays_outward() {
    let embree = Embree::new().expect("Embree works");
    let target = triangle();
    for (ray, from) in [
        (down(0.5, 0.25, 1.0), "the front"),
        (Ray::new(vec3(0.5, 0.25, -1.0), Dir3::Z), "the back"),
    ] {
        for mode in [Mode::Fast, Mode::Robust] {
            let scene = embree.scene(&target.solid, mode).expect("Embree works");
            let hit = scene.closest(&ray, Interval::AHEAD).expect("a hit");
            assert_eq!(
                hit.normal,
                Vec3::Z,
                "e1 x e2 points along z, seen from {from}"
            );
        }
        let ours = target.ask(&ray, Interval::AHEAD).expect("a hit");
        assert_eq!(ours.normal, Vec3::Z, "raybook's too, seen from {from}");
    }
    let inside = down(0.0, 0.0, 0.5);
    let scene = embree
        .scene(&ball().solid, Mode::Fast)
        .expect("Embree works");
    let hit = scene
        .closest(&inside, Interval::AHEAD)
        .expect("the far side");
    assert!(
        (hit.t - 1.5).abs() < 1e-6,
        "from inside, the sphere is hit where the ray leaves: {hit:?}"
    );
    assert!(
        hit.normal.z < -0.999,
        "and its normal still points outward: {hit:?}"
    );
}

#[test]
fn edges_and_corners_belong_to_a_triangle() {
    for (x, y, place) in [
        (0.0, 0.5, "edge b1 = 0"),
        (0.5, 0.0, "edge b2 = 0"),
        (1.0, 0.5, "edge b1 + b2 = 1"),
        (0.0, 0.0, "first corner"),
        (2.0, 0.0, "second corner"),
        (0.0, 1.0, "third corner"),
    ] {
        let all = hits(&triangle(), &down(x, y, 1.0), Interval::AHEAD);
        assert_eq!(all, [true; 3], "the {place}");
    }
}

#[test]
fn what_is_seen_from_its_edge_or_has_no_area_is_missed() {
    let along = Ray::new(vec3(-1.0, 0.25, 0.0), Dir3::X);
    assert_eq!(
        hits(&triangle(), &along, Interval::AHEAD),
        [false; 3],
        "a ray in the triangle's plane"
    );
    let line = Target::triangle([0.0, 1.0, 2.0].map(|x| x * Vec3::X)).expect("finite");
    for ray in [down(0.5, 0.0, 1.0), along] {
        assert_eq!(
            hits(&line, &ray, Interval::AHEAD),
            [false; 3],
            "three corners in a line"
        );
    }
}

#[test]
fn a_face_belongs_to_a_box_but_its_triangles_are_seen_from_their_edge() {
    let target = Target::cuboid(Aabb {
        min: Vec3::NEG_ONE,
        max: Vec3::ONE,
    })
    .expect("finite");
    let in_a_face = hits(&target, &down(0.25, 1.0, 3.0), Interval::AHEAD);
    assert!(in_a_face[0], "raybook's box is hit by a ray in its face");
    let on_top_of_it = Interval::new(2.5, 3.5);
    assert_eq!(
        hits(&target, &down(0.25, 1.0, 3.0), on_top_of_it),
        [false; 3],
        "between entering and leaving the box, such a ray hits nothing"
    );
}

#[test]
fn a_ray_that_touches_a_sphere_in_one_point_hits_it() {
    assert_eq!(
        hits(&ball(), &down(1.0, 0.0, 3.0), Interval::AHEAD),
        [true; 3],
        "x = r exactly"
    );
    assert_eq!(
        hits(&ball(), &down(1.000_001, 0.0, 3.0), Interval::AHEAD),
        [false; 3],
        "x > r"
    );
}

#[test]
#[should_panic(expected = "Embree takes finite rays and intervals from 0")]
fn an_interval_that_begins_below_0_is_refused_before_embree_sees_it() {
    hits(&triangle(), &down(0.5, 0.25, 1.0), Interval::new(-1.0, 1.0));
}

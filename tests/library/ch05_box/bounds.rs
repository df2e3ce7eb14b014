//! Chapter 05: bounds, and boxes without thickness, without end, without points.

use crate::ch05_box::rays::{random_direction, ray, sure_hit};
use glam::{Vec3, vec3};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg, ray::Ray, slab};
use raybook::shape::{Shape, cuboid::Cuboid};

const NAN: Vec3 = Vec3::NAN;

#[test]
fn the_bounds_of_points_are_the_least_box_and_pass_over_nan() {
    let points = [
        vec3(1.0, 5.0, -2.0),
        vec3(-3.0, 4.0, 0.0),
        vec3(0.0, 6.0, -1.0),
    ];
    let bounds = Aabb {
        min: vec3(-3.0, 4.0, -2.0),
        max: vec3(1.0, 6.0, 0.0),
    };
    assert_eq!(Aabb::of(points), bounds, "each face touches a point");
    let [p, q, r] = points;
    assert_eq!(
        Aabb::of([NAN, p, NAN, q, r, NAN]),
        bounds,
        "NaN neither enters nor erases"
    );
    assert_eq!(
        Aabb::of([p, vec3(f32::NAN, 7.0, 0.0), q, r]).max,
        vec3(1.0, 7.0, 0.0),
        "its other coordinates count"
    );
    assert_eq!(Aabb::of([]), Aabb::EMPTY, "no points, no box");
    assert_eq!(
        Aabb::of([p]),
        Aabb { min: p, max: p },
        "one point is its own box"
    );
    assert_eq!(bounds.center(), vec3(-1.0, 5.0, -1.0), "the middle");
    assert_eq!(bounds.size(), vec3(4.0, 2.0, 2.0), "the extents");
}

#[test]
fn union_and_contains_agree_with_the_empty_box_and_with_everything() {
    let bounds = Aabb::of([Vec3::ZERO, vec3(4.0, 2.0, 1.0)]);
    assert_eq!(
        bounds.union(&Aabb::EMPTY),
        bounds,
        "the empty box adds nothing"
    );
    assert_eq!(Aabb::EMPTY.union(&bounds), bounds, "from either side");
    assert_eq!(
        bounds.union(&Aabb::EVERYTHING),
        Aabb::EVERYTHING,
        "and everything adds all"
    );
    for corner in [bounds.min, bounds.max] {
        assert!(
            bounds.contains(corner) && Aabb::EVERYTHING.contains(corner),
            "faces belong to the box"
        );
        assert!(!Aabb::EMPTY.contains(corner), "nothing is in the empty box");
    }
    assert!(
        !bounds.contains(vec3(1.0, 1.0, 1.001)) && !bounds.contains(NAN),
        "outside is outside"
    );
    assert!(
        Aabb::EMPTY.size().max_element() < 0.0,
        "the empty box has negative extents"
    );
}

#[test]
fn a_box_without_thickness_is_hit_from_both_sides() {
    let flat = Cuboid::between(vec3(-1.0, 0.0, -1.0), vec3(1.0, 0.0, 1.0));
    for side in [Vec3::Y, Vec3::NEG_Y] {
        let (hit, at) = sure_hit(&flat, &ray(3.0 * side, -side));
        assert_eq!(
            (hit.t, *at.normal),
            (3.0, side),
            "the normal is on the side that is seen"
        );
        let (hit, at) = sure_hit(&flat, &ray(vec3(-3.0, 0.0, 0.5), Vec3::X));
        assert_eq!(
            (hit.t, *at.normal),
            (2.0, Vec3::NEG_X),
            "in its plane, the rim is hit"
        );
    }
}

#[test]
fn boxes_without_end_or_without_points_are_boxes_too() {
    let endless = Cuboid {
        bounds: Aabb {
            min: vec3(f32::NEG_INFINITY, 0.0, f32::NEG_INFINITY),
            max: vec3(f32::INFINITY, 1.0, f32::INFINITY),
        },
    };
    let (hit, at) = sure_hit(&endless, &ray(vec3(0.0, 4.0, 0.0), vec3(4.0, -3.0, 0.0)));
    assert_eq!(
        (hit.t, at.position, *at.normal),
        (5.0, vec3(4.0, 1.0, 0.0), Vec3::Y),
        "a slab is hit like a plane"
    );
    assert!(
        endless.hit(&at.leave(Dir3::Y), Interval::AHEAD).is_none(),
        "and left like one"
    );
    for (y, zero) in [(-1.0, 0.0), (-1.0, -0.0), (2.0, 0.0), (2.0, -0.0)] {
        let beside = ray(vec3(0.0, y, 0.0), vec3(1.0, zero, 0.0));
        let clipped = slab::clip(&endless.bounds, &beside, Interval::AHEAD);
        assert_eq!(clipped, None, "{beside:?} is never in the slab");
    }
    let mut rng = pcg::stream(5, 3);
    for bounds in [Aabb::EMPTY, Aabb::EVERYTHING] {
        for _ in 0..1000 {
            let ray = Ray::new(*random_direction(&mut rng), random_direction(&mut rng));
            let hit = Cuboid { bounds }.hit(&ray, Interval::AHEAD);
            assert_eq!(hit, None, "{bounds:?} has no surface");
        }
    }
}

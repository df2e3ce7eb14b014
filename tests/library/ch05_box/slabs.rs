//! Chapter 05: the slabs that clip a ray.

use crate::ch05_box::rays::{random_direction, ray};
use glam::{Vec3, vec3};
use raybook::math::{aabb::Aabb, interval::Interval, pcg, ray::Ray, slab};
use raybook::shape::{Shape, cuboid::Cuboid};
use std::f32::consts::SQRT_2;

/// From where to where a ray is inside the box, in metres.
type Inside = Option<(f32, f32)>;

/// Rays about the box (0, 0, 0) … (4, 2, 1), and the part of each that is inside it, ahead.
fn known_rays() -> Vec<(&'static str, Ray, Inside)> {
    let along_x = |x: f32, y: f32, z: f32| ray(vec3(x, y, z), Vec3::X);
    let corner = 3.0_f32.sqrt();
    vec![
        (
            "through the middle",
            along_x(-1.0, 1.0, 0.5),
            Some((1.0, 5.0)),
        ),
        ("in a face", along_x(-1.0, 2.0, 0.5), Some((1.0, 5.0))),
        (
            "in the opposite face",
            along_x(-1.0, 0.0, 0.5),
            Some((1.0, 5.0)),
        ),
        ("along an edge", along_x(-1.0, 2.0, 1.0), Some((1.0, 5.0))),
        ("parallel, below", along_x(-1.0, -0.5, 0.5), None),
        ("parallel, above", along_x(-1.0, 2.5, 0.5), None),
        (
            "parallel to two, beside both",
            along_x(1.0, -0.5, 1.5),
            None,
        ),
        ("from inside", along_x(1.0, 1.0, 0.5), Some((0.0, 3.0))),
        (
            "from inside, in a face",
            along_x(1.0, 2.0, 0.5),
            Some((0.0, 3.0)),
        ),
        (
            "from a corner along an edge",
            along_x(0.0, 0.0, 0.0),
            Some((0.0, 4.0)),
        ),
        ("behind", along_x(5.0, 1.0, 0.5), None),
        (
            "slanting in a face",
            ray(vec3(1.0, 3.0, 1.0), vec3(1.0, -1.0, 0.0)),
            Some((SQRT_2, 3.0 * SQRT_2)),
        ),
        (
            "through an edge",
            ray(vec3(3.0, 3.0, 0.5), vec3(1.0, -1.0, 0.0)),
            Some((SQRT_2, SQRT_2)),
        ),
        (
            "past an edge",
            ray(vec3(3.0, 3.5, 0.5), vec3(1.0, -1.0, 0.0)),
            None,
        ),
        (
            "through a corner",
            ray(vec3(3.0, 3.0, 2.0), vec3(1.0, -1.0, -1.0)),
            Some((corner, corner)),
        ),
        (
            "past a corner",
            ray(vec3(3.0, 3.5, 2.0), vec3(1.0, -1.0, -1.0)),
            None,
        ),
    ]
}

/// v with its axes in another order and some of them mirrored; mirroring turns 0 into −0.
fn moved(v: Vec3, order: [usize; 3], mirror: Vec3) -> Vec3 {
    mirror * Vec3::from_array(order.map(|axis| v[axis]))
}

#[test]
fn known_rays_are_clipped_alike_in_all_orders_of_the_axes_and_all_mirrors() {
    const ORDERS: [[usize; 3]; 6] = [
        [0, 1, 2],
        [0, 2, 1],
        [1, 0, 2],
        [1, 2, 0],
        [2, 0, 1],
        [2, 1, 0],
    ];
    let signs = |bits: usize| {
        Vec3::from_array([0, 1, 2].map(|axis| if bits >> axis & 1 == 0 { 1.0 } else { -1.0 }))
    };
    for (name, original, expected) in known_rays() {
        for (order, mirror) in ORDERS
            .into_iter()
            .flat_map(|order| (0..8).map(move |bits| (order, signs(bits))))
        {
            let place = |v: Vec3| moved(v, order, mirror);
            let bounds = Aabb::of([place(Vec3::ZERO), place(vec3(4.0, 2.0, 1.0))]);
            let direction = place(*original.direction);
            // The zeros' signs change nothing but the sign of a 0: 0.0 and −0.0 are one direction.
            for zeros in (0..8).map(signs) {
                let toward = Vec3::select(direction.cmpeq(Vec3::ZERO), 0.0 * zeros, direction);
                let ray = ray(place(original.origin), toward);
                let clipped = slab::clip(&bounds, &ray, Interval::AHEAD);
                assert_eq!(
                    clipped.is_some(),
                    expected.is_some(),
                    "{name}: {bounds:?} {ray:?}: {clipped:?}"
                );
                if let (Some(inside), Some((min, max))) = (clipped, expected) {
                    // One rounding in the direction, one in the quotient.
                    let off = (inside.min - min).abs().max((inside.max - max).abs());
                    assert!(off <= 1e-6, "{name}: {bounds:?} {ray:?}: {inside:?}");
                    let hit = Cuboid { bounds }
                        .hit(&ray, Interval::AHEAD)
                        .map(|hit| hit.t);
                    let first = if inside.min > 0.0 {
                        inside.min
                    } else {
                        inside.max
                    };
                    assert_eq!(
                        hit,
                        Some(first),
                        "{name}: {bounds:?} {ray:?}: the box is hit there"
                    );
                }
            }
        }
    }
}

#[test]
fn clipping_keeps_within_the_interval_that_was_asked_for() {
    let bounds = Aabb::of([Vec3::ZERO, vec3(4.0, 2.0, 1.0)]);
    let ray = ray(vec3(-1.0, 1.0, 0.5), Vec3::X);
    for (within, expected) in [
        (Interval::new(2.0, 3.0), Some((2.0, 3.0))),
        (Interval::new(0.0, 3.0), Some((1.0, 3.0))),
        (Interval::new(2.0, 9.0), Some((2.0, 5.0))),
        (Interval::new(6.0, 9.0), None),
        (Interval::new(0.0, 0.5), None),
    ] {
        let expected = expected.map(|(min, max)| Interval::new(min, max));
        assert_eq!(
            slab::clip(&bounds, &ray, within),
            expected,
            "within {within:?}"
        );
    }
}

#[test]
fn the_empty_box_holds_no_ray_and_the_infinite_box_all_of_each() {
    let mut rng = pcg::stream(5, 4);
    let random = (0..1000).map(|_| random_direction(&mut rng));
    let axes = Vec3::AXES
        .into_iter()
        .flat_map(|axis| [axis, -axis])
        .map(|axis| ray(Vec3::ZERO, axis).direction);
    for direction in random.chain(axes) {
        let ray = Ray::new(vec3(1.0, 0.0, -2.0), direction);
        for within in [
            Interval::AHEAD,
            Interval::new(f32::NEG_INFINITY, f32::INFINITY),
            Interval::new(1.0, 2.0),
        ] {
            assert_eq!(
                slab::clip(&Aabb::EMPTY, &ray, within),
                None,
                "{ray:?}: nothing is inside nothing"
            );
            let all = slab::clip(&Aabb::EVERYTHING, &ray, within);
            assert_eq!(all, Some(within), "{ray:?}: all of it is inside everything");
        }
    }
}

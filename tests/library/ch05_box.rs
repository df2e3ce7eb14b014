//! Chapter 05: the box, and rays that leave it.

mod bounds;
use raybook_common::rays;
mod slabs;

use glam::{DVec3, Vec3, vec3};
use rand::RngExt;
use raybook::math::pcg::{self, Pcg};
use raybook::math::{aabb::Aabb, interval::Interval, ray::Ray};
use raybook::shape::{Shape, cuboid::Cuboid};
use raybook_common::{hit_table, snapshot};
use rays::{random_direction, random_scale, ray, sure_hit};

#[test]
fn named_rays_hit_the_box_where_a_drawing_says() {
    let cuboid = Cuboid::between(vec3(4.0, 0.0, 1.0), vec3(0.0, 2.0, 0.0));
    let along_x = |x: f32, y: f32, z: f32| ray(vec3(x, y, z), Vec3::X);
    let rays = [
        ("from the left", along_x(-1.0, 0.5, 0.25)),
        ("from the right", ray(vec3(6.0, 0.5, 0.25), Vec3::NEG_X)),
        ("from above", ray(vec3(1.0, 5.0, 0.5), Vec3::NEG_Y)),
        ("from the front", ray(vec3(1.0, 0.5, 4.0), Vec3::NEG_Z)),
        (
            "slanting, 3-4-5",
            ray(vec3(-3.0, -3.0, 0.5), vec3(3.0, 4.0, 0.0)),
        ),
        ("from inside", along_x(1.0, 1.0, 0.5)),
        ("from a face inwards", along_x(0.0, 1.0, 0.5)),
        ("from a face outwards", along_x(4.0, 1.0, 0.5)),
        ("in the top", along_x(-1.0, 2.0, 0.5)),
        ("just above the top", along_x(-1.0, 2.001, 0.5)),
        ("along an edge", along_x(-1.0, 2.0, 1.0)),
        (
            "through an edge",
            ray(vec3(3.0, 3.0, 0.5), vec3(1.0, -1.0, 0.0)),
        ),
        (
            "past an edge",
            ray(vec3(3.0, 3.001, 0.5), vec3(1.0, -1.0, 0.0)),
        ),
        ("behind the ray", along_x(5.0, 1.0, 0.5)),
        ("from nowhere", along_x(f32::NAN, 1.0, 0.5)),
    ];
    snapshot("ch05_box_hits", &hit_table(&cuboid, &rays));
}

/// Some box about a point, its edges up to twice the size.
fn random_box(rng: &mut Pcg, center: Vec3, size: f32) -> Cuboid {
    let mut half = || size * rng.random_range(0.1..1.0);
    let half = vec3(half(), half(), half());
    Cuboid::between(center - half, center + half)
}

/// The lecture's way, in f64: the nearest of the six faces' planes whose point lies in the face.
fn nearest_face_in_f64(bounds: &Aabb, ray: &Ray, slack: f64) -> Option<f64> {
    let [o, d] = [ray.origin, *ray.direction].map(Vec3::as_dvec3);
    let (min, max) = (bounds.min.as_dvec3(), bounds.max.as_dvec3());
    let planes = (0..3).flat_map(|axis| [(axis, min[axis]), (axis, max[axis])]);
    let meets = planes.filter_map(|(axis, plane)| {
        let t = (plane - o[axis]) / d[axis];
        let mut p = o + t * d;
        p[axis] = 0.5 * (min[axis] + max[axis]); // on this axis the point is in the box
        let inside = (p - min).min(max - p).cmpge(DVec3::splat(-slack)).all();
        (t > 0.0 && inside).then_some(t)
    });
    meets.min_by(f64::total_cmp)
}

#[test]
fn random_rays_agree_with_the_six_faces_in_f64() {
    let mut rng = pcg::stream(5, 1);
    let (mut hits, mut misses) = (0, 0);
    for _ in 0..50_000 {
        let cuboid = random_box(&mut rng, Vec3::ZERO, 2.5);
        let ray = Ray::new(
            rng.random_range(0.0..3.0) * *random_direction(&mut rng),
            random_direction(&mut rng),
        );
        let hit = cuboid.hit(&ray, Interval::AHEAD);
        // Only rays that pass an edge by more than 1e-4 m on either side have one right answer.
        let [wide, narrow] = [1e-4, -1e-4].map(|e| nearest_face_in_f64(&cuboid.bounds, &ray, e));
        match (wide, narrow) {
            (Some(exact), Some(same)) if exact == same => {
                hits += 1;
                let (hit, at) = sure_hit(&cuboid, &ray);
                // Roundings of numbers up to 7 m: measured 5e-7.
                let off = (f64::from(hit.t) - exact).abs();
                assert!(off < 3e-6, "{cuboid:?} {ray:?}: {exact}, not {hit:?}");
                assert!(
                    cuboid.bounds.contains(at.position),
                    "{cuboid:?}: {at:?} is outside"
                );
                let (axis, outward) = (at.normal.abs().max_position(), at.normal.element_sum());
                let face = if outward > 0.0 {
                    cuboid.bounds.max
                } else {
                    cuboid.bounds.min
                };
                assert_eq!(
                    at.position[axis], face[axis],
                    "{cuboid:?}: {at:?} is on its face"
                );
                let from_outside = !cuboid.bounds.contains(ray.origin);
                assert_eq!(
                    at.normal.dot(*ray.direction) < 0.0,
                    from_outside,
                    "{cuboid:?}: {at:?} is where it enters, or leaves"
                );
            }
            (None, _) => {
                misses += 1;
                assert_eq!(hit, None, "{cuboid:?} {ray:?}: f64 misses");
            }
            _ => {}
        }
    }
    assert!(
        hits > 15_000 && misses > 15_000,
        "{hits} hits, {misses} misses: too few"
    );
}

#[test]
fn a_ray_that_leaves_is_gone_and_one_that_enters_meets_the_far_side() {
    let mut rng = pcg::stream(5, 2);
    let (mut left, mut entered) = (0, 0);
    for _ in 0..100_000 {
        let size = random_scale(&mut rng);
        let center = size * rng.random_range(0.0..1e3) * *random_direction(&mut rng);
        let cuboid = random_box(&mut rng, center, size);
        let origin = center + 5.0 * size * *random_direction(&mut rng);
        let (_, at) = sure_hit(&cuboid, &ray(origin, center - origin));
        let onward = at.leave(random_direction(&mut rng));
        let next = cuboid.hit(&onward, Interval::AHEAD);
        if at.normal.dot(*onward.direction) >= 0.0 {
            left += 1;
            assert_eq!(next, None, "{cuboid:?}: {onward:?} is outside");
            continue;
        }
        let Aabb { min, max } = cuboid.bounds;
        let depth = (onward.origin - min).min(max - onward.origin);
        // Through a face but on an edge, it may be out through the next face at once.
        if depth.min_element() > 0.0 {
            entered += 1;
            let (hit, far) = sure_hit(&cuboid, &onward);
            assert!(
                far.normal.dot(*onward.direction) > 0.0,
                "{cuboid:?} {onward:?}: {far:?} is a way out"
            );
            assert!(
                far.normal != at.normal,
                "{cuboid:?} {onward:?}: {hit:?} is on the face it came through"
            );
        }
    }
    assert!(
        left > 40_000 && entered > 40_000,
        "{left} left, {entered} entered: too few"
    );
}

#[test]
fn the_face_is_right_from_ten_thousand_kilometres() {
    // There, t has steps of one metre: the point o + t·d may be nearer to any other face.
    let cuboid = Cuboid::between(Vec3::splat(-0.1), Vec3::splat(0.1));
    for axis in Vec3::AXES.into_iter().flat_map(|axis| [axis, -axis]) {
        let aside = 0.09 * axis.any_orthonormal_vector();
        let (_, at) = sure_hit(&cuboid, &ray(-1e7 * axis + aside, axis));
        assert_eq!(*at.normal, -axis, "seen along {axis}");
        assert_eq!(at.position, aside - 0.1 * axis, "seen along {axis}");
    }
}

//! Triangles without area and rays in the plane: never a hit, whatever rounding leaves of a zero.

use crate::ch06_triangle::{FLAT, ray, vector};
use glam::{Vec3, vec3};
use raybook::math::pcg::{self, Pcg};
use raybook::math::{interval::Interval, ray::Ray};
use raybook::shape::{Shape, triangle::Triangle};
use raybook_chapters::ch06_triangle::triangle_race::WAYS;

#[test]
fn a_ray_in_the_plane_misses() {
    let mut rng = pcg::stream(6, 4);
    for _ in 0..10_000 {
        let [p0, p1, p2] = [(); 3].map(|()| vector(&mut rng));
        let triangle = Triangle::new(p0, p1, p2);
        // From p0 to the middle of the other side, up to rounding: its determinant is noise.
        let ray = ray(2.0 * p0 - 0.5 * (p1 + p2), 0.5 * (p1 + p2) - p0);
        for (name, way) in WAYS {
            assert_eq!(
                way(&(triangle, ray)),
                None,
                "{name}: {ray:?} is in the plane of {triangle:?}"
            );
        }
    }
}

/// A way to make a triangle without area out of p₀, an edge e, and a number.
type Flatten = fn(Vec3, Vec3, f32) -> Triangle;

const WITHOUT_AREA: [(&str, Flatten); 7] = [
    ("a point", |p0, _, _| Triangle {
        p0,
        e1: Vec3::ZERO,
        e2: Vec3::ZERO,
    }),
    ("p1 = p0", |p0, e, _| Triangle {
        p0,
        e1: Vec3::ZERO,
        e2: e,
    }),
    ("p2 = p0", |p0, e, _| Triangle {
        p0,
        e1: e,
        e2: Vec3::ZERO,
    }),
    ("p2 = p1", |p0, e, _| Triangle { p0, e1: e, e2: e }),
    ("p2 beyond p1", |p0, e, _| Triangle {
        p0,
        e1: e,
        e2: 2.0 * e,
    }),
    ("p0 between p1 and p2", |p0, e, _| Triangle {
        p0,
        e1: e,
        e2: -e,
    }),
    ("p2 between p0 and p1, rounded", |p0, e, x| Triangle {
        p0,
        e1: e,
        e2: x * e,
    }),
];

/// A ray at a random point of the line from p₀ along e.
fn aimed_at_line(p0: Vec3, e: Vec3, x: f32, rng: &mut Pcg) -> Ray {
    let away = vector(rng);
    ray(p0 + x * e + 2.0 * away, -away)
}

#[test]
fn a_triangle_without_area_is_never_hit() {
    for (name, flatten) in WITHOUT_AREA {
        let mut rng = pcg::stream(6, 5);
        for _ in 0..50_000 {
            let [p0, e, x] = [(); 3].map(|()| vector(&mut rng));
            let (triangle, ray) = (flatten(p0, e, x.x), aimed_at_line(p0, e, x.y, &mut rng));
            for (way, hit) in WAYS {
                assert_eq!(
                    hit(&(triangle, ray)),
                    None,
                    "{way}: {name} has no area; {triangle:?}, {ray:?}"
                );
            }
        }
    }
}

/// Möller and Trumbore's way as it is usually written down: without [`Triangle::solvable`].
fn hit_unguarded(triangle: &Triangle, ray: &Ray) -> Option<f32> {
    let s1 = ray.direction.cross(triangle.e2);
    let inverse = 1.0 / s1.dot(triangle.e1);
    let s = ray.origin - triangle.p0;
    let s2 = s.cross(triangle.e1);
    let (b1, b2) = (s1.dot(s) * inverse, s2.dot(*ray.direction) * inverse);
    let t = s2.dot(triangle.e2) * inverse;
    (b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0 && t > 0.0).then_some(t)
}

#[test]
fn without_the_guard_noise_looks_like_a_hit() {
    let mut rng = pcg::stream(6, 6);
    let (mut hits, mut far_off) = (0, 0);
    for _ in 0..50_000 {
        let [p0, e, x] = [(); 3].map(|()| vector(&mut rng));
        let ray = aimed_at_line(p0, e, x.x, &mut rng);
        let line = ray.origin.distance(p0 + x.x * e);
        if let Some(t) = hit_unguarded(&Triangle { p0, e1: e, e2: e }, &ray) {
            hits += 1;
            far_off += u32::from((t - line).abs() > 0.01 * line);
        }
    }
    // Measured: 1311 and 1286.
    assert!(hits > 500, "{hits} of 50000 rays \"hit\" a line");
    assert!(
        far_off > 200,
        "{far_off} of them at a distance where nothing is"
    );
}

#[test]
fn a_needle_a_thousand_times_as_long_as_it_is_wide_is_hit() {
    let needle = Triangle::new(
        vec3(-1.0, 0.0, 0.0),
        vec3(1.0, -1.0 / 1024.0, 0.0),
        vec3(1.0, 1.0 / 1024.0, 0.0),
    );
    for (name, way) in WAYS {
        let hit = way(&(needle, ray(vec3(0.5, 0.0, 3.0), Vec3::NEG_Z)));
        assert_eq!(
            hit.map(|hit| hit.t),
            Some(3.0),
            "{name}: the needle has an area"
        );
    }
}

#[test]
fn nan_and_infinity_are_never_hit() {
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for axis in 0..3 {
            let mut broken = [FLAT; 3];
            broken[0].p0[axis] = bad;
            broken[1].e1[axis] = bad;
            broken[2].e2[axis] = bad;
            let good = ray(vec3(1.0, 0.5, 3.0), Vec3::NEG_Z);
            for (triangle, (name, way)) in broken.iter().flat_map(|t| WAYS.map(|way| (t, way))) {
                assert_eq!(way(&(*triangle, good)), None, "{name}: {triangle:?}");
            }
            let mut from_nowhere = good;
            from_nowhere.origin[axis] = bad;
            for (name, way) in WAYS {
                assert_eq!(way(&(FLAT, from_nowhere)), None, "{name}: {from_nowhere:?}");
            }
            assert_eq!(
                FLAT.hit(&good, Interval::new(bad, bad)),
                None,
                "no t lies in such an interval"
            );
        }
    }
}

//! Chapter 04: the plane, and rays that leave it.

mod basis;
use raybook_common::rays;

use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::math::pcg::{self, Pcg};
use raybook::math::{aabb::Aabb, basis::Basis, dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::{Shape, plane::Plane};
use raybook_common::{hit_table, snapshot};
use rays::{random_direction, random_scale, ray, sure_hit};

#[test]
fn named_rays_hit_the_plane_where_a_drawing_says() {
    let plane = Plane::through(vec3(7.0, 1.0, -2.0), Dir3::Y);
    let rays = [
        ("straight down", ray(vec3(3.0, 4.0, -2.0), Vec3::NEG_Y)),
        (
            "straight up, from below",
            ray(vec3(3.0, -1.0, -2.0), Vec3::Y),
        ),
        ("slanting", ray(vec3(0.0, 5.0, 0.0), vec3(3.0, -4.0, 0.0))),
        (
            "slanting, from below",
            ray(vec3(0.0, -3.0, 0.0), vec3(0.0, 4.0, -3.0)),
        ),
        (
            "almost along it",
            ray(vec3(0.0, 2.0, 0.0), vec3(1.0, -1e-3, 0.0)),
        ),
        (
            "up and away",
            ray(vec3(0.0, 2.0, 0.0), vec3(1.0, 1e-3, 0.0)),
        ),
        ("along it, above", ray(vec3(0.0, 2.0, 0.0), Vec3::X)),
        ("along it, below", ray(vec3(0.0, -2.0, 0.0), Vec3::X)),
        ("in the plane", ray(vec3(0.0, 1.0, 0.0), Vec3::X)),
        (
            "from on it, up",
            ray(vec3(0.0, 1.0, 0.0), vec3(1.0, 1.0, 0.0)),
        ),
        (
            "from on it, down",
            ray(vec3(0.0, 1.0, 0.0), vec3(1.0, -1.0, 0.0)),
        ),
        (
            "from just above it",
            ray(vec3(0.0, 1.0 + f32::EPSILON, 0.0), Vec3::NEG_Y),
        ),
        (
            "from infinitely high",
            ray(vec3(0.0, f32::INFINITY, 0.0), Vec3::NEG_Y),
        ),
        ("from nowhere", ray(vec3(0.0, f32::NAN, 0.0), Vec3::NEG_Y)),
    ];
    snapshot("ch04_plane_hits", &hit_table(&plane, &rays));
}

#[test]
fn a_ray_parallel_to_the_plane_misses_it_with_either_sign_of_zero() {
    for axis in 0..3 {
        let side = Dir3::new(Vec3::AXES[axis]).expect("an axis is a direction");
        for normal in [side, -side] {
            for height in [-2.0, -0.0, 0.0, 2.0] {
                for zero in [0.0, -0.0] {
                    let (mut origin, mut toward) = (Vec3::ONE, Vec3::ONE);
                    origin[axis] = height;
                    toward[axis] = zero;
                    let plane = Plane::through(Vec3::ZERO, normal);
                    let hit = plane.hit(&ray(origin, toward), Interval::AHEAD);
                    assert_eq!(hit, None, "{plane:?}: along it, {height} above, {zero}");
                }
            }
        }
    }
}

/// A plane of some size somewhere, and a ray towards one of its points.
fn plane_and_ray(rng: &mut Pcg, size: f32) -> (Plane, Ray) {
    let point = size * *random_direction(rng);
    let plane = Plane::through(point, random_direction(rng));
    let origin = size * rng.random_range(0.5..5.0) * *random_direction(rng);
    let basis = Basis::around(plane.normal);
    let aside = vec3(
        rng.random_range(-9.0..9.0),
        rng.random_range(-9.0..9.0),
        0.0,
    );
    (
        plane,
        ray(origin, point + size * basis.to_world(aside) - origin),
    )
}

#[test]
fn distance_and_position_agree_with_f64() {
    let mut rng = pcg::stream(4, 1);
    let mut judged = 0;
    for _ in 0..50_000 {
        let (plane, ray) = plane_and_ray(&mut rng, 1.0);
        let [n, o, d] = [*plane.normal, ray.origin, *ray.direction].map(Vec3::as_dvec3);
        let exact = (f64::from(plane.offset) - n.dot(o)) / n.dot(d);
        // Nearer than this to the plane, or to its direction, c − n·o or n·d has lost its digits before the division.
        if exact < 0.1 || n.dot(d).abs() < 0.05 {
            continue;
        }
        judged += 1;
        let (hit, at) = sure_hit(&plane, &ray);
        // Roundings of numbers up to 6 m, divided by 0.05; measured: 1.4e-5.
        assert!(
            (f64::from(hit.t) - exact).abs() < 5e-5,
            "{plane:?} {ray:?}: {exact}, not {hit:?}"
        );
        let height = n.dot(at.position.as_dvec3()) - f64::from(plane.offset);
        assert!(
            height.abs() < f64::from(at.error),
            "{plane:?} {ray:?}: {height} above the plane"
        );
        assert_eq!(
            at.normal, plane.normal,
            "the normal is the plane's, from either side"
        );
    }
    assert!(judged > 35_000, "only {judged} were judged");
}

#[test]
fn a_ray_that_leaves_a_plane_never_comes_back() {
    let mut rng = pcg::stream(4, 2);
    let (mut above, mut below) = (0, 0);
    for _ in 0..100_000 {
        let size = random_scale(&mut rng);
        let (plane, ray) = plane_and_ray(&mut rng, size);
        let Some(hit) = plane.hit(&ray, Interval::AHEAD) else {
            continue;
        };
        let onward = plane.surface(&ray, &hit).leave(random_direction(&mut rng));
        let again = plane.hit(&onward, Interval::AHEAD);
        assert_eq!(again, None, "{plane:?} {ray:?}, left by {onward:?}");
        let up = plane.normal.dot(*onward.direction) > 0.0;
        (above, below) = (above + u32::from(up), below + u32::from(!up));
    }
    assert!(
        above > 40_000 && below > 40_000,
        "{above} above and {below} below: too few"
    );
}

#[test]
fn turning_the_normal_round_turns_the_outside_and_nothing_else() {
    let mut rng = pcg::stream(4, 3);
    for _ in 0..10_000 {
        let (plane, ray) = plane_and_ray(&mut rng, 1.0);
        let (normal, offset) = (-plane.normal, -plane.offset);
        let turned = Plane { normal, offset };
        let hits = [plane, turned].map(|plane| plane.hit(&ray, Interval::AHEAD));
        assert_eq!(hits[0], hits[1], "{plane:?} {ray:?}: it is the same plane");
    }
    assert_eq!(
        Plane::through(Vec3::ONE, Dir3::Y).bounds(),
        Aabb::EVERYTHING,
        "it has no end"
    );
}

#[test]
fn texture_coordinates_are_metres_in_the_plane() {
    let mut rng = pcg::stream(4, 4);
    for _ in 0..10_000 {
        let plane = Plane::through(*random_direction(&mut rng), random_direction(&mut rng));
        let mut drop = || {
            let above = 4.0 * *random_direction(&mut rng) + 9.0 * *plane.normal;
            sure_hit(&plane, &ray(above, -*plane.normal)).1
        };
        let (p, q) = (drop(), drop());
        let (metres, texture) = (
            p.position.distance(q.position),
            p.texture.distance(q.texture),
        );
        assert!(
            (metres - texture).abs() < 1e-5,
            "{plane:?}: {metres} m are {texture}"
        );
    }
}

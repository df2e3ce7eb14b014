//! A ray that leaves a surface does not find it again.

use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::math::pcg::{self, Pcg};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::{
    Shape, Surface, cuboid::Cuboid, plane::Plane, sphere::Sphere, triangle::Triangle,
};

/// A shape of about the given size, around the given place.
type Make = fn(f32, Vec3, &mut Pcg) -> Box<dyn Shape>;

/// What to leave, and whether to both sides: a ray into a sphere or a box rightly finds the other side of it.
const SHAPES: &[(&str, bool, Make)] = &[
    ("triangle", true, |size, at, rng| {
        Box::new(Triangle {
            p0: at,
            e1: size * vector(rng),
            e2: size * vector(rng),
        })
    }),
    (
        "cap, 100 times as long as it is high",
        true,
        |size, at, rng| {
            let e1 = size * vector(rng);
            let e2 = rng.random::<f32>() * e1 + 0.01 * size * vector(rng);
            Box::new(Triangle { p0: at, e1, e2 })
        },
    ),
    (
        "needle, 100 times as long as it is wide",
        true,
        |size, at, rng| {
            let e1 = size * vector(rng);
            Box::new(Triangle {
                p0: at,
                e1,
                e2: e1 + 0.01 * size * vector(rng),
            })
        },
    ),
    ("plane", true, |_, at, rng| {
        Box::new(Plane::through(at, direction(rng)))
    }),
    ("cuboid", false, |size, at, rng| {
        Box::new(Cuboid::between(at, at + size * vector(rng)))
    }),
    ("sphere", false, |size, at, _| {
        Box::new(Sphere::new(at, size))
    }),
];

fn vector(rng: &mut Pcg) -> Vec3 {
    let mut x = || 2.0 * rng.random::<f32>() - 1.0;
    vec3(x(), x(), x())
}

fn direction(rng: &mut Pcg) -> Dir3 {
    Dir3::new_or(vector(rng), Dir3::X)
}

/// 10 to a power between the two.
fn magnitude(rng: &mut Pcg, from: f32, to: f32) -> f32 {
    10.0_f32.powf(from + (to - from) * rng.random::<f32>())
}

/// A direction at an angle to the surface between 1e-3 and a right one, as many small ones as large ones.
fn grazing(rng: &mut Pcg, normal: Dir3, both_sides: bool) -> Dir3 {
    let sine = magnitude(rng, -3.0, 0.0);
    let along = Dir3::new_or(direction(rng).cross(*normal), Dir3::X);
    let side = if both_sides && rng.random() {
        -1.0
    } else {
        1.0
    };
    Dir3::new_or(
        side * sine * *normal + (1.0 - sine * sine).sqrt() * *along,
        normal,
    )
}

/// A surface that a ray hit: the shape is 1e-6 to 1e6 metres large and up to 1000 times its size from the origin,
/// and the ray comes from up to 100 times its size away. And the same surface, as that ray saw it.
fn some_hit(make: Make, rng: &mut Pcg) -> Option<(Box<dyn Shape>, Surface, Surface)> {
    let size = magnitude(rng, -6.0, 6.0);
    let center = size * magnitude(rng, 0.0, 3.0) * vector(rng);
    let shape = make(size, center, rng);
    let bounds = shape.bounds();
    let target = if bounds.size().is_finite() {
        bounds.center() + 0.4 * bounds.size() * vector(rng)
    } else {
        center + size * vector(rng)
    };
    let origin = target + size * magnitude(rng, 0.0, 2.0) * *direction(rng);
    let ray = Ray::new(origin, Dir3::new(target - origin)?);
    let hit = shape.hit(&ray, Interval::AHEAD)?;
    let at = shape.surface(&ray, &hit);
    Some((shape, at, at.seen_along(&ray, hit.t)))
}

/// How many of `cases` rays find the surface that they left, if `error` were `part` of what the shape states.
fn found_again(make: Make, both_sides: bool, part: f32, cases: usize) -> usize {
    let mut rng = pcg::stream(6, 1);
    let left: Vec<_> = (0..100 * cases)
        .filter_map(|_| some_hit(make, &mut rng))
        .take(cases)
        .collect();
    assert_eq!(left.len(), cases, "enough rays hit in the first place");
    let again = left.iter().filter(|(shape, at, _)| {
        let out = grazing(&mut rng, at.normal, both_sides);
        let at = Surface {
            error: part * at.error,
            ..*at
        };
        shape.blocks(&at.leave(out), Interval::AHEAD)
    });
    again.count()
}

#[test]
fn a_ray_that_leaves_does_not_find_the_surface_again() {
    for &(name, both_sides, make) in SHAPES {
        let found = found_again(make, both_sides, 1.0, 40_000);
        assert_eq!(
            found, 0,
            "{name}: {found} of 40000 rays found the surface they left"
        );
    }
}

/// The other half of the claim at [`ROUNDING`](raybook::shape::ROUNDING): a few times as large as it must be, not a hundred times.
#[test]
fn with_a_thirty_second_of_the_error_rays_do_find_the_surface_again() {
    for &(name, both_sides, make) in SHAPES {
        let found = found_again(make, both_sides, 1.0 / 32.0, 40_000);
        // A box's faces are where its corners' coordinates say, to the bit; it needs no margin.
        assert!(
            found > 0 || name == "cuboid",
            "{name}: the margin is larger than it is said to be"
        );
    }
}

#[test]
fn nor_does_a_ray_that_leaves_to_where_the_point_was_seen_from() {
    for &(name, _, make) in SHAPES {
        let mut rng = pcg::stream(6, 2);
        let mut found = 0;
        for _ in 0..40_000 {
            let Some((shape, _, seen)) = some_hit(make, &mut rng) else {
                continue;
            };
            let out = grazing(&mut rng, seen.normal, false);
            let toward = if seen.normal.dot(seen.clear) < 0.0 {
                Dir3::new_or(*out - 2.0 * out.dot(*seen.normal) * *seen.normal, out)
            } else {
                out
            };
            let ray = seen.leave(toward);
            assert_eq!(
                ray.origin,
                seen.position + seen.clear,
                "{name}: to the side of the viewer"
            );
            found += usize::from(
                shape.blocks(&ray, Interval::AHEAD) && seen.normal.dot(seen.clear) > 0.0,
            );
        }
        assert_eq!(
            found, 0,
            "{name}: {found} of 40000 rays found the surface they left"
        );
    }
}

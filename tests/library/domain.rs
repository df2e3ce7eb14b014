//! The domain is kept: inside of it shapes are hit where they are, outside of it numbers are refused, and no answer is wrong.

use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::accel::bvh::Bvh;
use raybook::accel::{
    Accel,
    grid::Grid,
    list::List,
    octree::Octree,
    two_level_grid::TwoLevelGrid,
    wide_bvh::{Kernel, WideBvh},
};
use raybook::math::domain::{LARGEST, SMALLEST};
use raybook::math::pcg::{self, Pcg};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::render::film::Film;
use raybook::shape::mesh::{Facet, Mesh, MeshError};
use raybook::shape::sphere::{Sphere, SphereError};
use raybook::shape::triangle::Triangle;
use raybook::shape::{Shape, obj, stl};

/// Powers of 10 of all lengths that a number can hold.
const POWERS: std::ops::RangeInclusive<i32> = -44..=38;

/// A triangle about as large as 1 whose shape is not extreme, a ray, and where it hits the triangle, if it does, in `f64`.
fn question(rng: &mut Pcg) -> ([Vec3; 3], Ray, Option<f64>) {
    let mut any = || Vec3::from_array(std::array::from_fn(|_| 0.8 * rng.random::<f32>() - 0.4));
    loop {
        let [a, b, c, from, to] = [(); 5].map(|()| any());
        let normal = (b - a).cross(c - a);
        let ray = Ray::new(from, Dir3::new_or(to - from, Dir3::X));
        let slope = normal.normalize_or_zero().dot(*ray.direction).abs();
        let [a64, b64, c64, o, d] = [a, b, c, from, *ray.direction].map(Vec3::as_dvec3);
        let (e1, e2, s) = (b64 - a64, c64 - a64, o - a64);
        let det = d.cross(e2).dot(e1);
        let (b1, b2) = (d.cross(e2).dot(s) / det, s.cross(e1).dot(d) / det);
        let t = s.cross(e1).dot(e2) / det;
        let inside = b1.min(b2).min(1.0 - b1 - b2);
        // What is clear in spite of rounding.
        if normal.length() > 0.05 && slope > 0.1 && inside.abs() > 1e-3 && t.abs() > 1e-2 {
            return ([a, b, c], ray, (inside > 0.0 && t > 0.0).then_some(t));
        }
    }
}

/// Lost and wrong among a thousand answers of a shape at a scale.
fn asked(scale: f32, hit: impl Fn([Vec3; 3], &Ray) -> Option<f32>) -> (u32, u32) {
    let mut rng = pcg::stream(3, 3);
    let (mut lost, mut wrong) = (0, 0);
    for _ in 0..1000 {
        let (corners, ray, expected) = question(&mut rng);
        let ray = Ray {
            origin: scale * ray.origin,
            ..ray
        };
        let found = hit(corners.map(|p| scale * p), &ray).map(|t| f64::from(t) / f64::from(scale));
        match (expected, found) {
            (Some(_), None) => lost += 1,
            (Some(expected), Some(found)) => {
                wrong += u32::from((found / expected - 1.0).abs() > 1e-3);
            }
            (None, found) => wrong += u32::from(found.is_some()),
        }
    }
    (lost, wrong)
}

type Hits = fn([Vec3; 3], &Ray) -> Option<f32>;

fn by<A: Accel<Facet>>(
    corners: [Vec3; 3],
    ray: &Ray,
    build: impl Fn(Vec<Facet>) -> A,
) -> Option<f32> {
    let accel = build(vec![Facet { corners, id: 0 }]);
    let hit = accel.closest(ray, Interval::AHEAD).map(|(_, hit)| hit.t);
    assert_eq!(
        hit.is_some(),
        accel.any(ray, Interval::AHEAD),
        "closest and any differ"
    );
    hit
}

const HITS: &[(&str, Hits)] = &[
    ("Triangle", |[a, b, c], ray| {
        Some(Triangle::new(a, b, c).hit(ray, Interval::AHEAD)?.t)
    }),
    ("Facet", |corners, ray| {
        Some(Facet { corners, id: 0 }.hit(ray, Interval::AHEAD)?.t)
    }),
    ("List", |corners, ray| by(corners, ray, List::new)),
    ("Grid", |corners, ray| by(corners, ray, Grid::of_facets)),
    ("TwoLevelGrid", |corners, ray| {
        by(corners, ray, TwoLevelGrid::of_facets)
    }),
    ("Octree", |corners, ray| by(corners, ray, Octree::of_facets)),
    ("Bvh", |corners, ray| by(corners, ray, Bvh::new)),
    ("WideBvh", |corners, ray| by(corners, ray, WideBvh::new)),
    ("WideBvh, portable", |corners, ray| {
        by(corners, ray, |f| WideBvh::new(f).with(Kernel::PORTABLE))
    }),
];

#[test]
fn triangles_are_hit_in_the_whole_domain_and_never_where_they_are_not() {
    for &(name, hit) in HITS {
        let mut kept = Vec::new();
        for power in POWERS {
            let scale = 10.0_f32.powi(power);
            let (lost, wrong) = asked(scale, hit);
            // Below, coordinates themselves have lost their digits.
            if power >= -36 {
                assert_eq!(wrong, 0, "{name} at 1e{power}: {lost} lost, {wrong} wrong");
            }
            if (SMALLEST..=LARGEST).contains(&scale) {
                assert_eq!(lost, 0, "{name} at 1e{power}: {lost} lost");
            }
            if lost == 0 {
                kept.push(power);
            }
        }
        println!(
            "{name:18} loses nothing at 1e{:?} to 1e{:?}",
            kept.first(),
            kept.last()
        );
    }
}

/// What makes no sense of far rays is no hit: a ray from outside the domain hits only what lies before it.
#[test]
fn rays_from_outside_the_domain_hit_nothing_wrong() {
    let mut rng = pcg::stream(4, 4);
    let facets: Vec<_> = raybook::scene::soup::soup(200, 2).facets();
    let structures: Vec<(&str, Ask)> = vec![
        ("Grid", ask(Grid::of_facets(facets.clone()))),
        ("TwoLevelGrid", ask(TwoLevelGrid::of_facets(facets.clone()))),
        ("Octree", ask(Octree::of_facets(facets.clone()))),
        ("Bvh", ask(Bvh::new(facets.clone()))),
        ("WideBvh", ask(WideBvh::new(facets.clone()))),
        (
            "WideBvh, portable",
            ask(WideBvh::new(facets.clone()).with(Kernel::PORTABLE)),
        ),
    ];
    let list = ask(List::new(facets));
    for power in 0..=38 {
        let scale = 10.0_f32.powi(power);
        for _ in 0..300 {
            let mut any = || Vec3::from_array(std::array::from_fn(|_| rng.random::<f32>() - 0.5));
            let (at, from) = (any() + 0.5, scale * any());
            let ray = Ray::new(from, Dir3::new_or(at - from, Dir3::X));
            let expected = list(&ray);
            for (name, ask) in &structures {
                let found = ask(&ray);
                assert!(
                    found == expected || (found.is_none() && scale > LARGEST),
                    "{name}: {ray:?}: the list {expected:?}, found {found:?}"
                );
            }
        }
    }
}

type Ask = Box<dyn Fn(&Ray) -> Option<f32>>;

fn ask<A: Accel<Facet> + 'static>(accel: A) -> Ask {
    Box::new(move |ray| accel.closest(ray, Interval::AHEAD).map(|(_, hit)| hit.t))
}

#[test]
fn a_mesh_outside_the_domain_is_refused_by_name() {
    let mesh = |scale: f32, off: f32| {
        let corners = [
            vec3(1.0, 0.0, 0.0),
            vec3(0.0, 1.0, 0.0),
            vec3(0.0, 0.0, 1.0),
        ];
        let positions = corners.map(|p| scale * p + off).to_vec();
        Mesh::new(positions, vec![[0, 1, 2]], None, None).map(|_| ())
    };
    assert_eq!(mesh(SMALLEST, 0.0), Ok(()), "the least");
    assert_eq!(mesh(LARGEST, 0.0), Ok(()), "the largest");
    for tiny in [0.99 * SMALLEST, 1e-20, 1e-41] {
        assert_eq!(mesh(tiny, 0.0), Err(MeshError::TooSmall), "{tiny}");
    }
    for huge in [1.01 * LARGEST, 1e12, 1e30, f32::MAX] {
        assert_eq!(
            mesh(huge, 0.0),
            Err(MeshError::TooFar { vertex: 0 }),
            "{huge}"
        );
    }
    assert_eq!(
        mesh(1.0, 2.0 * LARGEST),
        Err(MeshError::TooFar { vertex: 0 }),
        "small, but far away"
    );
}

#[test]
fn a_file_outside_the_domain_is_refused_where_it_says_so() {
    let far = "v 0 0 0\nv 1 2e10 0\nv 0 1 0\nf 1 2 3\n";
    let small = "v 0 0 0\nv 1e-40 0 0\nv 0 1e-40 0\nf 1 2 3\n";
    let say = |text| obj::parse(text).expect_err("it is refused").to_string();
    assert_eq!(
        say(far),
        "2:5: expected a coordinate of at most 1e9 m, found `2e10`; make the mesh smaller"
    );
    assert_eq!(
        say(small),
        "1:1: the mesh is less than 1e-9 m long along every axis: make it larger"
    );
    let stl = |x: &str| {
        format!(
            "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex {x} 0 0\nvertex 0 {x} 0\nendloop\nendfacet\nendsolid\n"
        )
    };
    let say = |text: &str| stl::parse(text).expect_err("it is refused").to_string();
    assert!(
        say(&stl("1e20")).starts_with("5:8: expected a coordinate"),
        "{}",
        say(&stl("1e20"))
    );
    assert!(
        say(&stl("1e-20")).contains("less than 1e-9 m"),
        "{}",
        say(&stl("1e-20"))
    );
    let binary = |x: f32| {
        let mut bytes = vec![0; 80];
        bytes.extend(1_u32.to_le_bytes());
        bytes.extend([0; 12]);
        for v in [0.0, 0.0, 0.0, x, 0.0, 0.0, 0.0, x, 0.0] {
            bytes.extend(f32::to_le_bytes(v));
        }
        bytes.extend([0; 2]);
        stl::parse_binary(&bytes)
            .map(|_| ())
            .map_err(|error| error.to_string())
    };
    assert_eq!(binary(1.0), Ok(()));
    assert!(binary(1e20).is_err_and(|why| why.starts_with("byte 108: a corner of triangle 0")));
    assert!(binary(1e-20).is_err_and(|why| why.contains("less than 1e-9 m")));
}

#[test]
fn a_sphere_outside_the_domain_is_refused() {
    for radius in [
        -1.0,
        -f32::MIN_POSITIVE,
        0.0,
        -0.0,
        f32::NAN,
        f32::INFINITY,
        2.0 * LARGEST,
    ] {
        let refused = Sphere::checked(Vec3::ZERO, radius);
        assert!(
            matches!(refused, Err(SphereError::Radius(_))),
            "{radius}: {refused:?}"
        );
    }
    for center in [Vec3::NAN, Vec3::INFINITY, vec3(0.0, -2.0 * LARGEST, 0.0)] {
        let refused = Sphere::checked(center, 1.0);
        assert!(
            matches!(refused, Err(SphereError::Center(_))),
            "{center}: {refused:?}"
        );
    }
    for radius in [f32::MIN_POSITIVE, SMALLEST, 1.0, LARGEST] {
        let sphere = Sphere::checked(Vec3::splat(-LARGEST), radius).expect("in the domain");
        assert!(
            sphere.bounds().min.is_finite() && sphere.bounds().max.is_finite(),
            "{sphere:?}"
        );
    }
}

#[test]
fn spheres_are_hit_in_the_whole_domain() {
    for power in -9..=9 {
        let scale = 10.0_f32.powi(power);
        let sphere = Sphere::new(Vec3::ZERO, 0.5 * scale);
        for (x, expected) in [(0.0, Some(0.4)), (0.3, Some(0.5)), (0.6, None)] {
            let ray = Ray::new(scale * vec3(x, 0.0, -0.9), Dir3::Z);
            let found = sphere.hit(&ray, Interval::AHEAD).map(|hit| hit.t / scale);
            assert!(
                found
                    .zip(expected)
                    .map_or(found == expected, |(a, b): (f32, f32)| (a - b).abs() < 1e-5),
                "1e{power}, {x}: {found:?}, not {expected:?}"
            );
        }
    }
}

#[test]
fn a_film_without_a_pixel_or_a_sample_is_refused_where_it_is_made() {
    for [width, height, samples] in [[0, 10, 1], [10, 0, 1], [10, 10, 0]] {
        let made = std::panic::catch_unwind(|| Film::new(width, height, samples));
        assert!(made.is_err(), "{width} × {height}, {samples} samples");
    }
}

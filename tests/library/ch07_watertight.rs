//! Chapter 7: no ray slips through between two triangles of a closed mesh.

use glam::{Vec2, Vec3, vec3};
use rand::RngExt;
use raybook::accel::{Accel, list::List};
use raybook::math::pcg::{self, Pcg};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::mesh::{Facet, Mesh};
use raybook::shape::triangle::Triangle;
use raybook::shape::{Shape, triangle_watertight};
use raybook_common::{STALE, grouped, measured};

const AHEAD: Interval = Interval::AHEAD;

fn vector(rng: &mut Pcg) -> Vec3 {
    Vec3::from_array(std::array::from_fn(|_| rng.random_range(-1.0..1.0)))
}

/// An octahedron whose faces are cut in n² triangles each, with corners moved at random: closed, and of no regularity.
fn rock(n: u32, rng: &mut Pcg) -> Mesh {
    let (mut positions, mut triangles) = (Vec::<Vec3>::new(), Vec::new());
    let mut lattice = std::collections::BTreeMap::new();
    let mut vertex = |p: [i32; 3]| {
        *lattice.entry(p).or_insert_with(|| {
            let p = Vec3::from_array(p.map(|c| c as f32)).normalize();
            positions.push(p * rng.random_range(0.9..1.1));
            positions.len() as u32 - 1
        })
    };
    let n = n as i32;
    for [sx, sy, sz] in (0..8).map(|i| [0, 1, 2].map(|bit| 1 - 2 * ((i >> bit) & 1))) {
        let mut at = |x: i32, y: i32| vertex([sx * x, sy * y, sz * (n - x - y)]);
        for (x, y) in (0..n).flat_map(|x| (0..n - x).map(move |y| (x, y))) {
            triangles.push([at(x, y), at(x + 1, y), at(x, y + 1)]);
            if x + y + 2 <= n {
                triangles.push([at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)]);
            }
        }
    }
    Mesh::new(positions, triangles, None, None).expect("the indices are in range")
}

/// Rays from near the middle of a mesh to its vertices and to points on its edges.
fn rays_at_edges(mesh: &Mesh, rng: &mut Pcg) -> Vec<Ray> {
    let inside = |rng: &mut Pcg| 0.3 * vector(rng);
    let mut rays = Vec::new();
    for triangle in mesh.triangles() {
        let corners = triangle.map(|i| mesh.positions()[i as usize]);
        for (p, q) in [(0, 1), (1, 2), (2, 0)].map(|(i, j)| (corners[i], corners[j])) {
            let on_edge = p.lerp(q, rng.random::<f32>());
            for target in [p, on_edge, p.midpoint(q)] {
                let origin = inside(rng);
                rays.push(Ray::new(origin, Dir3::new_or(target - origin, Dir3::X)));
            }
        }
    }
    rays
}

#[test]
fn no_ray_leaks_through_an_edge_or_a_vertex() {
    let mut rng = pcg::stream(71, 0);
    let (mut leaks, mut leaks_of_chapter_6, mut rays) = (0, 0_u32, 0_u64);
    for scale in [1.0, 1e-6, 1e6] {
        let mesh = rock(6, &mut rng);
        let scaled = mesh.positions().iter().map(|p| scale * p).collect();
        let scaled = Mesh::new(scaled, mesh.triangles().to_vec(), None, None).expect("a mesh");
        let facets = List::new(scaled.facets());
        let others: Vec<Triangle> = scaled.facets().iter().map(Facet::triangle).collect();
        let others = List::new(others);
        for _ in 0..4 {
            for ray in rays_at_edges(&mesh, &mut rng) {
                let ray = Ray::new(scale * ray.origin, ray.direction);
                rays += 1;
                leaks += u32::from(facets.closest(&ray, AHEAD).is_none());
                leaks_of_chapter_6 += u32::from(others.closest(&ray, AHEAD).is_none());
            }
        }
    }
    assert!(rays > 30_000, "{rays} rays were aimed at edges");
    assert_eq!(leaks, 0, "of {rays} rays none leaves the closed mesh");
    assert!(
        u64::from(leaks_of_chapter_6) > rays / 200,
        "these rays are hard: {leaks_of_chapter_6} of {rays} slip through by chapter 6's method"
    );
    let told = format!(
        "The tests aim {} rays from inside at the edges and corners of a closed mesh. With the test of chapter 6, {:.1} % of them find no triangle, and leave the mesh.\n",
        grouped(rays),
        100.0 * f64::from(leaks_of_chapter_6) / rays as f64
    );
    assert_eq!(measured("edges", &told), told, "{STALE}");
}

#[test]
fn away_from_edges_it_answers_as_the_method_of_chapter_6() {
    let mut rng = pcg::stream(72, 0);
    let mut hits = 0;
    for _ in 0..100_000 {
        let corners = [(); 3].map(|()| vector(&mut rng));
        let triangle = Triangle::new(corners[0], corners[1], corners[2]);
        let origin = 3.0 * vector(&mut rng);
        let ray = Ray::new(
            origin,
            Dir3::new_or(0.5 * vector(&mut rng) - origin, Dir3::X),
        );
        // Both lose digits where the ray grazes the triangle.
        let steep = triangle
            .normal()
            .is_some_and(|n| n.dot(*ray.direction).abs() > 0.05);
        let large = triangle.e1.cross(triangle.e2).length() > 0.1;
        if !(steep && large) {
            continue;
        }
        let [old, new] = [
            triangle.hit(&ray, AHEAD),
            triangle_watertight::hit(&corners, &ray, AHEAD),
        ];
        if let (Some(old), Some(new)) = (old, new) {
            hits += 1;
            assert!(
                (old.t - new.t).abs() < 1e-4 && old.uv.distance(new.uv) < 1e-4,
                "{corners:?} {ray:?}: {old:?} and {new:?}"
            );
        } else {
            let at_edge = |uv: Vec2| uv.min_element().min(1.0 - uv.x - uv.y).abs() < 1e-4;
            let hit = old.or(new);
            assert!(
                hit.is_none_or(|hit| at_edge(hit.uv)),
                "{corners:?} {ray:?}: only one of them hits, {hit:?}"
            );
        }
    }
    assert!(hits > 10_000, "{hits} rays hit");
}

#[test]
fn the_weights_are_those_of_the_second_and_the_third_corner() {
    let corners = [Vec3::ZERO, vec3(4.0, 0.0, 0.0), vec3(0.0, 4.0, 0.0)];
    for direction in [-Dir3::Z, Dir3::Z] {
        let ray = Ray::new(vec3(1.0, 2.0, 0.0) - 5.0 * *direction, direction);
        let hit =
            triangle_watertight::hit(&corners, &ray, AHEAD).expect("it is hit from both sides");
        assert_eq!(
            (hit.t, hit.uv),
            (5.0, Vec2::new(0.25, 0.5)),
            "seen along {direction:?}"
        );
    }
}

#[test]
fn what_has_no_area_to_the_ray_is_not_hit() {
    let point = [Vec3::ONE; 3];
    let needle = [Vec3::ZERO, Vec3::X, 2.0 * Vec3::X];
    let edge_on = [Vec3::ZERO, Vec3::X, Vec3::Y];
    let ray = |target: Vec3, origin: Vec3| Ray::new(origin, Dir3::new_or(target - origin, Dir3::X));
    for (corners, ray) in [
        (point, ray(Vec3::ONE, Vec3::ZERO)),
        (needle, ray(Vec3::X, vec3(1.0, 1.0, 1.0))),
        (edge_on, ray(Vec3::ZERO, vec3(-1.0, -0.5, 0.0))),
        (edge_on, ray(Vec3::NAN, Vec3::NAN)),
        (edge_on, Ray::new(Vec3::INFINITY, -Dir3::Z)),
    ] {
        assert_eq!(
            triangle_watertight::hit(&corners, &ray, AHEAD),
            None,
            "{corners:?} {ray:?}"
        );
    }
}

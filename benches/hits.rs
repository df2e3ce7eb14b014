//! What a hit costs: nanoseconds per ray for each shape. `cargo bench --bench hits`
//!
//! Every ray is aimed at the shape or past it with equal chances, in random order, as the pixels of a picture are not:
//! there, neighbours do the same, and the processor guesses their branches.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::accel::{Meshed, list::List};
use raybook::math::pcg::{self, Pcg};
use raybook::math::{dir3::Dir3, interval::Interval, quadratic, ray::Ray, slab};
use raybook::shape::mesh::Mesh;
use raybook::shape::{
    Shape, cuboid::Cuboid, plane::Plane, sphere::Sphere, triangle::Triangle,
    triangle_by_determinants, triangle_by_plane, triangle_watertight,
};
use std::hint::black_box;

/// Rays per iteration.
const RAYS: usize = 1000;
const AHEAD: Interval = Interval::AHEAD;

fn vector(rng: &mut Pcg) -> Vec3 {
    let mut x = || 2.0 * rng.random::<f32>() - 1.0;
    vec3(x(), x(), x())
}

/// Rays from all around, of which every other one, by chance, is one that `wanted`.
fn rays(seed: u64, hits: impl Fn(&Ray) -> bool) -> Vec<Ray> {
    let mut rng = pcg::stream(seed, 0);
    let mut some_ray = |wanted: bool| loop {
        let origin = 4.0 * *Dir3::new_or(vector(&mut rng), Dir3::X);
        let direction = Dir3::new_or(2.0 * vector(&mut rng) - origin, Dir3::X);
        let ray = Ray::new(origin, direction);
        if hits(&ray) == wanted {
            return ray;
        }
    };
    let mut toss = pcg::stream(seed, 1);
    (0..RAYS).map(|_| some_ray(toss.random())).collect()
}

/// The time per question of a function.
fn bench<Q, A>(criterion: &mut Criterion, name: &str, questions: &[Q], answer: impl Fn(&Q) -> A) {
    let mut group = criterion.benchmark_group("hits");
    group.throughput(Throughput::Elements(questions.len() as u64));
    group.bench_function(name, |bencher| {
        bencher.iter(|| {
            for question in questions {
                black_box(answer(black_box(question)));
            }
        });
    });
    group.finish();
}

/// The time per ray of a shape's `hit`.
fn bench_shape(criterion: &mut Criterion, name: &str, shape: &impl Shape) {
    let rays = rays(6, |ray| shape.blocks(ray, AHEAD));
    bench(criterion, name, &rays, |ray| shape.hit(ray, AHEAD));
}

fn shapes(criterion: &mut Criterion) {
    bench_shape(criterion, "plane", &Plane::through(Vec3::ZERO, Dir3::Y));
    bench_shape(criterion, "sphere", &Sphere::new(Vec3::ZERO, 1.0));
    let cuboid = Cuboid::between(Vec3::NEG_ONE, Vec3::ONE);
    bench_shape(criterion, "cuboid", &cuboid);
    let rays = rays(6, |ray| slab::clip(&cuboid.bounds, ray, AHEAD).is_some());
    bench(criterion, "slab::clip", &rays, |ray| {
        slab::clip(&cuboid.bounds, ray, AHEAD)
    });
}

fn triangles(criterion: &mut Criterion) {
    let triangle = Triangle::new(
        vec3(-1.5, -1.0, 0.5),
        vec3(1.5, -1.0, 0.0),
        vec3(0.0, 1.6, -0.5),
    );
    let rays = rays(6, |ray| triangle.blocks(ray, AHEAD));
    bench(criterion, "triangle, Möller and Trumbore", &rays, |ray| {
        triangle.hit(ray, AHEAD)
    });
    bench(criterion, "triangle, Cramer's rule", &rays, |ray| {
        triangle_by_determinants::hit(&triangle, ray, AHEAD)
    });
    bench(criterion, "triangle, plane then inside", &rays, |ray| {
        triangle_by_plane::hit(&triangle, ray, AHEAD)
    });
    let corners = triangle.corners();
    bench(criterion, "triangle, watertight", &rays, |ray| {
        triangle_watertight::hit(&corners, ray, AHEAD)
    });
}

/// A cloud of a thousand small triangles, all of which every ray asks: divide by 1000 for the time of one.
fn mesh(criterion: &mut Criterion) {
    let mut rng = pcg::stream(7, 0);
    let corners = (0..1000).flat_map(|_| {
        let center = vector(&mut rng);
        [(); 3].map(|()| center + 0.1 * vector(&mut rng))
    });
    let positions: Vec<Vec3> = corners.collect();
    let triangles = (0..1000).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let mesh = Mesh::new(positions, triangles, None, None).expect("the indices are in range");
    bench_shape(
        criterion,
        "mesh of 1000 triangles in a list",
        &Meshed::new(mesh, List::new),
    );
}

fn equations(criterion: &mut Criterion) {
    let mut rng = pcg::stream(8, 0);
    let equations: Vec<Vec3> = (0..RAYS).map(|_| vector(&mut rng)).collect();
    bench(criterion, "quadratic::solve", &equations, |q| {
        quadratic::solve(q.x, q.y, q.z)
    });
}

criterion_group!(benches, shapes, triangles, mesh, equations);
criterion_main!(benches);

//! What an accelerator costs: to build it, and time per ray. `cargo bench --bench accel`
//!
//! The teapot of 6,320 triangles; rays from all around to all places of it, in random order. The pair `counted` and `closest`
//! of each structure shows that counting costs nothing when it is not asked for: `closest` is `closest_counted` with a
//! counter that does nothing, and is never slower. `benches/peers` compares with others, on larger meshes.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use glam::Vec3;
use rand::RngExt;
use raybook::accel::{
    Accel, Tests, bvh::Bvh, grid::Grid, list::List, octree::Octree, two_level_grid::TwoLevelGrid,
    wide_bvh::WideBvh,
};
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::shape::mesh::{Facet, Mesh};
use raybook::shape::teapot;
use std::hint::black_box;

/// Rays per iteration; the list, which tests every triangle, gets a hundredth of them.
const RAYS: usize = 10_000;

fn rays(mesh: &Mesh) -> Vec<Ray> {
    let mut rng = pcg::stream(1, 0);
    let bounds = mesh.bounds();
    let mut place = |spread: f32| {
        let part = Vec3::from_array(std::array::from_fn(|_| rng.random::<f32>() - 0.5));
        bounds.center() + spread * part * bounds.size()
    };
    let ray = |_| {
        let (from, to) = (place(4.0), place(1.0));
        Ray::new(from, Dir3::new_or(to - from, Dir3::X))
    };
    (0..RAYS).map(ray).collect()
}

/// Build time, and time per ray of each kind of question.
fn bench<A: Accel<Facet>>(
    criterion: &mut Criterion,
    name: &str,
    every: usize,
    build: impl Fn(Vec<Facet>) -> A,
) {
    let mesh = teapot::mesh(10);
    let rays: Vec<_> = rays(&mesh).into_iter().step_by(every).collect();
    let facets = mesh.facets();
    let mut group = criterion.benchmark_group("build");
    group.throughput(Throughput::Elements(facets.len() as u64));
    group.bench_function(name, |bencher| {
        bencher.iter(|| build(black_box(facets.clone())));
    });
    group.finish();

    let accel = build(facets);
    let mut ask = |question: &str, answer: &dyn Fn(&Ray)| {
        let mut group = criterion.benchmark_group(question);
        group.throughput(Throughput::Elements(rays.len() as u64));
        group.bench_function(name, |bencher| {
            bencher.iter(|| rays.iter().for_each(answer));
        });
        group.finish();
    };
    ask("closest", &|ray| {
        black_box(accel.closest(black_box(ray), Interval::AHEAD));
    });
    ask("counted", &|ray| {
        let mut tests = Tests::default();
        black_box(accel.closest_counted(black_box(ray), Interval::AHEAD, &mut tests));
        black_box(tests);
    });
    ask("any", &|ray| {
        black_box(accel.any(black_box(ray), Interval::AHEAD));
    });
}

fn structures(criterion: &mut Criterion) {
    bench(criterion, "List", 100, List::new);
    bench(criterion, "Grid", 1, Grid::of_facets);
    bench(criterion, "TwoLevelGrid", 1, TwoLevelGrid::of_facets);
    bench(criterion, "Octree", 1, Octree::of_facets);
    bench(criterion, "Bvh", 1, Bvh::new);
    bench(criterion, "WideBvh", 1, WideBvh::new);
}

/// A tree over facets that have moved, beside a new one.
fn refit(criterion: &mut Criterion) {
    let facets = teapot::mesh(10).facets();
    let mut tree = WideBvh::new(facets.clone());
    let mut group = criterion.benchmark_group("build");
    group.throughput(Throughput::Elements(facets.len() as u64));
    group.bench_function("WideBvh, refitted", |bencher| {
        bencher.iter(|| tree.refit(black_box(facets.clone())));
    });
    group.finish();
}

criterion_group!(benches, structures, refit);
criterion_main!(benches);

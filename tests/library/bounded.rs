//! Whatever a mesh is, a structure over it takes at most 500 bytes a triangle, also while it is built, and time in proportion to
//! N log N. With limits of the caller's own it takes more, but not without end.

use glam::{UVec3, Vec3, vec3};
use rand::RngExt;
use raybook::accel::bvh::{Bvh, build::Method};
use raybook::accel::octree::{Octree, build::Limits, reach};
use raybook::accel::two_level_grid::{TwoLevelGrid, build::Densities};
use raybook::accel::{Accel, grid::Grid, list::List, wide_bvh::WideBvh};
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::shape::mesh::Facet;
use raybook_common::counting::peak;
use raybook_common::thorough;
use std::f32::consts::TAU;

/// Triangles of each mesh, in a thorough test.
const N: u32 = 40_000;

/// The most that a structure may take per triangle, with the triangles, in bytes.
const BYTES: usize = 500;

/// The triangles number i of n.
fn mesh(n: u32, triangle: impl Fn(f32) -> [Vec3; 3]) -> Vec<Facet> {
    let facet = |id: u32| Facet {
        corners: triangle(id as f32 / n as f32),
        id,
    };
    (0..n).map(facet).collect()
}

/// Meshes that structures dislike, each of n triangles.
#[allow(clippy::too_many_lines, reason = "it is a list")]
fn meshes(n: u32) -> Vec<(&'static str, Vec<Facet>)> {
    let unit = [
        vec3(0.1, 0.2, 0.3),
        vec3(1.0, 0.3, 0.1),
        vec3(0.2, 1.1, 0.9),
    ];
    let turned = |angle: f32| vec3(angle.cos(), 0.0, angle.sin());
    let mut rng = pcg::stream(9, 9);
    let mut any = || Vec3::from_array(std::array::from_fn(|_| rng.random::<f32>()));
    let threes: Vec<Vec3> = (0..=n / 3).map(|_| any()).collect();
    vec![
        ("identical", mesh(n, |_| unit)),
        (
            "identical, in a face",
            mesh(n, |_| unit.map(|p| p * vec3(1.0, 0.0, 1.0))),
        ),
        (
            "concentric",
            mesh(n, |x| unit.map(|p| (0.1 + x) * (p - 0.5))),
        ),
        (
            "nested boxes",
            mesh(n, |x| unit.map(|p| p * (1.0 + 1e-6 * x))),
        ),
        (
            "diagonal",
            mesh(n, |x| {
                [
                    Vec3::ZERO,
                    Vec3::ONE,
                    vec3(0.5 + 0.01 * x, 0.5, 0.5 - 0.01 * x),
                ]
            }),
        ),
        (
            "slivers",
            mesh(n, |x| {
                let p = vec3(x, 0.0, (997.0 * x).fract());
                [
                    p,
                    p + vec3(0.0, 1.0, 1e-6),
                    vec3(1.0 - x, 1.0, (331.0 * x).fract()),
                ]
            }),
        ),
        (
            "slivers across",
            mesh(n, |x| {
                let p = 0.5 + vec3((811.0 * x).sin(), (977.0 * x).cos(), (1009.0 * x).sin());
                [p, Vec3::ONE - p, Vec3::ONE - p + 1e-5]
            }),
        ),
        (
            "fan",
            mesh(n, |x| {
                [
                    Vec3::ZERO,
                    turned(TAU * x),
                    turned(TAU * (x + 1.0 / n as f32)),
                ]
            }),
        ),
        (
            "cone",
            mesh(n, |x| {
                [Vec3::Y, turned(TAU * x), turned(TAU * (x + 1.0 / n as f32))]
            }),
        ),
        (
            "shrinking",
            mesh(n, |x| unit.map(|p| p * (-x * n as f32 / 8.0).exp2())),
        ),
        (
            "shrinking slowly",
            mesh(n, |x| unit.map(|p| p * (-100.0 * x).exp2())),
        ),
        ("one far away", {
            let mut all = mesh(n, |x| {
                unit.map(|p| 0.01 * p + vec3(x, (37.0 * x).fract(), 0.0))
            });
            all[0].corners = unit.map(|p| 1e8 * (p + 1.0));
            all
        }),
        ("denormal", mesh(n, |x| unit.map(|p| p * (1.0 + x) * 1e-41))),
        (
            "denormal, of one place",
            mesh(n, |_| unit.map(|p| p * 1e-45)),
        ),
        ("denormal, and one that is not", {
            let mut all = mesh(n, |x| unit.map(|p| p * (1.0 + x) * 1e-41));
            all[0].corners = unit;
            all
        }),
        (
            "strip",
            mesh(n, |x| {
                [x, x + 2.0 / n as f32, x]
                    .map(|x| vec3(1e3 * x, 0.1, 0.0))
                    .map(|p| p + vec3(0.0, 0.0, (p.x * 77.0).fract() * 1e-2))
            }),
        ),
        (
            "strip of squares",
            mesh(n, |x| {
                let (x, w) = (1e5 * x, 1.0);
                [vec3(x, 0.0, 0.0), vec3(x + w, 0.0, w), vec3(x, 0.0, w)]
            }),
        ),
        (
            "diagonal strip",
            mesh(n, |x| {
                [Vec3::splat(x), Vec3::splat(x + 1e-5), vec3(x + 1e-5, x, x)]
            }),
        ),
        ("points", mesh(n, |x| [vec3(x, (71.0 * x).fract(), 0.3); 3])),
        ("one point", mesh(n, |_| [Vec3::ONE; 3])),
        (
            "far from 0",
            mesh(n, |x| unit.map(|p| 1e8 + 100.0 * (p + x))),
        ),
        ("threes", {
            let facets = mesh(n, |_| unit);
            let at = |facet: Facet| Facet {
                corners: facet
                    .corners
                    .map(|p| 1e-6 * p + threes[facet.id as usize / 3]),
                ..facet
            };
            facets.into_iter().map(at).collect()
        }),
        (
            "large soup",
            mesh(n, |x| {
                let at = |k: f32| {
                    vec3(
                        (k * x).fract(),
                        (1.7 * k * x).fract(),
                        (2.3 * k * x).fract(),
                    )
                };
                [at(1013.0), at(2011.0), at(4021.0)]
            }),
        ),
    ]
}

/// What comes of work on one thread.
fn alone<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    pool.expect("a thread").install(work)
}

/// Builds a structure over every mesh; asserts what it takes, and that some rays are answered as by the list.
fn bounded<A: Accel<Facet>>(build: impl Fn(Vec<Facet>) -> A + Sync, bytes: impl Fn(&A) -> usize) {
    for (name, facets) in meshes(thorough(N)) {
        // All of it on one thread, for each counts what it allocates itself.
        let (peak, accel) = alone(|| peak(|| build(facets.clone())));
        let [stays, peak] = [bytes(&accel), peak].map(|bytes| bytes / facets.len());
        println!("{name:30} {stays:4} bytes a triangle, {peak:4} while it is built");
        assert!(
            stays.max(peak) <= BYTES,
            "{name}: {stays} bytes a triangle, {peak} while it is built, and {BYTES} are allowed"
        );
        let list = List::new(facets.clone());
        for i in 0..4 {
            let corners = facets[i * facets.len() / 4].corners;
            let to = (corners[0] + corners[1] + corners[2]) / 3.0;
            let from = to + vec3(0.3, 2.0, -0.4 + 0.1 * i as f32);
            let ray = Ray::new(from, Dir3::new_or(to - from, Dir3::X));
            let ask = |hit: Option<(&Facet, raybook::shape::Hit)>| hit.map(|(_, hit)| hit.t);
            assert_eq!(
                ask(accel.closest(&ray, Interval::AHEAD)),
                ask(list.closest(&ray, Interval::AHEAD)),
                "{name}: {ray:?}"
            );
        }
    }
}

#[test]
fn grid() {
    bounded(Grid::of_facets, Grid::bytes);
}

#[test]
fn grid_by_bounds() {
    bounded(Grid::new, Grid::bytes);
}

#[test]
fn two_level_grid() {
    bounded(TwoLevelGrid::of_facets, TwoLevelGrid::bytes);
}

#[test]
fn two_level_grid_by_bounds() {
    bounded(TwoLevelGrid::new, TwoLevelGrid::bytes);
}

#[test]
fn octree() {
    bounded(Octree::of_facets, Octree::bytes);
}

#[test]
fn octree_by_bounds() {
    bounded(Octree::new, Octree::bytes);
}

#[test]
fn bvh() {
    for method in [
        Method::Median,
        Method::Middle,
        Method::Sweep,
        Method::Binned,
        Method::Fine,
        Method::BottomUp,
    ] {
        println!("{method:?}");
        bounded(|facets| Bvh::build(facets, method), Bvh::bytes);
    }
}

#[test]
fn wide_bvh() {
    for method in [Method::Fine, Method::Middle, Method::BottomUp] {
        println!("{method:?}");
        bounded(|facets| WideBvh::build(facets, method), WideBvh::bytes);
    }
    println!("cut");
    bounded(raybook::inside::wide_bvh::cut, WideBvh::bytes);
}

/// Builds a structure over shapes in the same place; asserts what it takes, in bytes a triangle and beside that.
fn takes_at_most<A>(
    name: &str,
    [each, beside]: [usize; 2],
    build: impl FnOnce(Vec<Facet>) -> A + Send,
    bytes: impl Fn(&A) -> usize,
) where
    A: Send,
{
    const N: u32 = 2000;
    let (_, facets) = meshes(N).swap_remove(0);
    let (peak, accel) = alone(|| peak(|| build(facets)));
    let (stays, most) = (bytes(&accel), each * N as usize + beside);
    println!("{name:50} {stays:10} bytes, {peak:10} while it is built");
    assert!(
        stays <= most,
        "{name}: {stays} bytes, and {most} are allowed"
    );
    // Lists double while they grow, and are copied into their last place.
    assert!(
        peak <= 5 * most,
        "{name}: {peak} bytes while it is built, and {most} are to stay"
    );
}

#[test]
fn an_octree_with_any_limits() {
    // Names of 4 bytes, nodes of 8, and a facet.
    let most = [4 * Limits::MOST_COPIES as usize + 16 * 8 + 40, 8 * 4096];
    for opening in [f32::NEG_INFINITY, -1.0, 0.0, f32::NAN] {
        for copies in [f32::INFINITY, f32::MAX, 1e3, 0.0, f32::NAN] {
            for depth in [0, 16, u32::MAX] {
                let limits = Limits {
                    opening,
                    copies,
                    depth,
                };
                let name = format!("opening {opening}, {copies} copies, depth {depth}");
                let build = |facets| Octree::with(facets, limits, reach::by_bounds);
                takes_at_most(&name, most, build, Octree::bytes);
            }
        }
    }
}

#[test]
fn an_ordinary_octree_needs_far_fewer_copies_than_the_most() {
    let facets = raybook::scene::soup::soup(3000, 1).facets();
    let of = |copies| {
        let limits = Limits {
            copies,
            ..Limits::USUAL
        };
        let octree = Octree::with(facets.clone(), limits, reach::by_triangle);
        octree.bytes()
    };
    assert_eq!(of(f32::INFINITY), of(100.0));
}

/// The most that a grid takes whose cells the caller chooses, in bytes.
const WISH: usize = 1 << 28;

#[test]
fn a_grid_of_any_resolution() {
    for resolution in [UVec3::ZERO, UVec3::MAX, UVec3::new(u32::MAX, 1, 0)] {
        let name = format!("a grid of {resolution} cells");
        let build = |facets| Grid::with_resolution(facets, resolution);
        takes_at_most(&name, [48, WISH], build, Grid::bytes);
    }
}

#[test]
fn a_two_level_grid_of_any_densities() {
    const MOST: f32 = f32::INFINITY;
    for [coarse, fine] in [
        [MOST, MOST],
        [MOST, 0.0],
        [0.0, MOST],
        [f32::MAX, 1e6],
        [-1.0, -1.0],
        [f32::NAN, f32::NAN],
    ] {
        let name = format!("a two-level grid, {coarse} and {fine}");
        let build = |facets| TwoLevelGrid::of_facets_with(facets, Densities { coarse, fine });
        takes_at_most(&name, [48, 2 * WISH], build, TwoLevelGrid::bytes);
    }
}

//! The builders: invariants, cost, depth, threads.

use crate::ch11_bvh::METHODS;
use glam::Vec3;
use raybook::accel::bvh::{Bvh, build::Method};
use raybook::inside::bvh::{COST, Flat, Node, Pair, build, sah_cost, validate};
use raybook::math::aabb::Aabb;
use raybook::scene::soup::soup;
use raybook::shape::{Shape, teapot};

fn boxes(points: impl Iterator<Item = Vec3>) -> Vec<Aabb> {
    points.map(|p| Aabb { min: p, max: p }).collect()
}

fn check(flat: &Flat, boxes: &[Aabb]) -> Result<(), String> {
    let in_order: Vec<_> = flat.order.iter().map(|&i| boxes[i as usize]).collect();
    let mut numbers = flat.order.clone();
    numbers.sort_unstable();
    assert!(
        numbers.iter().copied().eq(0..boxes.len() as u32),
        "no number is lost or doubled"
    );
    validate(flat.root.as_ref(), &flat.pairs, &in_order)
}

#[test]
fn nodes_have_32_bytes_and_pairs_fill_a_cache_line() {
    assert_eq!(size_of::<Node>(), 32, "the compact array of the lecture");
    assert_eq!(
        (size_of::<Pair>(), align_of::<Pair>()),
        (64, 64),
        "two nodes, one line"
    );
}

#[test]
fn equal_boxes_and_lines_of_points_give_trees_of_limited_depth() {
    const N: u32 = 100_000;
    let growth = |i: u32| 1e-18 * (1e36_f64).powf(f64::from(i) / f64::from(N));
    let scenes = [
        ("equal", boxes((0..N).map(|_| Vec3::ONE))),
        ("even", boxes((0..N).map(|i| Vec3::X * i as f32))),
        (
            "exponential",
            boxes((0..N).map(|i| Vec3::X * growth(i) as f32)),
        ),
        (
            "two places",
            boxes((0..N).map(|i| Vec3::Y * (i % 2) as f32)),
        ),
    ];
    for (name, boxes) in scenes {
        for method in METHODS {
            let flat = build(&boxes, method, &COST);
            assert_eq!(check(&flat, &boxes), Ok(()), "{name} {method:?}");
        }
    }
}

#[test]
fn doubling_distances_make_the_deepest_trees_and_stay_within_the_stack() {
    // Each point is farther away than all before it together: whoever cuts off the last has as many levels as points.
    let boxes = boxes((-60..60).map(|i| Vec3::X * 2.0_f32.powi(i)));
    for method in METHODS {
        let flat = build(&boxes, method, &COST);
        assert_eq!(check(&flat, &boxes), Ok(()), "{method:?}");
    }
}

#[test]
fn any_number_of_threads_builds_the_same_tree() {
    let boxes: Vec<_> = soup(30_000, 5).facets().iter().map(Shape::bounds).collect();
    for method in METHODS {
        let with = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
            pool.expect("threads")
                .install(|| build(&boxes, method, &COST))
        };
        let (one, four) = (with(1), with(4));
        assert!(one == four, "{method:?}: one thread and four differ");
        assert_eq!(check(&one, &boxes), Ok(()), "{method:?}");
    }
}

#[test]
fn the_heuristic_pays_and_bins_are_nearly_as_good_as_all_cuts() {
    for (name, mesh) in [("teapot", teapot::mesh(12)), ("soup", soup(8000, 3))] {
        let cost = |method| Bvh::build(mesh.facets(), method).sah_cost();
        let [median, _, sweep, binned, fine, bottom_up] = METHODS.map(cost);
        println!(
            "{name}: median {median} sweep {sweep} bins {binned} fine {fine} bottom-up {bottom_up}"
        );
        assert!(
            binned <= 1.05 * sweep,
            "{name}: bins {binned}, all cuts {sweep}"
        );
        assert!(
            fine <= 1.01 * binned && fine <= 1.03 * sweep,
            "{name}: bins and all cuts {fine}, only bins {binned}, only cuts {sweep}"
        );
        assert!(
            1.05 * binned <= median,
            "{name}: bins {binned}, median {median}"
        );
        assert!(
            bottom_up <= 1.02 * median,
            "{name}: bottom-up {bottom_up}, median {median}"
        );
    }
}

#[test]
fn the_cost_of_a_tree_of_two_leaves_is_what_it_is_by_hand() {
    // Two unit cubes at the ends of a 1 × 1 × 4 m beam: areas 18, 6 and 6.
    let cube = |x: f32| Aabb {
        min: Vec3::X * x,
        max: Vec3::X * x + Vec3::ONE,
    };
    let flat = build(&[cube(0.0), cube(3.0)], Method::Sweep, &COST);
    let cost = sah_cost(flat.root.as_ref(), &flat.pairs, &COST);
    assert!(
        (cost - (1.0 + 6.0 / 18.0 + 6.0 / 18.0)).abs() < 1e-6,
        "1 + ⅓ + ⅓, not {cost}"
    );
}

#[test]
fn validate_notices_what_is_broken() {
    let boxes = boxes((0..50).map(|i| Vec3::new((i % 7) as f32, i as f32, (i % 3) as f32)));
    let sound = build(&boxes, Method::Sweep, &COST);
    assert_eq!(check(&sound, &boxes), Ok(()));
    let broken = |spoil: fn(&mut Flat, &mut Vec<Aabb>)| {
        let mut flat = sound.clone();
        let mut in_order: Vec<_> = flat.order.iter().map(|&i| boxes[i as usize]).collect();
        spoil(&mut flat, &mut in_order);
        validate(flat.root.as_ref(), &flat.pairs, &in_order)
    };
    assert!(
        broken(|_, boxes| boxes[9].max.x += 1.0).is_err(),
        "a shape sticks out"
    );
    assert!(
        broken(|_, boxes| boxes.extend([Aabb::EMPTY])).is_err(),
        "a shape is lost"
    );
    assert!(broken(|flat, _| flat.root = None).is_err(), "no root");
    assert!(
        broken(|flat, _| flat.pairs.swap(1, 2)).is_err(),
        "not depth-first"
    );
    assert!(
        broken(|flat, _| flat.pairs.truncate(3)).is_err(),
        "a pair is missing"
    );
    let grow = |flat: &mut Flat, _: &mut Vec<Aabb>| {
        let [mut left, right] = flat.pairs[3].nodes();
        left.bounds.max.y += 0.5;
        flat.pairs[3] = Pair::new([left, right]);
    };
    assert!(broken(grow).is_err(), "a box is larger than what is in it");
}

//! The walk visits the right cells, in order, and ends.

use glam::{UVec3, Vec3, uvec3, vec3};
use proptest::prelude::*;
use raybook::inside::grid::{Lattice, walk};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray, slab};
use std::ops::ControlFlow;

fn lattice() -> Lattice {
    let bounds = Aabb {
        min: Vec3::ZERO,
        max: vec3(4.0, 3.0, 2.0),
    };
    Lattice::new(&bounds, uvec3(4, 3, 2))
}

fn visits(ray: &Ray, within: Interval) -> Vec<(UVec3, Interval)> {
    let mut visits = Vec::new();
    walk(&lattice(), ray, within, |cell, inside| {
        visits.push((cell, inside));
        ControlFlow::Continue(())
    });
    visits
}

#[test]
fn along_an_axis_the_zeros_may_have_any_sign() {
    for (y, z) in [(0.0, 0.0), (-0.0, 0.0), (0.0, -0.0), (-0.0, -0.0)] {
        for (from, x, order) in [(-1.0, 1.0, [0, 1, 2, 3]), (5.0, -1.0, [3, 2, 1, 0])] {
            let ray = Ray::new(vec3(from, 1.5, 0.5), Dir3::new_or(vec3(x, y, z), Dir3::Z));
            let cells: Vec<_> = visits(&ray, Interval::AHEAD)
                .into_iter()
                .map(|(cell, _)| cell)
                .collect();
            assert_eq!(cells, order.map(|x| uvec3(x, 1, 0)), "{ray:?}");
        }
    }
}

#[test]
fn a_ray_beside_the_lattice_visits_nothing() {
    for origin in [
        vec3(-1.0, 3.5, 0.5),
        vec3(-1.0, -0.5, 0.5),
        vec3(-1.0, 1.5, 2.5),
    ] {
        for toward in [Vec3::X, vec3(1.0, -0.0, -0.0), Vec3::NEG_X] {
            let ray = Ray::new(origin, Dir3::new_or(toward, Dir3::Z));
            assert_eq!(visits(&ray, Interval::AHEAD), [], "{ray:?}");
        }
    }
}

#[test]
fn numbers_that_make_no_sense_end_too() {
    let strange = [
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        1e38,
        -1e-45,
        0.0,
        1.0,
    ];
    for a in strange {
        for b in strange {
            for direction in [
                Dir3::X,
                -Dir3::Y,
                Dir3::new_or(vec3(1e-30, 1.0, -1e-38), Dir3::Z),
            ] {
                let ray = Ray::new(vec3(a, b, 0.5), direction);
                for within in [
                    Interval::AHEAD,
                    Interval::new(a, b),
                    Interval::new(f32::NEG_INFINITY, f32::INFINITY),
                ] {
                    assert!(
                        visits(&ray, within).len() <= 9,
                        "{ray:?} {within:?}: at most 4 + 3 + 2 cells"
                    );
                }
            }
        }
    }
}

#[test]
fn the_visitor_ends_the_walk() {
    let mut seen = 0;
    walk(
        &lattice(),
        &Ray::new(vec3(-1.0, 1.5, 0.5), Dir3::X),
        Interval::AHEAD,
        |_, _| {
            seen += 1;
            if seen == 2 {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        },
    );
    assert_eq!(seen, 2, "it said stop in the second cell");
}

proptest! {
    /// Origins on planes, edges and corners, and far away; directions along axes, diagonals and any.
    #[test]
    fn every_cell_that_the_ray_is_in_is_visited_at_that_distance(
        on in prop::array::uniform3(-2_i16..6),
        off in prop_oneof![Just([0.0_f32; 3]), prop::array::uniform3(0.0_f32..1.0)],
        toward in prop::array::uniform3(prop_oneof![Just(0.0_f32), Just(-0.0), Just(1.0), Just(-1.0), -1.0_f32..1.0]),
        back in prop_oneof![Just(0.0_f32), Just(3.0), Just(1000.0)],
        max in prop_oneof![Just(f32::INFINITY), 0.1_f32..8.0],
    ) {
        let direction = Dir3::new_or(Vec3::from(toward), Dir3::X);
        let origin = Vec3::from(on.map(f32::from)) + Vec3::from(off) - back * *direction;
        let ray = Ray::new(origin, direction);
        let within = Interval::new(0.0, back + max);
        let visits = visits(&ray, within);
        prop_assert!(visits.len() <= 9);
        for pair in visits.windows(2) {
            let (a, b) = (pair[0].0.as_ivec3(), pair[1].0.as_ivec3());
            prop_assert_eq!((b - a).abs().element_sum(), 1, "neighbours share a face");
            prop_assert_eq!(pair[0].1.max, pair[1].1.min, "it enters where it leaves");
        }
        // What a ray is certainly inside of, and not only touches.
        let hair = 1e-6 * (10.0 + origin.abs().max_element());
        for x in 0..4 { for y in 0..3 { for z in 0..2 {
            let cell = uvec3(x, y, z);
            let core = lattice().bounds_of(cell, cell).grown(-hair);
            if let Some(inside) = slab::clip(&core, &ray, within).filter(|i| i.max - i.min > 4.0 * hair) {
                let middle = 0.5 * (inside.min + inside.max);
                let visited = visits.iter().any(|(c, i)| *c == cell && i.min <= middle && middle <= i.max);
                prop_assert!(visited, "cell {} at {} of {:?} is not among {:?}", cell, middle, ray, visits);
            }
        }}}
    }
}

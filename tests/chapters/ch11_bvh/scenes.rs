//! Triangles and rays of which some are always awkward.

use glam::{Vec3, vec3};
use proptest::prelude::*;
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::mesh::Facet;

/// A coordinate: often one of a few, so that triangles touch, coincide and lie in planes.
fn coordinate() -> impl Strategy<Value = f32> {
    prop_oneof![
        3 => (-3..=3_i32).prop_map(|i| i as f32),
        2 => -3.0_f32..3.0,
        1 => Just(-0.0_f32),
    ]
}

fn point() -> impl Strategy<Value = Vec3> {
    [coordinate(), coordinate(), coordinate()].prop_map(Vec3::from)
}

/// Corners: of any triangle, of none with an area, of a huge one, of a tiny one.
fn corners() -> impl Strategy<Value = [Vec3; 3]> {
    prop_oneof![
        6 => [point(), point(), point()],
        1 => (point(), point()).prop_map(|(p, q)| [p, q, q]),
        1 => point().prop_map(|p| [p; 3]),
        1 => [point(), point(), point()].prop_map(|c| c.map(|p| 1e3 * p)),
        1 => (point(), [point(), point(), point()]).prop_map(|(at, c)| c.map(|p| at + 1e-3 * p)),
    ]
}

/// Facets, some of them twice.
pub(super) fn facets() -> impl Strategy<Value = Vec<Facet>> {
    (prop::collection::vec(corners(), 0..60), 0..10_usize).prop_map(|(mut all, twice)| {
        let again: Vec<_> = all.iter().copied().take(twice).collect();
        all.extend(again);
        let facet = |(corners, id)| Facet { corners, id };
        all.into_iter().zip(0..).map(facet).collect()
    })
}

/// A ray from inside, outside or a corner, in any direction or along an axis with −0.0; and an interval.
pub(super) fn asked() -> impl Strategy<Value = (Ray, Interval)> {
    let axis = prop_oneof![
        Just(vec3(1.0, 0.0, -0.0)),
        Just(vec3(-0.0, -1.0, 0.0)),
        Just(vec3(-0.0, 0.0, 1.0)),
        Just(vec3(-1.0, 0.0, 1.0)),
    ];
    let direction = prop_oneof![3 => point(), 2 => axis];
    let within = prop_oneof![
        3 => Just(Interval::AHEAD),
        1 => (0.0_f32..4.0, 0.0_f32..8.0).prop_map(|(min, max)| Interval::new(min, max)),
    ];
    (point(), direction, within).prop_map(|(origin, direction, within)| {
        let direction = Dir3::new_or(direction, Dir3::X);
        (Ray::new(origin, direction), within)
    })
}

/// The scene at another scale.
pub(super) fn scaled(facets: &[Facet], scale: f32) -> Vec<Facet> {
    let grow = |facet: &Facet| Facet {
        corners: facet.corners.map(|p| p * scale),
        ..*facet
    };
    facets.iter().map(grow).collect()
}

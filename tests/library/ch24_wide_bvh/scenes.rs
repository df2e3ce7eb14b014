//! Scenes and rays for the tests: of all kinds that went wrong somewhere.

use glam::{Vec3, vec3};
use proptest::prelude::*;
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::mesh::Facet;

/// Facets with their places in the list as ids.
pub(super) fn facets(corners: impl IntoIterator<Item = [Vec3; 3]>) -> Vec<Facet> {
    let numbered = corners.into_iter().zip(0..);
    numbered
        .map(|(corners, id)| Facet { corners, id })
        .collect()
}

fn point(half: f32) -> impl Strategy<Value = Vec3> {
    prop::array::uniform3(-half..half).prop_map(Vec3::from)
}

/// A point of a coarse lattice: triangles of such points share edges, planes and places.
fn lattice_point() -> impl Strategy<Value = Vec3> {
    prop::array::uniform3(-2_i8..=2).prop_map(|p| Vec3::from(p.map(f32::from)))
}

/// Triangles that have an area, and are not much thinner than long.
fn fair(corners: &[Vec3; 3]) -> bool {
    let [a, b, c] = *corners;
    let longest = (b - a).length().max((c - a).length()).max((c - b).length());
    (b - a).cross(c - a).length() > 0.01 * longest * longest
}

fn triangle() -> impl Strategy<Value = [Vec3; 3]> {
    prop_oneof![
        6 => (point(2.0), prop::array::uniform3(point(0.8))).prop_map(|(at, p)| p.map(|p| at + p)),
        3 => prop::array::uniform3(lattice_point()),
        1 => prop::array::uniform3(point(1e4)),
        1 => (point(2.0), prop::array::uniform3(point(1e-3))).prop_map(|(at, p)| p.map(|p| at + p)),
    ]
    .prop_filter("an area", fair)
}

/// A scene: from none to two hundred triangles, some of them several times, at any scale.
pub(super) fn scene() -> impl Strategy<Value = (Vec<Facet>, f32)> {
    let triangles = prop::collection::vec((triangle(), 1..4_usize), 0..100);
    (triangles, -6..=6_i32).prop_map(|(triangles, scale)| {
        let scale = 10.0_f32.powi(scale);
        let repeated = triangles.into_iter().flat_map(|(t, times)| vec![t; times]);
        (facets(repeated.map(|t| t.map(|p| scale * p))), scale)
    })
}

/// Triangles without area among others.
pub(super) fn with_degenerate() -> impl Strategy<Value = Vec<Facet>> {
    let line = (point(2.0), point(1.0), 0.0_f32..1.0).prop_map(|(p, d, s)| [p, p + d, p + s * d]);
    let dot = point(2.0).prop_map(|p| [p; 3]);
    let not_a_number = point(2.0).prop_map(|p| [p, Vec3::NAN, p + Vec3::X]);
    let endless = point(2.0).prop_map(|p| [p, p + Vec3::X, vec3(0.0, f32::INFINITY, 0.0)]);
    let any = prop_oneof![3 => triangle(), 1 => line, 1 => dot, 1 => not_a_number, 1 => endless];
    prop::collection::vec(any, 0..60).prop_map(facets)
}

/// A ray, of a size that fits the unit scale: from anywhere, from far away, along axes with ±0, on the lattice.
pub(super) fn ray() -> impl Strategy<Value = (Ray, Interval)> {
    let component = prop_oneof![Just(0.0_f32), Just(-0.0_f32), -1.0_f32..1.0];
    let axis = prop_oneof![Just(Vec3::X), Just(Vec3::Y), Just(Vec3::Z)];
    let along = (axis, any::<bool>(), any::<bool>()).prop_map(|(axis, back, minus)| {
        let zero = if minus { -0.0 } else { 0.0 };
        let axis = if back { -axis } else { axis };
        axis.map(|v| if v == 0.0 { zero } else { v })
    });
    let direction = prop_oneof![
        4 => point(1.0),
        2 => prop::array::uniform3(component).prop_map(Vec3::from),
        2 => along,
        1 => lattice_point(),
    ];
    let origin = prop_oneof![
        4 => point(4.0),
        2 => lattice_point(),
        1 => point(1e5),
    ];
    let interval = prop_oneof![
        4 => Just(Interval::AHEAD),
        1 => (0.0_f32..3.0, 0.0_f32..9.0).prop_map(|(min, long)| Interval::new(min, min + long)),
        1 => (-5.0_f32..0.0).prop_map(|min| Interval::new(min, f32::INFINITY)),
    ];
    (origin, direction, interval)
        .prop_map(|(o, d, within)| (Ray::new(o, Dir3::new_or(d, Dir3::X)), within))
}

/// The ray in a scene of another scale.
pub(super) fn scaled((ray, within): (Ray, Interval), scale: f32) -> (Ray, Interval) {
    (
        Ray::new(scale * ray.origin, ray.direction),
        Interval::new(scale * within.min, scale * within.max),
    )
}

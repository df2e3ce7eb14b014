//! Chapter 04: the basis that lays texture coordinates on a plane.

use crate::ch04_plane::rays::{random_direction, ray};
use glam::{Vec3, vec3};
use raybook::math::{basis::Basis, dir3::Dir3, pcg};

#[test]
fn every_direction_has_a_right_handed_basis() {
    let mut rng = pcg::stream(4, 5);
    // Ever nearer to ±z: about −z, a method without Duff's sign divides by what is nearly 0.
    let poles = (0..60_u8).map(|i| {
        let small = 0.5_f32.powi(i32::from(i / 2));
        let z = if i % 2 == 0 { 1.0 } else { -1.0 };
        ray(Vec3::ZERO, vec3(small, -small, z)).direction
    });
    let axes = [Dir3::X, Dir3::Y, Dir3::Z]
        .into_iter()
        .flat_map(|d| [d, -d]);
    let random = (0..20_000).map(|_| random_direction(&mut rng));
    for d in poles.chain(axes).chain(random) {
        let basis = Basis::around(d);
        let [x, y, z] = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| basis.to_world(axis));
        let skew = x.dot(y).abs().max(y.dot(z).abs()).max(z.dot(x).abs());
        // A few roundings of numbers up to 1; measured: 3.1e-7 and 3.7e-7.
        assert!(skew < 1e-6, "{d:?}: {basis:?} has right angles");
        let off = x.cross(y).distance(z);
        assert!(
            off < 1e-6 && z == *d,
            "{d:?}: {basis:?} is right-handed, and z is d"
        );
    }
}

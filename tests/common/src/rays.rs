//! Rays for tests: named ones, and random ones.

use glam::Vec3;
use rand::RngExt;
use raybook::math::{dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use raybook::shape::{Hit, Shape, Surface};
use std::fmt::Debug;

/// The ray from a point towards a direction of any length.
pub fn ray(origin: Vec3, toward: Vec3) -> Ray {
    Ray::new(
        origin,
        Dir3::new(toward).expect("a test's direction is one"),
    )
}

/// A direction, all of them equally likely.
pub fn random_direction(rng: &mut Pcg) -> Dir3 {
    loop {
        let v = Vec3::from_array(std::array::from_fn(|_| rng.random_range(-1.0..1.0)));
        if let Some(d) = Dir3::new(v).filter(|_| v.length() < 1.0) {
            return d;
        }
    }
}

/// A scale from 1e-6 to 1e6, all powers of ten equally likely.
pub fn random_scale(rng: &mut Pcg) -> f32 {
    10.0_f32.powf(rng.random_range(-6.0..6.0))
}

/// The hit ahead of a ray that cannot miss, and the surface there.
#[track_caller]
pub fn sure_hit(shape: &(impl Shape + Debug), ray: &Ray) -> (Hit, Surface) {
    let hit = shape.hit(ray, Interval::AHEAD);
    let hit = hit.unwrap_or_else(|| panic!("{ray:?} cannot miss {shape:?}"));
    (hit, shape.surface(ray, &hit))
}

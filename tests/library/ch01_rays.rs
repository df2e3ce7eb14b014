//! Chapter 1: directions and rays; the camera, the streams of random numbers and the film loop have files of their own.

mod camera;
mod film;
mod refine;
mod streams;

use glam::{Vec3, vec3};
use raybook::math::{dir3::Dir3, ray::Ray};

/// A few roundings of `f32` on numbers of about 1.
const ROUNDING: f32 = 4.0 * f32::EPSILON;

#[test]
fn every_vector_with_a_direction_becomes_one_of_length_one() {
    let shape = vec3(1.0, -2.0, 3.0);
    for scale in [1e-44, 1e-38, 1e-30, 1e-10, 1.0, 1e10, 1e30, 1e38] {
        let d = Dir3::new(scale * shape).unwrap_or_else(|| panic!("{scale} times a vector points"));
        let length = d.as_dvec3().length();
        assert!(
            (length - 1.0).abs() < 2e-7,
            "length {length} at scale {scale}"
        );
        // Among the subnormals a vector has few digits: 1e-44 is 7 units, so a direction is right to a tenth.
        let off = d.distance(shape / shape.length());
        let digits = if scale < 1e-38 { 0.2 } else { ROUNDING };
        assert!(off < digits, "the direction is {off} off at scale {scale}");
    }
    let diagonal = Dir3::new(Vec3::splat(f32::MAX)).expect("the largest vector points too");
    assert!(
        (*diagonal - Vec3::splat(1.0 / 3.0_f32.sqrt())).length() < ROUNDING,
        "{diagonal:?}"
    );
}

#[test]
fn a_vector_without_a_direction_becomes_none() {
    let (inf, nan) = (f32::INFINITY, f32::NAN);
    for v in [
        Vec3::ZERO,
        -Vec3::ZERO,
        vec3(nan, 1.0, 0.0),
        vec3(0.0, nan, 0.0),
        Vec3::NAN,
        vec3(inf, 0.0, 0.0),
        vec3(1.0, 0.0, -inf),
        vec3(inf, nan, 0.0),
    ] {
        assert_eq!(Dir3::new(v), None, "{v} has no direction");
        assert_eq!(Dir3::new_or(v, Dir3::X), Dir3::X, "{v} is replaced");
    }
}

#[test]
fn the_opposite_direction_has_length_one_too() {
    let d = Dir3::new(vec3(3.0, -4.0, 12.0)).expect("it points");
    assert_eq!(*-d, -*d, "negation turns it round");
    assert_eq!(d.dot(*-d), -d.dot(*d), "and keeps its length");
}

#[test]
fn t_is_a_distance_along_the_ray() {
    let d = Dir3::new(vec3(2.0, 3.0, 6.0)).expect("it points");
    let ray = Ray::new(vec3(1.0, -1.0, 0.5), d);
    assert_eq!(ray.at(0.0), ray.origin, "t = 0 is the origin");
    // (2, 3, 6) has length 7, so that t = 14 is twice the vector.
    let expected = vec3(5.0, 5.0, 12.5);
    assert!(
        ray.at(14.0).distance(expected) < 14.0 * ROUNDING,
        "{}",
        ray.at(14.0)
    );
    assert!(
        ray.at(-7.0).distance(vec3(-1.0, -4.0, -5.5)) < 7.0 * ROUNDING,
        "t may be negative"
    );
}

//! Snell's law and Fresnel's equations. Published values are in `tests/library/published/fresnel.rs`.

use glam::{Vec3, vec3};
use proptest::prelude::*;
use raybook::material::fresnel::{Reflectance, fresnel, schlick};
use raybook::material::refract::refract;
use raybook::math::dir3::Dir3;

fn cosine(degrees: f64) -> f32 {
    degrees.to_radians().cos() as f32
}

/// Rs, Rp and R in f64, by sines and tangents of the angles (the form in which Fresnel wrote them).
fn by_angles(degrees: f64, n1: f64, n2: f64) -> [f64; 3] {
    let one = degrees.to_radians();
    let two = (n1 / n2 * one.sin()).asin();
    let s = ((one - two).sin() / (one + two).sin()).powi(2);
    let p = ((one - two).tan() / (one + two).tan()).powi(2);
    [s, p, 0.5 * (s + p)]
}

#[test]
fn every_angle_reflects_what_the_sines_and_tangents_say() {
    for (n1, n2) in [(1.0, 1.5), (1.5, 1.0), (1.0, 2.417), (1.333, 1.5)] {
        for tenths in 1..900 {
            let degrees = f64::from(tenths) / 10.0;
            let [s, p, r] = by_angles(degrees, n1, n2);
            if s.is_nan() {
                continue; // total reflection: there is no second angle
            }
            let got = fresnel(cosine(degrees), n1 as f32, n2 as f32);
            for (name, got, exact) in [
                ("Rs", got.s, s),
                ("Rp", got.p, p),
                ("R", got.unpolarised, r),
            ] {
                // At the critical angle R rises straight up: the rounding of cos θ₁ is seen.
                let tolerance = if r > 0.7 { 1e-4 } else { 1e-5 };
                assert!(
                    (f64::from(got) - exact).abs() < tolerance,
                    "from {n1} into {n2} at {degrees}°: {name} is {got}, not {exact}"
                );
            }
        }
    }
}

#[test]
fn no_parallel_light_is_reflected_at_brewsters_angle() {
    let brewster = 1.5_f64.atan().to_degrees();
    let into = fresnel(cosine(brewster), 1.0, 1.5);
    let out = fresnel(cosine(90.0 - brewster), 1.5, 1.0);
    assert!(into.p < 1e-10 && out.p < 1e-10, "{} and {}", into.p, out.p);
    assert!(into.s > 0.14, "but square to the plane, {} is", into.s);
}

#[test]
fn total_reflection_begins_at_the_critical_angle() {
    let before = fresnel(cosine(41.80), 1.5, 1.0);
    let behind = fresnel(cosine(41.82), 1.5, 1.0);
    assert!(before.unpolarised < 0.95, "at 41.80° {before:?}");
    assert_eq!(behind, Reflectance::ALL, "at 41.82°");
    let leaving = |degrees: f64| {
        let direction = vec3(degrees.to_radians().sin() as f32, cosine(degrees), 0.0);
        refract(
            Dir3::new(direction).expect("a direction"),
            Dir3::Y,
            1.0,
            1.5,
        )
    };
    assert!(leaving(41.80).is_some(), "at 41.80° a ray leaves");
    assert_eq!(leaving(41.82), None, "at 41.82° none does");
}

#[test]
fn equal_media_reflect_nothing_and_bend_nothing() {
    for degrees in [0.0, 30.0, 60.0, 89.0, 90.0] {
        let got = fresnel(cosine(degrees).max(0.0), 1.5, 1.5);
        assert_eq!(got, Reflectance::NOTHING, "at {degrees}°");
    }
    let i = Dir3::new(vec3(0.6, -0.8, 0.0)).expect("a direction");
    let t = refract(i, Dir3::Y, 1.5, 1.5).expect("it goes through");
    assert!(t.distance(*i) < 1e-6, "{t:?} is not straight on");
}

#[test]
fn schlick_is_a_few_hundredths_off_at_most() {
    let mut worst = 0.0_f32;
    for (n1, n2) in [(1.0, 1.5), (1.5, 1.0)] {
        for degrees in 0..90 {
            let cosine = cosine(f64::from(degrees));
            let off = schlick(cosine, n1, n2) - fresnel(cosine, n1, n2).unpolarised;
            worst = worst.max(off.abs());
        }
    }
    assert!((0.01..0.06).contains(&worst), "it is off by up to {worst}");
}

fn direction() -> impl Strategy<Value = Dir3> {
    let x = || -1.0_f32..1.0;
    (x(), x(), x()).prop_filter_map("too short", |(x, y, z)| {
        let v = vec3(x, y, z);
        (v.length() > 0.1).then(|| Dir3::new(v)).flatten()
    })
}

fn side_of(d: Dir3, normal: Dir3) -> f32 {
    d.dot(*normal).signum()
}

proptest! {
    #[test]
    fn a_refracted_ray_obeys_snell_and_stays_in_the_plane(i in direction(), normal in direction(), outside in 1.0_f32..2.5, inside in 1.0_f32..2.5) {
        let (n1, n2) = if i.dot(*normal) < 0.0 { (outside, inside) } else { (inside, outside) };
        let sine = |d: Vec3| d.cross(*normal).length();
        match refract(i, normal, outside, inside) {
            Some(t) => {
                prop_assert!((n1 * sine(*i) - n2 * sine(*t)).abs() < 1e-5, "n₁ sin θ₁ = n₂ sin θ₂");
                prop_assert!(t.dot(i.cross(*normal)).abs() < 1e-5, "i, n and t lie in one plane");
                prop_assert!(t.dot(*i) > -1e-5, "it is bent by no more than 90°");
                prop_assert_eq!(side_of(t, normal), side_of(i, normal), "it goes through");
                prop_assert!((t.length() - 1.0).abs() < 1e-6, "a direction has length 1");
            }
            None => prop_assert!(n1 * sine(*i) > n2 * (1.0 - 1e-6), "sin θ₂ would be more than 1"),
        }
    }

    #[test]
    fn the_way_back_is_the_same_way(i in direction(), normal in direction(), inside in 1.0_f32..2.5) {
        if let Some(t) = refract(i, normal, 1.0, inside) {
            // Flat rays lose digits: cos θ is the root of a small difference.
            prop_assume!(i.dot(*normal).abs() > 0.05 && t.dot(*normal).abs() > 0.05);
            let back = refract(-t, normal, 1.0, inside).expect("where it came from there is a way");
            prop_assert!(back.distance(-*i) < 1e-4, "{:?} is not {:?} turned round", back, i);
            let (n1, n2) = if i.dot(*normal) < 0.0 { (1.0, inside) } else { (inside, 1.0) };
            let there = fresnel(i.dot(*normal).abs(), n1, n2).unpolarised;
            let back = fresnel(t.dot(*normal).abs(), n2, n1).unpolarised;
            prop_assert!((there - back).abs() < 1e-4, "{there} is reflected on the way, {back} on the way back");
        }
    }

    #[test]
    fn shares_are_between_none_and_all(cos1 in 0.0_f32..=1.0, n1 in 1.0_f32..4.0, n2 in 1.0_f32..4.0) {
        let Reflectance { s, p, unpolarised } = fresnel(cos1, n1, n2);
        for share in [s, p, unpolarised] {
            prop_assert!((0.0..=1.0).contains(&share), "{} of all light", share);
        }
        prop_assert!(s >= p - 1e-6, "what swings square to the plane is reflected more: {} and {}", s, p);
    }
}

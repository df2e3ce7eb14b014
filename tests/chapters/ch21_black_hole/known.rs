//! What is known from the theory. Published values are in `tests/library/published/deflection.rs`.

use glam::{DVec3, dvec3};
use raybook::render::curved::deflection::deflection_angle;
use raybook::render::curved::follow::{Fate, follow};
use raybook::render::curved::observer::{seen, shadow_half_angle};
use raybook::render::curved::{CRITICAL, Photon};
use raybook_chapters::ch21_black_hole::deflection_plot::followed;
use std::ops::ControlFlow;

#[test]
fn rays_followed_step_by_step_are_turned_by_the_angles_of_the_formula() {
    for b in [2.6, 2.7, 3.0, 4.0, 5.0, 10.0, 20.0, 100.0, 1000.0] {
        let formula = deflection_angle(b).expect("it gets away");
        let got = followed(b).expect("it gets away");
        assert!(
            (got - formula).abs() < 1e-4,
            "b = {b}: {got} rad, and not {formula}"
        );
    }
}

#[test]
fn the_critical_impact_parameter_parts_those_that_fall_from_those_that_escape() {
    assert!(
        (CRITICAL - 1.5 * 3.0_f64.sqrt()).abs() < 1e-15,
        "b_c = 3√3/2"
    );
    for nearer in [0.0, 1.0, 2.5, 2.597, 2.598] {
        assert_eq!(followed(nearer), None, "b = {nearer}");
        assert_eq!(deflection_angle(nearer), None, "b = {nearer}");
    }
    for farther in [2.5982, 2.599, 2.7] {
        assert!(followed(farther).is_some(), "b = {farther}");
        assert!(deflection_angle(farther).is_some(), "b = {farther}");
    }
}

#[test]
fn light_circles_on_the_photon_sphere() {
    let mut photon = Photon {
        x: dvec3(1.5, 0.0, 0.0),
        v: DVec3::Y,
    };
    // Once around: 2π · 1.5 at speed 1.
    let steps = 2000;
    for _ in 0..steps {
        let step = 3.0 * std::f64::consts::PI / f64::from(steps);
        (photon, _) = raybook::render::curved::geodesic::geodesic_step(photon, step);
    }
    let off = photon.x.distance(dvec3(1.5, 0.0, 0.0));
    assert!(
        off < 1e-5,
        "after one turn it is {off} away from where it was"
    );
}

#[test]
fn close_to_the_horizon_almost_all_of_the_sky_is_black() {
    let angle = shadow_half_angle(1.01).to_degrees();
    assert!(angle > 160.0, "{angle}°");
}

#[test]
fn rays_of_an_observer_fall_inside_the_shadow_and_escape_outside() {
    for r in [1.2, 1.5, 2.0, 3.0, 5.0, 10.0, 100.0] {
        let edge = shadow_half_angle(r);
        for (angle, falls) in [(edge - 1e-4, true), (edge + 1e-4, false)] {
            let (sine, cosine) = angle.sin_cos();
            // A plane askew, for the coordinates must not matter.
            let up = dvec3(2.0, 3.0, 6.0) / 7.0;
            let side = dvec3(3.0, -6.0, 2.0) / 7.0;
            let photon = seen(r * up, sine * side - cosine * up);
            let fate = follow(photon, 1e-10, |_| ControlFlow::Continue(()));
            assert_eq!(
                fate == Fate::Fell,
                falls,
                "r = {r}, {}° from the middle: {fate:?}",
                angle.to_degrees()
            );
        }
    }
}

#[test]
fn an_observers_ray_has_the_impact_parameter_of_its_angle() {
    for (r, degrees) in [(2.0, 30.0), (3.0, 90.0), (10.0, 14.0), (1.1, 120.0)] {
        let angle = f64::to_radians(degrees);
        let photon = seen(r * DVec3::X, dvec3(-angle.cos(), angle.sin(), 0.0));
        let expected = r * angle.sin() / (1.0 - 1.0 / r).sqrt();
        let got = photon.impact_parameter();
        assert!(
            (got - expected).abs() < 1e-12 * expected,
            "r = {r}, {degrees}°: b is {got}, not {expected}"
        );
    }
}

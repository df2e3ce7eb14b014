//! Steps and rays: their order, what they keep, where they stop.

use glam::{DVec3, dvec3};
use proptest::prelude::*;
use raybook::render::curved::follow::{Fate, follow};
use raybook::render::curved::geodesic::{between, geodesic_step};
use raybook::render::curved::{HORIZON, Photon};
use std::ops::ControlFlow;

fn photon() -> impl Strategy<Value = Photon> {
    let coordinate = || -1.0..1.0_f64;
    let vector =
        move || (coordinate(), coordinate(), coordinate()).prop_map(|(x, y, z)| dvec3(x, y, z));
    (vector(), vector(), 1.01..50.0_f64)
        .prop_filter("directions", |(x, v, _)| {
            x.length() > 0.1 && v.length() > 0.1
        })
        .prop_map(|(x, v, r)| Photon {
            x: r * x.normalize(),
            v,
        })
}

proptest! {
    #[test]
    fn no_step_crosses_the_horizon(photon in photon()) {
        follow(photon, 1e-6, |piece| {
            assert!(piece.to.x.length() > HORIZON, "{piece:?} ends inside");
            ControlFlow::Continue(())
        });
    }

    #[test]
    fn energy_and_angular_momentum_stay_what_they_are(photon in photon()) {
        let (energy, momentum) = (photon.energy(), photon.x.cross(photon.v));
        follow(photon, 1e-9, |piece| {
            let off = piece.to.x.cross(piece.to.v).distance(momentum);
            assert!(off < 1e-4 * (1.0 + momentum.length()), "angular momentum is off by {off}");
            let off = (piece.to.energy() - energy).abs();
            assert!(off < 1e-4 * (1.0 + energy), "energy is off by {off}");
            ControlFlow::Continue(())
        });
    }

    #[test]
    fn the_same_ray_at_another_speed_ends_the_same(photon in photon(), speed in 0.01..100.0_f64) {
        let fate = |p| follow(p, 1e-9, |_| ControlFlow::Continue(()));
        let faster = Photon { v: speed * photon.v, ..photon };
        match (fate(photon), fate(faster)) {
            (Fate::Escaped(a), Fate::Escaped(b)) => prop_assert!(a.distance(b) < 1e-3, "{a} and {b}"),
            (a, b) => prop_assert_eq!(a, b),
        }
    }
}

#[test]
fn half_the_step_has_an_eighth_of_the_error() {
    let start = Photon {
        x: dvec3(2.0, 0.5, -1.0),
        v: dvec3(-0.4, 0.8, 0.3),
    };
    let ending = |steps: u32| {
        let step = 2.0 / f64::from(steps);
        (0..steps).fold(start, |p, _| geodesic_step(p, step).0).x
    };
    let exact = ending(20_000);
    let error = |steps| ending(steps).distance(exact);
    let ratio = error(40) / error(80);
    assert!(
        (7.0..9.0).contains(&ratio),
        "twice the steps are {ratio} times as good"
    );
}

#[test]
fn the_estimate_is_above_the_error_and_shrinks_with_the_third_power_of_the_step() {
    let start = Photon {
        x: dvec3(2.0, 0.5, -1.0),
        v: dvec3(-0.4, 0.8, 0.3),
    };
    let (after, estimate) = geodesic_step(start, 0.3);
    let fine = (0..1000).fold(start, |p, _| geodesic_step(p, 0.3 / 1000.0).0);
    let error = after.x.distance(fine.x) / start.x.length();
    assert!(
        estimate > error,
        "the estimate, {estimate}, hides the error, {error}"
    );
    let (_, of_half) = geodesic_step(start, 0.15);
    let ratio = estimate / of_half;
    assert!(
        (6.0..10.0).contains(&ratio),
        "half the step has 1/{ratio} of the estimate"
    );
}

#[test]
fn tighter_tolerances_make_more_and_better_steps() {
    let start = Photon {
        x: dvec3(-20.0, 2.8, 0.0),
        v: DVec3::X,
    };
    let walk = |tolerance| {
        let mut steps = 0;
        let fate = follow(start, tolerance, |_| {
            steps += 1;
            ControlFlow::Continue(())
        });
        let Fate::Escaped(toward) = fate else {
            panic!("b = 2.8 gets away, and this {fate:?}");
        };
        (steps, toward)
    };
    let (_, exact) = walk(1e-11);
    let (mut steps_before, mut error_before) = (0, f64::INFINITY);
    for tolerance in [1e-4, 1e-6, 1e-8] {
        let (steps, toward) = walk(tolerance);
        let error = toward.distance(exact);
        assert!(steps > steps_before, "{tolerance}: {steps} steps");
        assert!(error < 0.5 * error_before, "{tolerance}: wrong by {error}");
        (steps_before, error_before) = (steps, error);
    }
}

#[test]
fn rays_through_the_middle_are_straight_and_rays_from_nowhere_end() {
    let fate = |x: DVec3, v: DVec3| follow(Photon { x, v }, 1e-6, |_| ControlFlow::Continue(()));
    assert_eq!(
        fate(dvec3(9.0, 0.0, 0.0), DVec3::NEG_X),
        Fate::Fell,
        "aimed at the middle"
    );
    assert_eq!(
        fate(dvec3(1.2, 0.0, 0.0), DVec3::X),
        Fate::Escaped(DVec3::X),
        "straight up"
    );
    assert_eq!(
        fate(dvec3(0.5, 0.0, 0.0), DVec3::X),
        Fate::Fell,
        "from inside the horizon"
    );
    assert_eq!(fate(DVec3::ZERO, DVec3::X), Fate::Fell, "from the middle");
    assert_eq!(
        fate(dvec3(9.0, 0.0, 0.0), DVec3::ZERO),
        Fate::Fell,
        "no velocity"
    );
    assert_eq!(fate(DVec3::NAN, DVec3::X), Fate::Fell, "no place");
}

#[test]
fn the_curve_between_two_photons_is_the_ray() {
    let from = Photon {
        x: dvec3(0.0, 3.0, 0.0),
        v: DVec3::X,
    };
    let (to, _) = geodesic_step(from, 0.4);
    let (half, _) = geodesic_step(from, 0.2);
    assert_eq!(
        between(&from, &to, 0.4, 0.0),
        from.x,
        "it begins at the first"
    );
    assert!(
        between(&from, &to, 0.4, 1.0).distance(to.x) < 1e-12,
        "it ends at the second"
    );
    let off = between(&from, &to, 0.4, 0.5).distance(half.x);
    assert!(off < 1e-4, "in the middle it is {off} beside the ray");
}

//! What the numbers on a lens mean: circles of confusion, near and far, the hyperfocal distance.

use glam::Vec3;
use proptest::prelude::*;
use raybook::camera::aperture::Aperture;
use raybook::camera::lens::{Lens, LensError};
use raybook::camera::pinhole::Pinhole;
use raybook::camera::thin_lens::ThinLens;

fn lens(focal_length: f32, f_number: f32, focus: f32) -> Lens {
    Lens::new(focal_length, f_number, focus).expect("a lens")
}

#[test]
fn a_50_mm_lens_at_f_2_blurs_as_calculated_by_hand() {
    let lens = lens(0.05, 2.0, 2.0);
    assert_eq!(lens.aperture(), 0.025, "A = f/N");
    for (x, millimetres) in [
        (1.0, 0.641_03),
        (1.5, 0.213_68),
        (2.0, 0.0),
        (3.0, 0.213_68),
        (5.0, 0.384_62),
        (10.0, 0.512_82),
        (f32::INFINITY, 0.641_03),
    ] {
        let c = 1e3 * lens.circle_of_confusion(x);
        assert!(
            (c - millimetres).abs() < 6e-6,
            "at {x} m: {c} mm, and should be {millimetres} mm"
        );
    }
}

#[test]
fn the_thin_lens_equation_holds_and_at_three_focal_lengths_the_film_shows_things_half_as_large() {
    for focus in [0.06_f32, 0.1, 0.15, 2.0, 1e4] {
        let film = lens(0.05, 2.0, focus).film_distance();
        let sum = 1.0 / film + 1.0 / focus;
        assert!(
            (sum * 0.05 - 1.0).abs() < 1e-5,
            "1/film + 1/s = 1/f at {focus} m"
        );
    }
    let film = lens(0.05, 2.0, 0.15).film_distance();
    assert!(
        (film / 0.15 - 0.5).abs() < 1e-6,
        "film/s = 1/2 at s = 3 f, not {film}/0.15"
    );
}

#[test]
fn from_half_the_hyperfocal_distance_on_all_is_sharp_enough() {
    let c = 0.000_03;
    let hyperfocal = lens(0.05, 8.0, 1.0).hyperfocal(c);
    assert!(
        (hyperfocal - 10.466_67).abs() < 1e-4,
        "f + f²/(N c) = 0.05 + 0.0025/(8 · 0.00003), not {hyperfocal}"
    );
    let [near, far] = lens(0.05, 8.0, 1.001 * hyperfocal).depth_of_field(c);
    assert!(
        (near / hyperfocal - 0.5).abs() < 1e-3,
        "near is half of it, not {near}"
    );
    assert_eq!(far, f32::INFINITY, "nothing is too far");
    let [_, far] = lens(0.05, 8.0, 0.999 * hyperfocal).depth_of_field(c);
    assert!(
        far.is_finite() && far > 100.0 * hyperfocal,
        "a little nearer: up to {far}"
    );
}

#[test]
fn lenses_that_make_no_picture_are_refused() {
    let nan = f32::NAN;
    for f in [0.0, -0.05, nan, f32::INFINITY] {
        let refused = Lens::new(f, 2.0, 2.0);
        assert!(
            matches!(refused, Err(LensError::FocalLength(_))),
            "f = {f}: {refused:?}"
        );
    }
    for n in [0.0, -1.0, nan] {
        let refused = Lens::new(0.05, n, 2.0);
        assert!(
            matches!(refused, Err(LensError::FNumber(_))),
            "N = {n}: {refused:?}"
        );
    }
    for s in [0.05, 0.01, -2.0, nan, f32::INFINITY] {
        let refused = Lens::new(0.05, 2.0, s);
        assert!(
            matches!(refused, Err(LensError::Focus { .. })),
            "s = {s}: {refused:?}"
        );
    }
    assert_eq!(
        Lens::new(0.05, 2.0, 0.04)
            .expect_err("too near")
            .to_string(),
        "a lens of 0.05 m cannot focus at 0.04 m: it needs a finite distance above its focal length"
    );
    assert_eq!(
        lens(0.05, f32::INFINITY, 2.0).aperture(),
        0.0,
        "f/∞ is a pin-hole"
    );
}

#[test]
fn what_is_wrong_with_a_camera_of_a_given_aperture_is_told_of_what_was_given() {
    let view = Pinhole::look_at(Vec3::ZERO, Vec3::Z, Vec3::Y, 0.05, 1.5).expect("a camera");
    let refused = |diameter, focus| {
        let camera = ThinLens::with_view(&view, diameter, focus, Aperture::Round);
        camera.expect_err("no lens").to_string()
    };
    for diameter in [-1.0, f32::NAN, f32::INFINITY] {
        let said = refused(diameter, 2.0);
        let name = format!("a diameter of {diameter} m");
        assert!(said.contains(&name), "{said}");
    }
    for focus in [0.0, -1.0, f32::NAN, f32::INFINITY] {
        let said = refused(0.1, focus);
        let name = format!("focus at {focus} m");
        assert!(said.contains(&name), "{said}");
    }
    assert!(
        ThinLens::with_view(&view, 0.0, 2.0, Aperture::Round).is_ok(),
        "a pin-hole"
    );
}

proptest! {
    #[test]
    fn at_both_ends_of_the_depth_of_field_the_circle_is_what_was_allowed(
        f in 0.01_f32..0.3, n in 1.0_f32..32.0, times in 1.5_f32..100.0, share in 0.05_f32..3.0,
    ) {
        let lens = lens(f, n, times * f);
        let at_infinity = lens.circle_of_confusion(f32::INFINITY);
        let c = share * at_infinity;
        let [near, far] = lens.depth_of_field(c);
        prop_assert!(near < lens.focus && lens.focus < far, "the focus is inside: {near} {far}");
        let ends = if share < 0.99 { &[near, far][..] } else { &[near] };
        for &x in ends {
            let at_end = lens.circle_of_confusion(x);
            prop_assert!((at_end / c - 1.0).abs() < 1e-3, "{at_end} at {x}, and should be {c}");
        }
        if share > 1.01 {
            prop_assert_eq!(far, f32::INFINITY);
        }
    }

    #[test]
    fn the_circle_grows_away_from_the_focus_and_shrinks_with_the_f_number(
        s in 0.1_f32..50.0, n in 1.0_f32..22.0, away in 1.05_f32..10.0, more in 1.05_f32..10.0,
    ) {
        let (wide, narrow) = (lens(0.05, n, s), lens(0.05, 2.0 * n, s));
        for away in [away, 1.0 / away] {
            let c = wide.circle_of_confusion(away * s);
            let further = wide.circle_of_confusion(if away > 1.0 { away * more } else { away / more } * s);
            prop_assert!(further > c, "further away: {further} after {c}");
            let half = narrow.circle_of_confusion(away * s);
            prop_assert!((half / c - 0.5).abs() < 1e-5, "twice the f-number: {half}, half of {c}");
        }
    }
}

//! The comparison of pictures accepts what another processor may do, and says what it does not.

use super::pictures::{rendered, with_pixel};
use raybook::image::compare::{Difference, Tolerance, compare};
use raybook::image::{Image, rgb::Rgb};
use raybook::scene::noise;

#[test]
fn what_another_processor_may_do_is_accepted() {
    let base = rendered();
    let rounded = Image::from_fn(96, 54, |x, y| {
        base.at(x, y)
            .map(|v| v * (1.0 + 1e-6 * (2.0 * noise::hash(x as i32, y as i32) - 1.0)))
    });
    assert_ne!(rounded, base, "it is not the same picture");
    // One of four samples of a pixel on the silhouette, on the other side.
    let (sphere, sky) = (base.at(48, 27), base.at(3, 27));
    let on_silhouette = |x: usize, y: usize| base.at(x, y) + (sphere + sky * -1.0) * 0.25;
    let edge = (0..48)
        .find(|&x| base.at(x, 27).r > base.at(0, 27).r + 0.05)
        .expect("the sphere has an edge");
    let one = with_pixel(&rounded, edge, 27, on_silhouette(edge, 27));
    let two = with_pixel(&one, 66, 8, on_silhouette(66, 8));
    for (name, picture) in [
        ("itself", &base),
        ("rounded", &rounded),
        ("one pixel", &one),
        ("two pixels", &two),
    ] {
        assert_eq!(
            compare(&base, picture, &Tolerance::RENDERED_AGAIN),
            Ok(()),
            "{name}"
        );
    }
}

#[test]
fn each_kind_of_difference_says_what_and_where() {
    let base = Image::from_fn(40, 30, |_, _| Rgb::gray(0.5));
    let judge =
        |wrong: &Image| compare(&base, wrong, &Tolerance::RENDERED_AGAIN).expect_err("it differs");
    let column = Image::from_fn(40, 30, |x, _| Rgb::gray(if x == 7 { 0.51 } else { 0.5 }));
    let scattered = Image::from_fn(40, 30, |x, y| {
        Rgb::gray(if x % 10 == 3 && y % 10 == 2 {
            0.51
        } else {
            0.5
        })
    });
    for (wrong, message) in [
        (
            Image::from_fn(40, 31, |_, _| Rgb::gray(0.5)),
            "the picture is 40 × 31 pixels, 40 × 30 were expected",
        ),
        (
            with_pixel(&base, 39, 29, Rgb::gray(f32::NAN)),
            "pixel (39, 29) is not a finite number",
        ),
        (
            base.map(|p| p * 1.1),
            "the mean is 0.55, 0.5 was expected: +10.00 %",
        ),
        (column, "30 neighbouring pixels differ, the first at (7, 0)"),
        (
            scattered,
            "12 pixels differ, at most 4 may; the first is (3, 2)",
        ),
    ] {
        assert_eq!(judge(&wrong).to_string(), message);
    }
    assert!(matches!(
        judge(&base.map(|_| Rgb::gray(f32::INFINITY))),
        Difference::NotFinite { x: 0, y: 0 }
    ));
}

#[test]
fn an_expected_picture_that_is_not_finite_agrees_with_nothing() {
    let nan = Image::from_fn(4, 4, |_, _| Rgb::gray(f32::NAN));
    assert!(
        compare(&nan, &nan, &Tolerance::RENDERED_AGAIN).is_err(),
        "not even with itself"
    );
    let none = Image::from_fn(0, 0, |_, _| Rgb::BLACK);
    assert_eq!(
        compare(&none, &none, &Tolerance::RENDERED_AGAIN),
        Ok(()),
        "no pixels agree, and do not panic"
    );
}

//! The comparison of pictures catches every error of a table.

use super::pictures::{rendered, with_pixel};
use raybook::image::compare::{Tolerance, compare};
use raybook::image::{Image, rgb::Rgb, tone};

/// The picture with another one's pixel at each place.
fn moved(picture: &Image, from: impl Fn(usize, usize) -> (usize, usize)) -> Image {
    Image::from_fn(picture.width(), picture.height(), |x, y| {
        let (x, y) = from(x, y);
        picture.at(x, y)
    })
}

/// The errors that a comparison must see, planted.
fn planted(base: &Image) -> Vec<(&'static str, Image)> {
    let (w, h) = (base.width(), base.height());
    let only = |place: fn(usize, usize) -> bool, change: fn(Rgb) -> Rgb| {
        Image::from_fn(w, h, |x, y| {
            if place(x, y) {
                change(base.at(x, y))
            } else {
                base.at(x, y)
            }
        })
    };
    vec![
        ("shifted left", moved(base, |x, y| ((x + 1).min(w - 1), y))),
        (
            "shifted right",
            moved(base, |x, y| (x.saturating_sub(1), y)),
        ),
        ("shifted up", moved(base, |x, y| (x, (y + 1).min(h - 1)))),
        ("shifted down", moved(base, |x, y| (x, y.saturating_sub(1)))),
        ("left and right swapped", moved(base, |x, y| (w - 1 - x, y))),
        ("upside down", moved(base, |x, y| (x, h - 1 - y))),
        ("a dead column", only(|x, _| x == 30, |_| Rgb::BLACK)),
        ("a dead row", only(|_, y| y == 20, |_| Rgb::BLACK)),
        (
            "a column drawn twice",
            moved(base, |x, y| (if x == 48 { 47 } else { x }, y)),
        ),
        ("5 % brighter", base.map(|p| p * 1.05)),
        ("5 % darker", base.map(|p| p * 0.95)),
        ("1 % brighter everywhere", base.map(|p| p * 1.01)),
        ("1 % darker everywhere", base.map(|p| p * 0.99)),
        (
            "1 % brighter in one quarter",
            only(|x, y| x < 48 && y < 27, |p| p * 1.01),
        ),
        ("1 % more red", base.map(|p| Rgb::new(p.r * 1.01, p.g, p.b))),
        ("gamma 1.02", base.map(|p| p.map(|v| v.powf(1.02)))),
        ("encoded as sRGB", base.map(|p| p.map(tone::encode_srgb))),
        (
            "rounded to bytes",
            base.map(|p| p.map(|v| tone::decode_srgb(f32::from(tone::to_byte(v)) / 255.0))),
        ),
        (
            "red and blue swapped",
            base.map(|p| Rgb::new(p.b, p.g, p.r)),
        ),
        ("green lost", base.map(|p| Rgb::new(p.r, 0.0, p.b))),
        (
            "a dead tile",
            only(
                |x, y| (32..36).contains(&x) && (16..20).contains(&y),
                |_| Rgb::BLACK,
            ),
        ),
        (
            "salt and pepper",
            only(|x, y| x % 12 == 3 && y % 12 == 5, |_| Rgb::WHITE),
        ),
        (
            "a NaN",
            with_pixel(base, 5, 40, Rgb::new(0.1, f32::NAN, 0.1)),
        ),
        (
            "an infinite pixel",
            with_pixel(base, 95, 53, Rgb::gray(f32::INFINITY)),
        ),
        ("one firefly", with_pixel(base, 50, 20, Rgb::gray(100.0))),
        (
            "a column too few",
            Image::from_fn(w - 1, h, |x, y| base.at(x, y)),
        ),
        (
            "a row too many",
            Image::from_fn(w, h + 1, |x, y| base.at(x, y.min(h - 1))),
        ),
        (
            "width and height swapped",
            Image::from_fn(h, w, |x, y| base.at(y, x)),
        ),
        ("all black", base.map(|_| Rgb::BLACK)),
    ]
}

#[test]
fn every_planted_error_is_caught() {
    let base = rendered();
    let passed: Vec<_> = planted(&base)
        .into_iter()
        .filter(|(_, wrong)| compare(&base, wrong, &Tolerance::RENDERED_AGAIN).is_ok())
        .map(|(name, _)| name)
        .collect();
    assert!(passed.is_empty(), "these passed: {passed:?}");
}

//! Chapter 2: exposure and tone curves; the other parts have files of their own.

mod budget;
mod comparison;
mod damage;
mod formats;
mod pictures;
mod planted;
mod refusals;
mod srgb;

use raybook::image::{Image, rgb::Rgb, tone};
use std::fs;
use std::path::Path;

/// A few roundings of `f32` on numbers of about 1.
const ROUNDING: f32 = 4.0 * f32::EPSILON;

/// A smooth picture over ten orders of magnitude, without anything that a format would have to clamp.
fn lights() -> Image {
    Image::from_fn(40, 23, |x, y| {
        let level = 10.0_f32.powf(x as f32 / 4.0 - 5.0);
        Rgb::new(level, level * (y as f32 / 22.0), level * 0.3)
    })
}

fn no_partial_file_in(folder: &Path) {
    let names: Vec<_> = fs::read_dir(folder)
        .expect("the folder can be read")
        .map(|entry| {
            entry
                .expect("an entry")
                .file_name()
                .to_string_lossy()
                .into_owned()
        })
        .collect();
    assert!(
        !names.iter().any(|name| name.contains("partial")),
        "nothing is left behind: {names:?}"
    );
}

#[test]
fn a_stop_is_a_factor_of_two() {
    let light = Rgb::new(0.25, 3.0, 1e5);
    assert_eq!(tone::expose(light, 0.0), light, "0 stops change nothing");
    assert_eq!(
        tone::expose(light, 1.0),
        light * 2.0,
        "one stop more is twice the light"
    );
    assert_eq!(
        tone::expose(light, -3.0),
        light / 8.0,
        "three stops less are an eighth"
    );
    let half = tone::expose(Rgb::WHITE, 0.5).r;
    assert!(
        (half - std::f32::consts::SQRT_2).abs() < ROUNDING,
        "half a stop is √2, not {half}"
    );
}

#[test]
fn clamping_cuts_each_channel() {
    assert_eq!(
        tone::clamp(Rgb::new(-1.0, 0.5, 7.0)),
        Rgb::new(0.0, 0.5, 1.0)
    );
    let orange = Rgb::new(40.0, 20.0, 5.0);
    assert_eq!(
        tone::clamp(orange),
        Rgb::WHITE,
        "an orange that is too bright turns white"
    );
}

#[test]
fn reinhard_maps_all_light_below_one_and_keeps_the_hue() {
    for (l, expected) in [
        (0.0, 0.0),
        (1.0, 0.5),
        (3.0, 0.75),
        (99.0, 0.99),
        (1e6, 1.0),
    ] {
        let mapped = tone::reinhard(Rgb::gray(l)).g;
        assert!(
            (mapped - expected).abs() < 2e-6,
            "{l} becomes {mapped}, not {expected}"
        );
    }
    let orange = Rgb::new(40.0, 20.0, 5.0);
    let mapped = tone::reinhard(orange);
    assert!(
        (mapped.r / mapped.b - 8.0).abs() < 1e-5,
        "8 times more red than blue stays so"
    );
    // Y = 0.2126·40 + 0.7152·20 + 0.0722·5 = 23.169
    assert!(
        (mapped.luminance() - 23.169 / 24.169).abs() < 1e-5,
        "its luminance becomes L/(1 + L)"
    );
    assert!(
        mapped.r > 1.0,
        "a saturated channel may exceed 1: {}",
        mapped.r
    );
}

#[test]
fn the_film_like_curve_rises_from_black_to_white() {
    assert_eq!(tone::aces(Rgb::BLACK), Rgb::BLACK, "no light stays black");
    // (1·2.54)/(1·3.02 + 0.14) by hand
    assert!(
        (tone::aces(Rgb::WHITE).r - 2.54 / 3.16).abs() < ROUNDING,
        "1 becomes 0.804"
    );
    assert_eq!(
        tone::aces(Rgb::gray(1e30)),
        Rgb::WHITE,
        "all the light of the world is white"
    );
    assert_eq!(
        tone::aces(Rgb::gray(f32::INFINITY)),
        Rgb::WHITE,
        "even an infinite radiance"
    );
    assert_eq!(
        tone::aces(Rgb::gray(-1.0)),
        Rgb::BLACK,
        "less than no light is black"
    );
    let curve: Vec<f32> = (-160..=80)
        .map(|i| tone::aces(Rgb::gray((i as f32 / 8.0).exp2())).r)
        .collect();
    assert!(curve.is_sorted(), "more light is never darker");
}

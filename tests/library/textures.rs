//! Pictures on surfaces: how they are looked up, normal maps, and the materials of OBJ files.

mod cones;
mod looks;
mod models;

use glam::{Vec2, vec2};
use raybook::image::{Image, mip::MipMap, rgb::Rgb};

/// Four by two pixels, each of its own value.
fn numbered() -> MipMap {
    MipMap::new(&Image::from_fn(4, 2, |x, y| Rgb::gray((4 * y + x) as f32)))
}

#[test]
fn in_the_middle_of_a_pixel_is_its_colour_and_v_goes_up() {
    let map = numbered();
    for (x, y) in (0..2).flat_map(|y| (0..4).map(move |x| (x, y))) {
        let place = vec2((x as f32 + 0.5) / 4.0, 0.75 - y as f32 / 2.0);
        let value = (4 * y + x) as f32;
        for turns in [Vec2::ZERO, vec2(3.0, -2.0), vec2(-1.0, 5.0)] {
            let got = map.bilinear(0, place + turns).g;
            assert!(
                (got - value).abs() < 1e-4,
                "{got} at {place} + {turns}, not {value}"
            );
        }
    }
}

#[test]
fn between_the_middles_the_colours_are_weighted_and_the_picture_is_repeated() {
    let map = numbered();
    // Between pixels 1 and 2 of the upper row; between all four around (1, 1); between the right edge and the left one.
    for (place, value) in [
        (vec2(0.5, 0.75), 1.5),
        (vec2(0.25, 0.5), 2.5),
        (vec2(1.0, 0.75), 1.5),
        (vec2(0.4375, 0.75), 1.25),
    ] {
        let got = map.bilinear(0, place).g;
        assert!((got - value).abs() < 1e-5, "{got} at {place}, not {value}");
    }
}

#[test]
fn every_level_has_the_same_mean_and_the_last_is_one_pixel() {
    for (width, height) in [(1, 1), (4, 2), (5, 3), (7, 1), (64, 63)] {
        let picture = Image::from_fn(width, height, |x, y| {
            Rgb::new((x * x % 7) as f32, (x + 3 * y) as f32, (y % 2) as f32)
        });
        let map = MipMap::new(&picture);
        let mean = |level: &Image| {
            let sum: Rgb = level.pixels().iter().copied().sum();
            sum / level.pixels().len() as f32
        };
        let whole = mean(&map.levels()[0]);
        for level in map.levels() {
            let difference = mean(level) + whole * -1.0;
            let largest = difference.map(f32::abs).max_channel();
            assert!(largest < 1e-3, "{width} × {height}: {difference:?}");
        }
        let last = map.levels().last().expect("there is one");
        assert_eq!((last.width(), last.height()), (1, 1));
        // The width of the whole picture sees its mean, from everywhere.
        let all = map.at(vec2(0.3, 0.9), 1.0) + whole * -1.0;
        assert!(all.map(f32::abs).max_channel() < 1e-3, "{all:?}");
    }
}

#[test]
fn between_two_levels_a_lookup_is_between_them_and_no_width_or_place_panics() {
    let map = numbered();
    let place = vec2(0.1, 0.2);
    let (sharp, soft) = (map.at(place, 0.25).g, map.at(place, 0.5).g);
    let between = map.at(place, 0.35).g;
    assert!((sharp.min(soft)..=sharp.max(soft)).contains(&between));
    for wild in [
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        3e38,
        -3e38,
        1e-40,
    ] {
        for (place, width) in [
            (vec2(wild, 0.5), 0.0),
            (vec2(0.5, wild), wild),
            (place, wild),
        ] {
            let got = map.at(place, width).g;
            assert!((0.0..=7.0).contains(&got), "{got} at {place}, {width}");
        }
    }
}

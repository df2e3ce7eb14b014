//! The skies that are formulas: what a map keeps of them, and how much of the light is the sun's.

use glam::vec2;
use raybook::image::{Image, rgb::Rgb};
use raybook::light::environment::latlong;
use raybook::math::dir3::Dir3;
use raybook_chapters::ch18_environment::skies::{self, SUN, Sky};
use std::f64::consts::PI;

/// ∫ L max(0, cos θ) dω of a map, θ being the angle to a normal.
fn irradiance(map: &Image, normal: Dir3) -> f64 {
    let (width, height) = (map.width(), map.height());
    let cells = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let light = cells.map(|(x, y)| {
        let [top, bottom] = [y, y + 1].map(|row| latlong::cosine(row, height));
        let solid_angle = 2.0 * PI * (top - bottom) / width as f64;
        let place = (vec2(x as f32, y as f32) + 0.5) / vec2(width as f32, height as f32);
        let cosine = f64::from(latlong::direction(place).dot(*normal).max(0.0));
        f64::from(map.at(x, y).g) * solid_angle * cosine
    });
    light.sum()
}

/// The sun alone.
fn sun(d: Dir3) -> Rgb {
    let inside = d.dot(*skies::sun_of_day()) > SUN.cos();
    Rgb::gray(f32::from(inside))
}

#[test]
fn a_map_keeps_all_of_the_suns_light() {
    // E = L π sin²α for a disc of radius α: 6.79667e-5 of its radiance.
    let exact = PI * f64::from(SUN).sin().powi(2);
    assert!((exact - 6.796_67e-5).abs() < 1e-9, "{exact}");
    for width in [64, 256, 1024] {
        let kept = irradiance(&skies::map(sun, width), skies::sun_of_day());
        assert!(
            (kept / exact - 1.0).abs() < 0.1,
            "{width} texels wide: {kept}, not {exact}"
        );
    }
}

#[test]
fn more_than_half_of_the_clear_days_light_is_the_suns() {
    let blue: Sky = |d| {
        let at_sun = d.dot(*skies::sun_of_day()) > SUN.cos();
        if at_sun {
            Rgb::BLACK
        } else {
            skies::clear_day(d)
        }
    };
    let [all, without] =
        [skies::clear_day, blue].map(|sky| irradiance(&skies::map(sky, 512), Dir3::Y));
    let share = 1.0 - without / all;
    assert!(
        (0.5..0.7).contains(&share),
        "of the light on the ground: {share}"
    );
}

#[test]
fn skies_are_light_from_every_direction() {
    for sky in skies::FOUR {
        let map = skies::map(sky, 128);
        let light = |rgb: &Rgb| rgb.channels().iter().all(|v| v.is_finite() && *v > 0.0);
        assert!(map.pixels().iter().all(light), "no texel is black or worse");
    }
    let one = skies::map(skies::overcast, 1);
    assert_eq!((one.width(), one.height()), (1, 1), "the smallest map");
}

//! Dispersion: indices by wavelength against the makers' data sheets, the eye's curves against the tables, and the prism's picture.

use glam::{Vec3, vec3};
use raybook::image::{Image, spectrum};
use raybook::material::dispersion::Sellmeier;
use raybook::material::refract::refract;
use raybook::math::dir3::Dir3;
use raybook::render::film::Film;
use raybook_chapters::ch14_refraction::prism;

#[test]
fn indices_and_abbe_numbers_are_those_of_the_data_sheets() {
    for (glass, yellow, abbe) in [
        (Sellmeier::BK7, 1.516_80, 64.17),
        (Sellmeier::SF11, 1.784_72, 25.68),
    ] {
        assert!((glass.index(587.562) - yellow).abs() < 2e-5, "{glass:?}");
        assert!((glass.abbe() - abbe).abs() < 0.02, "{}", glass.abbe());
    }
}

#[test]
fn the_shorter_the_wave_the_larger_the_index() {
    for glass in [Sellmeier::BK7, Sellmeier::SF11] {
        let indices: Vec<_> = (380..=780)
            .step_by(5)
            .map(|nm| glass.index(nm as f32))
            .collect();
        assert!(indices.is_sorted_by(|a, b| a > b), "{glass:?}");
    }
}

#[test]
fn a_ray_through_a_prism_is_least_deviated_where_the_formula_says() {
    // n = sin((A + δ)/2)/sin(A/2), at the least deviation δ.
    let half = 30_f32.to_radians();
    let sides = [
        vec3(-half.cos(), half.sin(), 0.0),
        vec3(half.cos(), half.sin(), 0.0),
    ];
    let sides = sides.map(|normal| Dir3::new(normal).expect("it has a length"));
    let index = Sellmeier::SF11.index(500.0);
    let deviation = |incidence: f32| {
        let angle = incidence - half;
        let start = Dir3::new(vec3(angle.cos(), angle.sin(), 0.0)).expect("it has a length");
        let inside = refract(start, sides[0], 1.0, index).expect("light enters");
        let end = refract(inside, sides[1], 1.0, index);
        end.map_or(f32::INFINITY, |end| start.dot(*end).acos())
    };
    let least = (0..9000).map(|i| deviation((0.01 * i as f32).to_radians()));
    let least = least.fold(f32::INFINITY, f32::min);
    let told = 2.0 * (index * half.sin()).asin() - 2.0 * half;
    assert!((least - told).abs() < 1e-3, "{least}, not {told}");
}

#[test]
fn the_eyes_curves_have_the_areas_and_the_peak_of_the_tables() {
    let sum: Vec3 = (3600..=8300)
        .map(|i| 0.1 * spectrum::xyz(0.1 * i as f32))
        .sum();
    // CIE 1931: each of the three has the area 106.86 nm.
    assert!((sum / 106.86 - 1.0).abs().max_element() < 0.01, "{sum}");
    assert!((spectrum::xyz(555.0).y - 1.0).abs() < 0.01);
    // Light of all wavelengths alike is a warm white on a display whose white is daylight.
    let white: Vec3 = (360..=830)
        .map(|i| spectrum::rgb(i as f32))
        .map(|rgb| vec3(rgb.r, rgb.g, rgb.b))
        .sum();
    let white = white / 106.86;
    assert!(
        (white - vec3(1.205, 0.948, 0.909)).abs().max_element() < 0.02,
        "{white}"
    );
}

/// The rows of the card, at the picture's right, that a colour has most of, from the first to the last.
fn rows(picture: &Image, part: fn(raybook::image::rgb::Rgb) -> [f32; 3]) -> [usize; 2] {
    let x = picture.width() - 2;
    let is_own = |y: &usize| {
        let [own, one, other] = part(picture.at(x, *y));
        own > 0.2 && own > 2.0 * one && own > 2.0 * other
    };
    let rows: Vec<_> = (0..picture.height()).filter(is_own).collect();
    [rows[0], rows[rows.len() - 1]]
}

#[test]
fn red_is_turned_least_and_flint_glass_spreads_the_colours_farther() {
    let apex = 60_f32.to_radians();
    let draw = |glass| prism::picture(&Film::new(300, 200, 1), glass, apex);
    let fans = [Sellmeier::BK7, Sellmeier::SF11].map(|glass| {
        let picture = draw(glass);
        let [top, red] = rows(&picture, |c| [c.r, c.g, c.b]);
        let [blue, bottom] = rows(&picture, |c| [c.b, c.r, c.g]);
        assert!(
            red < blue,
            "red, to row {red}, is above blue, from row {blue}"
        );
        bottom - top
    });
    assert!(fans[1] > 3 * fans[0], "{fans:?}");
}

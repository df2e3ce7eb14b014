//! The Cornell box is the published one: corners, and colours that follow from the measured spectra.

use glam::{Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::math::{dir3::Dir3, ray::Ray};
use raybook::scene::cornell::{GREEN, LAMP, RED, WHITE, cornell_box, lamp};

/// Reflectances from 400 to 700 nm, every 4 nm, in thousandths (Cornell University Program of Computer Graphics).
#[rustfmt::skip]
const WHITE_PAINT: [u16; 76] = [
    343, 445, 551, 624, 665, 687, 708, 723, 715, 710, 745, 758, 739, 767, 777, 765, 751, 745, 748,
    729, 745, 757, 753, 750, 746, 747, 735, 732, 739, 734, 725, 721, 733, 725, 732, 743, 744, 748,
    728, 716, 733, 726, 713, 740, 754, 764, 752, 736, 734, 741, 740, 732, 745, 755, 751, 744, 731,
    733, 744, 731, 712, 708, 729, 730, 727, 707, 703, 729, 750, 760, 751, 739, 724, 730, 740, 737,
];
#[rustfmt::skip]
const GREEN_PAINT: [u16; 76] = [
    92, 96, 98, 97, 98, 95, 95, 97, 95, 94, 97, 98, 96, 101, 103, 104, 107, 109, 112, 115, 125,
    140, 160, 187, 229, 285, 343, 390, 435, 464, 472, 476, 481, 462, 447, 441, 426, 406, 373, 347,
    337, 314, 285, 277, 266, 250, 230, 207, 186, 171, 160, 148, 141, 136, 130, 126, 123, 121, 122,
    119, 114, 115, 117, 117, 118, 120, 122, 128, 132, 139, 144, 146, 150, 152, 157, 159,
];
#[rustfmt::skip]
const RED_PAINT: [u16; 76] = [
    40, 46, 48, 53, 49, 50, 53, 55, 57, 56, 59, 57, 61, 61, 60, 62, 62, 62, 61, 62, 60, 59, 57, 58,
    58, 58, 56, 55, 56, 59, 57, 55, 59, 59, 58, 59, 61, 61, 63, 63, 67, 68, 72, 80, 90, 99, 124,
    154, 192, 255, 287, 349, 402, 443, 487, 513, 558, 584, 620, 606, 609, 651, 612, 610, 650, 638,
    627, 620, 630, 628, 642, 639, 657, 639, 635, 642,
];
/// The lamp at 400, 500, 600 and 700 nm, with straight lines in between.
const LAMP_SPECTRUM: [f64; 4] = [0.0, 8.0, 15.6, 18.4];
/// Daylight D65 from 400 to 700 nm, every 10 nm (CIE).
#[rustfmt::skip]
const D65: [f64; 31] = [
    82.75, 91.49, 93.43, 86.68, 104.86, 117.01, 117.81, 114.86, 115.92, 108.81, 109.35, 107.80, 104.79, 107.69, 104.41,
    104.05, 100.00, 96.33, 95.79, 88.69, 90.01, 89.60, 87.70, 83.29, 83.70, 80.03, 80.21, 82.28, 78.28, 69.72, 71.61,
];

/// The eye's curves of 1931 at a wavelength, as fitted by Wyman, Sloan and Shirley (2013).
fn eye(nm: f64) -> [f64; 3] {
    let bell = |middle: f64, below: f64, above: f64| {
        let width = if nm < middle { below } else { above };
        (-0.5 * ((nm - middle) / width).powi(2)).exp()
    };
    [
        1.056 * bell(599.8, 37.9, 31.0) + 0.362 * bell(442.0, 16.0, 26.7)
            - 0.065 * bell(501.1, 20.4, 26.2),
        0.821 * bell(568.8, 46.9, 40.5) + 0.286 * bell(530.9, 16.3, 31.1),
        1.217 * bell(437.0, 11.8, 36.0) + 0.681 * bell(459.0, 26.0, 13.8),
    ]
}

/// A table with a value every `step` nanometres from 400.
fn between(table: &[f64], step: f64, nm: f64) -> f64 {
    let place = (nm - 400.0) / step;
    let i = (place as usize).min(table.len() - 2);
    table[i] + (place - i as f64) * (table[i + 1] - table[i])
}

/// ∫ spectrum · eye dλ / ∫ weight · ȳ dλ, as linear sRGB.
fn colour(spectrum: impl Fn(f64) -> f64, weight: impl Fn(f64) -> f64) -> [f64; 3] {
    let wavelengths = || (0..76).map(|i| 400.0 + 4.0 * f64::from(i));
    let whole: f64 = wavelengths().map(|nm| weight(nm) * eye(nm)[1]).sum();
    let [x, y, z] = [0, 1, 2].map(|i| {
        let sum: f64 = wavelengths().map(|nm| spectrum(nm) * eye(nm)[i]).sum();
        sum / whole
    });
    [
        3.2406 * x - 1.5372 * y - 0.4986 * z,
        -0.9689 * x + 1.8758 * y + 0.0415 * z,
        0.0557 * x - 0.2040 * y + 1.0570 * z,
    ]
}

#[test]
fn the_colours_follow_from_the_measured_spectra() {
    let daylight = |nm| between(&D65, 10.0, nm);
    let white = colour(daylight, daylight);
    for v in white {
        assert!((v - 1.0).abs() < 0.005, "daylight is white: {white:?}");
    }
    for (name, table, albedo) in [
        ("white", WHITE_PAINT, WHITE),
        ("green", GREEN_PAINT, GREEN),
        ("red", RED_PAINT, RED),
    ] {
        let table = table.map(|thousandths| f64::from(thousandths) / 1000.0);
        let seen = colour(|nm| daylight(nm) * between(&table, 4.0, nm), daylight);
        let relative: [f64; 3] = std::array::from_fn(|i| seen[i] / white[i]);
        close(name, relative, albedo);
    }
    let lamp = colour(|nm| between(&LAMP_SPECTRUM, 100.0, nm), |_| 1.0);
    close("lamp", lamp, LAMP);
}

fn close(name: &str, exact: [f64; 3], rounded: Rgb) {
    for (exact, rounded) in exact.into_iter().zip(rounded.channels()) {
        let digits = 5e-4 * exact.max(1.0);
        assert!(
            (exact - f64::from(rounded)).abs() < digits + 1e-9,
            "{name}: {exact:?}, not {rounded:?}"
        );
    }
}

#[test]
fn walls_and_blocks_stand_where_they_were_measured() {
    let scene = cornell_box();
    let eye = vec3(0.278, 0.273, -0.8);
    let meets = |from: Vec3, toward: Vec3| {
        let ray = Ray::new(from, Dir3::new(toward).expect("a direction"));
        scene.closest(&ray).map(|seen| seen.surface.position)
    };
    let near = |found: Option<Vec3>, x: f32, y: f32, z: f32| {
        let found = found.expect("the box is closed");
        assert!(
            found.distance(vec3(x, y, z)) < 2e-3,
            "{found} is not ({x}, {y}, {z})"
        );
    };
    let middle = vec3(0.35, 0.45, 0.05);
    near(meets(middle, Vec3::Z), 0.35, 0.45, 0.5592); // above the blocks, to the back wall
    near(meets(middle, Vec3::Y), 0.35, 0.5488, 0.05); // the ceiling
    near(meets(middle, Vec3::NEG_X), 0.0, 0.45, 0.05); // the green wall
    near(meets(vec3(0.5, 0.4, 0.0), Vec3::X), 0.555, 0.4, 0.0); // the red wall leans outwards
    near(meets(vec3(0.19, 0.4, 0.17), Vec3::NEG_Y), 0.19, 0.165, 0.17); // the short block's top
    near(meets(vec3(0.37, 0.4, 0.35), Vec3::NEG_Y), 0.37, 0.33, 0.35); // the tall one's
    near(meets(vec3(0.05, 0.4, 0.05), Vec3::NEG_Y), 0.05, 0.0, 0.05); // the floor
    assert_eq!(
        meets(eye, Vec3::NEG_Z),
        None,
        "behind the camera is nothing"
    );
    assert!(
        (lamp().area() - 0.130 * 0.105).abs() < 1e-6,
        "13 cm by 10.5 cm"
    );
}

#[test]
fn the_lamp_is_seen_from_below_and_in_front_of_the_ceiling() {
    let scene = cornell_box();
    let up = Ray::new(vec3(0.278, 0.4, 0.28), Dir3::Y);
    let lamp = scene.lights[0]
        .seen(&up, f32::INFINITY)
        .expect("the lamp is above");
    assert_eq!(lamp.radiance, LAMP, "its radiance");
    let ceiling = scene.closest(&up).expect("the ceiling is behind it").t;
    assert!(
        lamp.t < ceiling && ceiling - lamp.t < 1e-3,
        "{lamp:?}, {ceiling}"
    );
}

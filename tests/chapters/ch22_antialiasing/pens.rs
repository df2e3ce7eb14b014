//! The pens of patterns, and the colours of bars: told apart in print, and by the colour-blind.

use super::subject;
use glam::{Mat3, Vec3};
use plotters::prelude::{RGBColor, WHITE};
use raybook::image::rgb::Rgb;
use raybook_chapters::kit::palette;
use raybook_chapters::lab::pens::pen;
use raybook_chapters::lab::plot::Plot;
use raybook_chapters::lab::portrait::Portrait;
use raybook_chapters::lab::subject::known;

/// What a display's red, green and blue look like to people without one kind of cones, row by row in linear values
/// (Machado, Oliveira and Fernandes, "A physiologically-based model for simulation of color vision deficiency", 2009).
#[rustfmt::skip]
const MISSING_CONES: [(&str, [f32; 9]); 3] = [
    ("protanopia", [0.152_286, 1.052_583, -0.204_868, 0.114_503, 0.786_281, 0.099_216, -0.003_882, -0.048_116, 1.051_998]),
    ("deuteranopia", [0.367_322, 0.860_646, -0.227_968, 0.280_085, 0.672_501, 0.047_413, -0.011_820, 0.042_940, 0.968_881]),
    ("tritanopia", [1.255_528, -0.076_749, -0.178_779, -0.078_411, 0.930_809, 0.147_602, 0.004_733, 0.691_367, 0.303_900]),
];

/// CIE L*a*b* of linear red, green and blue under daylight (D65).
fn lab(linear: Vec3) -> Vec3 {
    #[rustfmt::skip]
    let xyz = Mat3::from_cols_array(&[
        0.4124, 0.3576, 0.1805,
        0.2126, 0.7152, 0.0722,
        0.0193, 0.1192, 0.9505,
    ]).transpose() * linear / Vec3::new(0.95047, 1.0, 1.08883);
    let f = |t: f32| {
        if t > 216.0 / 24389.0 {
            t.cbrt()
        } else {
            (24389.0 / 27.0 * t + 16.0) / 116.0
        }
    };
    let [x, y, z] = xyz.to_array().map(f);
    Vec3::new(116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z))
}

/// The pens that are told apart: those of all patterns, of patterns to come, and of a user's own files.
const PENS: usize = 16;

#[test]
fn the_colour_blind_tell_patterns_apart_in_two_ways() {
    assert!(
        known().count() < PENS,
        "a file of points has a pen of its own"
    );
    for (kind, matrix) in MISSING_CONES {
        let matrix = Mat3::from_cols_array(&matrix).transpose();
        let seen = |i: usize| {
            let colour = pen(i).stroke.color;
            let colour = RGBColor(colour.0, colour.1, colour.2);
            let Rgb { r, g, b } = palette::linear(colour);
            lab((matrix * Vec3::new(r, g, b)).clamp(Vec3::ZERO, Vec3::ONE))
        };
        for i in 0..PENS {
            for j in 0..i {
                let ways = [
                    pen(i).dash != pen(j).dash,
                    pen(i).mark != pen(j).mark,
                    seen(i).distance(seen(j)) > 10.0, // 1 is just noticeable side by side
                ];
                let ways = ways.into_iter().filter(|&way| way).count();
                assert!(
                    ways >= 2,
                    "pens {i} and {j} with {kind}: {ways} of colour, dash, mark"
                );
            }
        }
    }
}

#[test]
fn patterns_are_told_apart_without_colour() {
    let looks = |i: usize| (pen(i).dash, pen(i).mark, pen(i).filled);
    for i in 0..PENS {
        for j in 0..i {
            assert_ne!(looks(i), looks(j), "pens {i} and {j}");
        }
    }
}

#[test]
fn every_pen_is_dark_enough_on_white() {
    for i in 0..known().count() {
        let colour = pen(i).stroke.color;
        let linear = palette::linear(RGBColor(colour.0, colour.1, colour.2));
        assert!(linear.luminance() < 0.5, "pen {i}: {linear:?}");
    }
    assert!(Rgb::WHITE.luminance() > 0.99, "white is light");
}

#[test]
fn bars_of_x_and_of_y_are_told_apart_in_grey_print() {
    let portrait = Portrait::measure(&subject("random"), 16, 1);
    let svg = portrait.figure().expect("it is drawn").svg;
    let colour = |rectangle: &str| {
        let code = rectangle.split_once("fill=\"#")?.1.get(..6)?;
        let channel = |i: usize| u8::from_str_radix(&code[2 * i..2 * i + 2], 16).ok();
        Some(RGBColor(channel(0)?, channel(1)?, channel(2)?))
    };
    let mut colours: Vec<_> = svg.split("<rect ").skip(1).filter_map(colour).collect();
    colours.retain(|colour| *colour != WHITE); // the paper
    colours.dedup();
    let [x, y] = colours[..] else {
        panic!("the bars have two colours: {colours:?}");
    };
    let [dark, light] = [x, y].map(|colour| palette::linear(colour).luminance());
    assert!(light > 2.0 * dark, "{dark} and {light}");
}

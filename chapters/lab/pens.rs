//! The pen of each pattern: the same pen on every page, whatever the pattern is compared with.

use crate::kit::palette::{BLUE, GREEN, ORANGE, PURPLE, SKY, VERMILION};
use crate::kit::pen::{Mark, Pen, pale};
use crate::lab::subject::{Subject, known};
use plotters::prelude::{BLACK, Color, RGBColor};

/// Lines without gaps, dashed, dotted, and dashed and dotted.
const DASHES: [&[f64]; 4] = [&[], &[26.0, 12.0], &[7.0, 9.0], &[26.0, 9.0, 7.0, 9.0]];

/// Marks, each filled for one pattern and empty for another.
const MARKS: [Mark; 7] = [
    Mark::Disc,
    Mark::Corners(4, 45),
    Mark::Corners(3, 90),
    Mark::Corners(4, 0),
    Mark::Corners(3, 270),
    Mark::Corners(6, 0),
    Mark::Cross(45),
];

/// The colours of curves, in order: seven, and then the same ones darker.
pub fn colour(i: usize) -> RGBColor {
    let RGBColor(r, g, b) = [VERMILION, BLUE, GREEN, ORANGE, PURPLE, SKY, BLACK][i % 7];
    match i / 7 {
        0 => RGBColor(r, g, b),
        _ => RGBColor(r / 2, g / 2, b / 2),
    }
}

/// The pen of number i: no other pen has the same colour, dash and mark.
pub fn pen(i: usize) -> Pen {
    Pen {
        stroke: colour(i).stroke_width(5),
        dash: DASHES[i % DASHES.len()],
        mark: MARKS[i % MARKS.len()],
        filled: (i / MARKS.len()).is_multiple_of(2),
    }
}

/// The pens of some subjects, which are compared.
///
/// Every pattern has a pen. A user's own version of the pattern has the same pen; the library's curve is then a broad pale line,
/// and the user's curve lies on it if it is right. If a pattern comes with several seeds, the later curves are pale.
pub fn pens(subjects: &[Subject]) -> Vec<Pen> {
    let of = |(i, subject): (usize, &Subject)| {
        let name = subject.pattern.name;
        let number = known().position(|pattern| pattern.name == name);
        let files = subjects[..i].iter().filter(|s| s.pattern.name == name);
        let pen = pen(number.unwrap_or_else(|| known().count() + files.count()));
        let own = |other: &Subject| other.is_own() && other.pattern.name == name;
        let again = |other: &Subject| !other.is_own() && other.pattern.name == name;
        let beneath = subjects.iter().any(own) || subjects[..i].iter().any(again);
        if !subject.is_own() && beneath {
            let colour = pen.stroke.color;
            Pen::plain(pale(RGBColor(colour.0, colour.1, colour.2)))
        } else {
            pen
        }
    };
    subjects.iter().enumerate().map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::{known, pen};
    use glam::{Mat3, Vec3};
    use raybook::image::rgb::Rgb;

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

    #[test]
    fn the_colour_blind_tell_patterns_apart_in_two_ways() {
        for (kind, matrix) in MISSING_CONES {
            let matrix = Mat3::from_cols_array(&matrix).transpose();
            let seen = |i: usize| {
                let colour = pen(i).stroke.color;
                let colour = super::RGBColor(colour.0, colour.1, colour.2);
                let Rgb { r, g, b } = crate::kit::palette::linear(colour);
                lab((matrix * Vec3::new(r, g, b)).clamp(Vec3::ZERO, Vec3::ONE))
            };
            for i in 0..known().count() {
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
        for i in 0..known().count() {
            for j in 0..i {
                assert_ne!(looks(i), looks(j), "pens {i} and {j}");
            }
        }
    }

    #[test]
    fn every_pen_is_dark_enough_on_white() {
        for i in 0..known().count() {
            let colour = pen(i).stroke.color;
            let linear = crate::kit::palette::linear(super::RGBColor(colour.0, colour.1, colour.2));
            assert!(linear.luminance() < 0.5, "pen {i}: {linear:?}");
        }
        assert!(Rgb::WHITE.luminance() > 0.99, "white is light");
    }
}

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

/// The colours of curves, in order: seven, and then the same ones darker, with grey for black.
pub fn colour(i: usize) -> RGBColor {
    let RGBColor(r, g, b) = [VERMILION, BLUE, GREEN, ORANGE, PURPLE, SKY, BLACK][i % 7];
    match i / 7 {
        0 => RGBColor(r, g, b),
        _ if i % 7 == 6 => RGBColor(110, 110, 110),
        _ => RGBColor(r / 2, g / 2, b / 2),
    }
}

/// The pen of number i: no two of the first 16 have the same dash and mark, nor one of these and the same colour.
pub fn pen(i: usize) -> Pen {
    // From the fifteenth pen on, the darker colours come again: with other marks.
    let mark = i + 4 * (i / 14);
    Pen {
        stroke: colour(i).stroke_width(5),
        dash: DASHES[i % DASHES.len()],
        mark: MARKS[mark % MARKS.len()],
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

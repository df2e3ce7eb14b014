//! The diameter of the disc that a point becomes, against the distance of the point, and which distances are sharp enough.

use crate::kit::axis::Axis;
use crate::kit::chart::{Chart, Corner};
use crate::kit::figure::Figure;
use crate::kit::palette::{BLUE, GREEN, INK, ORANGE, VERMILION};
use plotters::prelude::{Color, RGBColor};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use raybook::camera::lens::{Lens, LensError};

/// A lens of 50 mm, focused at 2 m.
const FOCAL_LENGTH: f32 = 0.05;
const FOCUS: f32 = 2.0;

/// Width of a pixel of a sensor of 36 mm with 960 pixels side by side, in metres.
pub(super) const PIXEL: f32 = 0.036 / 960.0;

/// The f-numbers and their colours, the widest aperture last: its range is the narrowest, and lies on top.
const STOPS: [(f32, RGBColor); 4] = [(11.0, ORANGE), (5.6, GREEN), (2.8, BLUE), (1.4, VERMILION)];

/// The distances of the plot, in metres.
const NEAREST: f32 = 0.5;
const FARTHEST: f32 = 50.0;

/// The diameters of the plot, in millimetres.
const LEAST: f32 = 0.002;
const MOST: f32 = 3.0;

/// The circle of confusion against the distance, on logarithmic axes, with the depth of field shaded.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn plot() -> Figure {
    let distances = Axis::log2(NEAREST..FARTHEST).named("distance of the point, in metres");
    let widths = Axis::log(LEAST..MOST).named("diameter of its disc on the sensor, in mm");
    let mut chart = Chart::new(distances, widths).legend(Corner::LowerRight);
    for (f_number, colour) in STOPS {
        let [near, far] = lens(f_number)?.depth_of_field(PIXEL);
        let (left, right) = (near.max(NEAREST), far.min(FARTHEST));
        let range = [(left, LEAST), (right, 1e3 * PIXEL)];
        chart.bar(range, colour.mix(0.28).filled());
    }
    let line = [(NEAREST, 1e3 * PIXEL), (FARTHEST, 1e3 * PIXEL)];
    let above = Pos::new(HPos::Left, VPos::Bottom);
    let note = format!("a pixel: 36 mm / 960 = {:.4} mm", 1e3 * PIXEL);
    chart
        .dashes(line, INK.stroke_width(3))
        .label(above, (9.5, 1.08e3 * PIXEL), &note, INK);
    for (f_number, colour) in STOPS.into_iter().rev() {
        let lens = lens(f_number)?;
        let [near, far] = lens.depth_of_field(PIXEL);
        let name = format!("f/{f_number}: sharp from {near:.2} m to {far:.2} m");
        let steps = (0..=2000).map(|i| NEAREST * (FARTHEST / NEAREST).powf(i as f32 / 2000.0));
        let curve = steps.map(|x| (x, (1e3 * lens.circle_of_confusion(x)).max(LEAST)));
        chart.line(curve, colour.stroke_width(5)).named(&name);
    }
    chart.figure(960, 600)
}

fn lens(f_number: f32) -> Result<Lens, LensError> {
    Lens::new(FOCAL_LENGTH, f_number, FOCUS)
}

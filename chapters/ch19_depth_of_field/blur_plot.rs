//! The diameter of the disc that a point becomes, against the distance of the point, and which distances are sharp enough.

use crate::kit::axis::Axis;
use crate::kit::chart::{Chart, Corner};
use crate::kit::figure::Figure;
use crate::kit::palette::{BLUE, GREEN, INK, ORANGE, VERMILION};
use plotters::prelude::{Color, RGBColor};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use raybook::camera::lens::Lens;

/// A lens of 50 mm.
const FOCAL_LENGTH: f32 = 0.05;

/// Width of a pixel of a sensor of 36 mm with 960 pixels side by side, in metres.
pub(super) const PIXEL: f32 = 0.036 / 960.0;

/// The f-numbers and their colours, the widest aperture last: its range is the narrowest, and lies on top.
const STOPS: [(f32, RGBColor); 4] = [(11.0, ORANGE), (5.6, GREEN), (2.8, BLUE), (1.4, VERMILION)];

/// The distances of the plot, as multiples of the distance in focus.
const NEAREST: f32 = 0.25;
const FARTHEST: f32 = 25.0;

/// The least diameter of the plot, in millimetres.
const LEAST: f32 = 0.002;

/// The circle of confusion against the distance, on logarithmic axes, of a lens that is focused at a distance, with the depth of
/// field shaded.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn plot(focus: f32) -> Figure {
    let [nearest, farthest] = [NEAREST, FARTHEST].map(|times| times * focus);
    let lens = |f_number| Lens::new(FOCAL_LENGTH, f_number, focus);
    let widest = lens(STOPS[STOPS.len() - 1].0)?.circle_of_confusion(nearest);
    let distances = Axis::log2(nearest..farthest).named("distance of the point, in metres");
    let widths =
        Axis::log(LEAST..1.2e3 * widest).named("diameter of its disc on the sensor, in mm");
    let mut chart = Chart::new(distances, widths).legend(Corner::LowerRight);
    for (f_number, colour) in STOPS {
        let [near, far] = lens(f_number)?.depth_of_field(PIXEL);
        let (left, right) = (near.max(nearest), far.min(farthest));
        let range = [(left, LEAST), (right, 1e3 * PIXEL)];
        chart.bar(range, colour.mix(0.28).filled());
    }
    let line = [(nearest, 1e3 * PIXEL), (farthest, 1e3 * PIXEL)];
    let above = Pos::new(HPos::Left, VPos::Bottom);
    let note = format!("a pixel: 36 mm / 960 = {:.4} mm", 1e3 * PIXEL);
    chart.dashes(line, INK.stroke_width(3)).label(
        above,
        (4.75 * focus, 1.08e3 * PIXEL),
        &note,
        INK,
    );
    for (f_number, colour) in STOPS.into_iter().rev() {
        let lens = lens(f_number)?;
        let [near, far] = lens.depth_of_field(PIXEL);
        let name = if far.is_finite() {
            format!("f/{f_number}: sharp from {near:.2} m to {far:.2} m")
        } else {
            format!("f/{f_number}: sharp from {near:.2} m on")
        };
        let steps = (0..=2000).map(|i| nearest * (farthest / nearest).powf(i as f32 / 2000.0));
        let curve = steps.map(|x| (x, (1e3 * lens.circle_of_confusion(x)).max(LEAST)));
        chart.line(curve, colour.stroke_width(5)).named(&name);
    }
    chart.figure(960, 600)
}

//! How wide the disc of a point is, against its distance, and which distances are sharp enough.

use raybook::camera::lens::Lens;
use raybook::image::Image;
use crate::kit::{figure::FONT, figure::figure};
use crate::kit::{palette::BLUE, palette::FAINT, palette::GREEN, palette::INK, palette::ORANGE, palette::VERMILION};
use plotters::prelude::{
    ChartBuilder, Color, DashedLineSeries, IntoFont, IntoLogRange, LineSeries, PathElement,
    RGBColor, Rectangle, SeriesLabelPosition, Text, TextStyle, WHITE,
};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::error::Error;

/// A lens of 50 mm, focused at 2 m.
const FOCAL_LENGTH: f32 = 0.05;
const FOCUS: f32 = 2.0;

/// A pixel of a sensor of 36 mm with 960 pixels side by side, in metres.
pub const PIXEL: f32 = 0.036 / 960.0;

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
pub fn plot() -> Result<Image, Box<dyn Error>> {
    figure(960, 600, |canvas| {
        let mut chart = ChartBuilder::on(canvas)
            .margin(30)
            .margin_right(60)
            .x_label_area_size(100)
            .y_label_area_size(160)
            .build_cartesian_2d(
                (NEAREST..FARTHEST).log_scale().base(2.0),
                (LEAST..MOST).log_scale(),
            )?;
        for (f_number, colour) in STOPS {
            let [near, far] = lens(f_number)?.depth_of_field(PIXEL);
            let (left, right) = (near.max(NEAREST), far.min(FARTHEST));
            let range = Rectangle::new(
                [(left, LEAST), (right, 1e3 * PIXEL)],
                colour.mix(0.28).filled(),
            );
            chart.draw_series([range])?;
        }
        chart
            .configure_mesh()
            .light_line_style(WHITE.mix(0.0))
            .bold_line_style(FAINT.mix(0.5))
            .x_label_formatter(&|x| format!("{x}"))
            .y_label_formatter(&|mm| format!("{mm}"))
            .x_desc("distance of the point, in metres")
            .y_desc("its disc on the sensor, in mm")
            .label_style(text(30))
            .axis_desc_style(text(32))
            .draw()?;
        let line = [(NEAREST, 1e3 * PIXEL), (FARTHEST, 1e3 * PIXEL)];
        chart.draw_series(DashedLineSeries::new(line, 14, 10, INK.stroke_width(3)))?;
        let middle = Pos::new(HPos::Left, VPos::Bottom);
        let note = text(30).pos(middle);
        let label = format!("a pixel: 36 mm / 960 = {:.4} mm", 1e3 * PIXEL);
        chart.draw_series([Text::new(label, (9.5, 1.08e3 * PIXEL), note)])?;
        for (f_number, colour) in STOPS.into_iter().rev() {
            let lens = lens(f_number)?;
            let [near, far] = lens.depth_of_field(PIXEL);
            let name = format!("f/{f_number}: sharp from {near:.2} m to {far:.2} m");
            let steps = (0..=2000).map(|i| NEAREST * (FARTHEST / NEAREST).powf(i as f32 / 2000.0));
            let curve = steps.map(|x| (x, (1e3 * lens.circle_of_confusion(x)).max(LEAST)));
            chart
                .draw_series(LineSeries::new(curve, colour.stroke_width(5)))?
                .label(name)
                .legend(move |(x, y)| {
                    PathElement::new([(x, y), (x + 50, y)], colour.stroke_width(6))
                });
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::LowerRight)
            .label_font(text(30))
            .legend_area_size(70)
            .margin(24)
            .background_style(WHITE.mix(0.9))
            .border_style(FAINT)
            .draw()?;
        Ok(())
    })
}

fn lens(f_number: f32) -> Result<Lens, Box<dyn Error>> {
    Ok(Lens::new(FOCAL_LENGTH, f_number, FOCUS)?)
}

fn text(size: u32) -> TextStyle<'static> {
    (FONT, size).into_font().color(&INK)
}

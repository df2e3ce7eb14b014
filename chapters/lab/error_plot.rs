//! Error against samples, both axes logarithmic.

use crate::kit::figure::FONT;
use crate::kit::{palette::FAINT, palette::INK};
use crate::lab::{integrands::Error, integrands::slope};
use crate::lab::{plot::Drawn, plot::Plot, plot::coloured};
use plotters::coord::Shift;
use plotters::prelude::{
    ChartBuilder, Circle, Color, DrawingArea, DrawingBackend, IntoFont, IntoLogRange, LineSeries,
    PathElement, Polygon, SeriesLabelPosition, ShapeStyle, Text, WHITE,
};
use std::fmt::Write;

/// Slopes that are drawn as guides, with what they mean.
const GUIDES: [(f64, &str); 4] = [(-0.5, "−½"), (-0.75, "−¾"), (-1.0, "−1"), (-1.5, "−3/2")];

/// The curve of one pattern.
pub struct Curve {
    /// Its name, as a word.
    pub key: String,
    /// Its name, as people write it.
    pub title: String,
    /// Its line.
    pub stroke: ShapeStyle,
    /// The errors, by number of samples.
    pub errors: Vec<Error>,
}

/// The curves of several patterns for the same function.
pub struct ErrorPlot {
    /// What is measured.
    pub title: String,
    /// The curves.
    pub curves: Vec<Curve>,
}

impl ErrorPlot {
    /// The number of samples and the errors that are in the plot: left, right, least, largest.
    fn range(&self) -> [f64; 4] {
        let all = || self.curves.iter().flat_map(|curve| &curve.errors);
        let most = |of: fn(&Error) -> f64| all().map(of).fold(f64::MIN_POSITIVE, f64::max);
        let least = |of: fn(&Error) -> f64| all().map(of).fold(f64::INFINITY, f64::min);
        let [left, right] = [least(|e| e.n as f64), most(|e| e.n as f64)];
        let top = most(|e| e.high);
        // A grid can be right without error: its curve then leaves the plot.
        [
            left,
            right,
            least(|e| e.rms).max(1e-6 * top) * 0.7,
            1.5 * top,
        ]
    }
}

impl Plot for ErrorPlot {
    fn size(&self) -> (u32, u32) {
        (760, 640)
    }

    fn draw<B: DrawingBackend>(&self, canvas: &DrawingArea<B, Shift>) -> Drawn
    where
        B::ErrorType: 'static,
    {
        let [left, right, bottom, top] = self.range();
        let font = |size: u32| (FONT, size).into_font().color(&INK);
        let mut chart = ChartBuilder::on(canvas)
            .margin(24)
            .margin_right(90)
            .caption(&self.title, font(42))
            .x_label_area_size(90)
            .y_label_area_size(140)
            .build_cartesian_2d(
                (left..right).log_scale().base(2.0),
                (bottom..top).log_scale(),
            )?;
        chart
            .configure_mesh()
            .light_line_style(WHITE.mix(0.0))
            .bold_line_style(FAINT.mix(0.4))
            .x_label_formatter(&|n| format!("{n:.0}"))
            .y_label_formatter(&|error| format!("{error:.0e}"))
            .x_desc("samples")
            .y_desc("RMS error")
            .label_style(font(28))
            .axis_desc_style(font(30))
            .draw()?;
        for (slope, name) in GUIDES {
            let at = |n: f64| (n, 0.75 * top * (n / left).powf(slope));
            let end = right.min(left * (0.75 * top / bottom).powf(-1.0 / slope));
            let guide = LineSeries::new([at(left), at(end)], FAINT.stroke_width(3));
            chart.draw_series(guide)?;
            let label = Text::new(name, at(left * (end / left).powf(0.93)), coloured(30, INK));
            chart.draw_series([label])?;
        }
        for curve in &self.curves {
            let stroke = curve.stroke;
            let low = |e: &Error| (e.n as f64, e.low.max(bottom));
            let up = curve
                .errors
                .iter()
                .map(|e| (e.n as f64, e.high.max(bottom)));
            let band: Vec<_> = up.chain(curve.errors.iter().rev().map(low)).collect();
            chart.draw_series([Polygon::new(band, stroke.color.mix(0.18))])?;
            let inside: Vec<_> = curve.errors.iter().filter(|e| e.rms >= bottom).collect();
            let line = inside.iter().map(|e| (e.n as f64, e.rms));
            let measured: Vec<_> = inside.iter().map(|e| **e).collect();
            let name = format!("{}: {:.2}", curve.title, slope(&measured)).replace(": -", ": −");
            chart
                .draw_series(LineSeries::new(line.clone(), stroke))?
                .label(name)
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 40, y)], stroke));
            if stroke.color.3 == 1.0 {
                chart.draw_series(line.map(|p| Circle::new(p, 6, stroke.filled())))?;
            }
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::LowerLeft)
            .label_font(font(28))
            .legend_area_size(60)
            .margin(20)
            .background_style(WHITE.mix(0.9))
            .border_style(FAINT)
            .draw()?;
        Ok(())
    }

    fn csv(&self) -> String {
        let mut csv = "pattern,samples,rms_error,low_95,high_95\n".to_owned();
        for curve in &self.curves {
            for Error { n, rms, low, high } in &curve.errors {
                let _ = writeln!(csv, "{},{n},{rms},{low},{high}", curve.key);
            }
        }
        csv
    }
}

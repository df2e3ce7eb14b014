//! Error against samples, both axes logarithmic.

use crate::kit::axis::Axis;
use crate::kit::chart::{Chart, Corner};
use crate::kit::figure::CENTRE;
use crate::kit::palette::{FAINT, INK};
use crate::kit::stage::Drawn;
use crate::lab::integrands::{Error, slope};
use crate::lab::plot::Plot;
use plotters::coord::Shift;
use plotters::prelude::{Color, DrawingArea, DrawingBackend, ShapeStyle};
use std::fmt::Write;

/// Slopes that are drawn as guides, with what they mean.
const GUIDES: [(f64, &str); 4] = [(-0.5, "−½"), (-0.75, "−¾"), (-1.0, "−1"), (-1.5, "−3/2")];

/// The curve of one pattern.
#[derive(Debug)]
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
#[derive(Debug)]
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
        let samples = Axis::log2(left..right).named("samples");
        let errors = Axis::log(bottom..top)
            .named("RMS error")
            .format(|error| format!("{error:.0e}"));
        let mut chart = Chart::new(samples, errors)
            .titled(&self.title)
            .text(28)
            .legend(Corner::LowerLeft);
        for (slope, name) in GUIDES {
            let at = |n: f64| (n, 0.75 * top * (n / left).powf(slope));
            let end = right.min(left * (0.75 * top / bottom).powf(-1.0 / slope));
            let beside = at(left * (end / left).powf(0.93));
            chart
                .line([at(left), at(end)], FAINT.stroke_width(3))
                .label(CENTRE, beside, name, INK);
        }
        for curve in &self.curves {
            let stroke = curve.stroke;
            let low = |e: &Error| (e.n as f64, e.low.max(bottom));
            let up = curve
                .errors
                .iter()
                .map(|e| (e.n as f64, e.high.max(bottom)));
            let band = up.chain(curve.errors.iter().rev().map(low));
            chart.area(band, stroke.color.mix(0.18));
            let inside: Vec<_> = curve.errors.iter().filter(|e| e.rms >= bottom).collect();
            let line = || inside.iter().map(|e| (e.n as f64, e.rms));
            let measured: Vec<_> = inside.iter().map(|e| **e).collect();
            let name = format!("{}: {:.2}", curve.title, slope(&measured)).replace(": -", ": −");
            chart.line(line(), stroke).named(&name);
            if stroke.color.3 == 1.0 {
                chart.dots(line(), 6, stroke.filled());
            }
        }
        chart.draw(canvas)
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

//! Error against samples, both axes logarithmic.

use crate::kit::axis::Axis;
use crate::kit::chart::Chart;
use crate::kit::figure::{CENTRE, Canvas};
use crate::kit::palette::{FAINT, INK};
use crate::kit::pen::Pen;
use crate::kit::stage::Drawn;
use crate::lab::errors::{Error, slope};
use crate::lab::legend;
use crate::lab::legend::{number, power_of_ten};
use crate::lab::plot::Plot;
use plotters::prelude::{Color, RGBColor};
use std::fmt::Write;

/// Slopes that are drawn as guides, with what they mean.
const GUIDES: [(f64, &str); 4] = [(-0.5, "−½"), (-0.75, "−¾"), (-1.0, "−1"), (-1.5, "−3/2")];

/// Width of the plot beside a legend with slopes and beside one without; and where the slopes end in the legend, in pixels of the canvas.
const PLOT: i32 = 730;
const WIDE_PLOT: i32 = 910;
const SLOPES: i32 = 590;

/// Up to this number of octaves of samples, each power of two is marked; up to twice this number, each power of four, and so on.
const OCTAVES: f64 = 5.0;

/// Maximum number of curves with bands: more bands would hide each other.
const SEPARATE: usize = 3;

/// The curve of one pattern.
#[derive(Debug)]
pub struct Curve {
    /// The pattern's name as a word.
    pub key: String,
    /// The pattern's name as people write it.
    pub title: String,
    /// The curve's line and marks.
    pub pen: Pen,
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
        // Bands reach down to errors that are small by chance: they are cut off.
        let bottom = least(|e| e.median).max(1e-6 * top);
        [left, right, 0.5 * bottom, 1.5 * top]
    }
}

impl ErrorPlot {
    /// Slopes that have names: each guide's name, its two ends, and the place of its name.
    fn guides(&self) -> impl Iterator<Item = (&'static str, [(f64, f64); 2], (f64, f64))> {
        let [left, right, bottom, top] = self.range();
        GUIDES.into_iter().map(move |(slope, name)| {
            let at = |n: f64| (n, 0.75 * top * (n / left).powf(slope));
            let end = right.min(left * (0.75 * top / bottom).powf(-1.0 / slope));
            let (n, error) = at(left * (end / left).powf(0.93));
            let below = (n, error * (bottom / top).powf(0.035));
            (name, [at(left), at(end)], below)
        })
    }

    /// The legend's lines: each curve's name, and its slope where there is one.
    fn entries(&self) -> Vec<legend::Entry> {
        let entry = |curve: &Curve| {
            let fitted = slope(&curve.errors);
            let slope = fitted.map(|s| format!("{} ± {:.2}", number(s.slope, 2), s.within));
            (
                curve.pen,
                curve.title.clone(),
                vec![slope.unwrap_or_default()],
            )
        };
        self.curves.iter().map(entry).collect()
    }
}

impl Plot for ErrorPlot {
    fn size(&self) -> (u32, u32) {
        (670, 490)
    }

    fn draw(&self, canvas: &Canvas) -> Drawn {
        let [left, right, bottom, top] = self.range();
        // To the right of the last number of samples, a bar shows the middle 80 % of each curve that was measured more than once.
        let beyond = |i: usize| right * 1.35_f64.powi(i as i32 + 1);
        let mut measured = self.curves.iter().flat_map(|curve| &curve.errors);
        let is_spread = measured.any(|e| e.low < e.high);
        let end = if is_spread {
            beyond(self.curves.len())
        } else {
            1.1 * right
        };
        let step = ((right / left).log2() / OCTAVES).ceil().max(1.0) as usize;
        let powers = (0..=32).step_by(step).map(|power| 2_f64.powi(power));
        let marks: Vec<_> = powers.filter(|n| (left..=right).contains(n)).collect();
        let samples = Axis::log2(left..end).named("samples").marks(&marks);
        let errors = Axis::log(bottom..top).named("error").format(power_of_ten);
        let mut chart = Chart::new(samples, errors).titled(&self.title).text(30);
        for (i, curve) in self.curves.iter().enumerate() {
            let low = |e: &Error| (e.n as f64, e.low.max(bottom));
            let high = |e: &Error| (e.n as f64, e.high.max(bottom));
            let back = curve.errors.iter().rev().map(low);
            if self.curves.len() <= SEPARATE {
                let band = curve.errors.iter().map(high).chain(back);
                chart.area(band, rgb(curve.pen).mix(0.15));
            }
            if let Some(last) = curve.errors.last().filter(|_| is_spread) {
                let ends = [low(last).1, high(last).1].map(|error| (beyond(i), error));
                chart.line(ends, rgb(curve.pen).stroke_width(6));
                if last.median >= bottom {
                    chart.curve([(beyond(i), last.median)], curve.pen);
                }
            }
        }
        for curve in &self.curves {
            let inside = curve.errors.iter().filter(|e| e.median >= bottom);
            chart.curve(inside.map(|e| (e.n as f64, e.median)), curve.pen);
        }
        // Curves do not cover the guides.
        for (name, ends, below) in self.guides() {
            chart.dashes(ends, INK.mix(0.6).stroke_width(2));
            chart.label(CENTRE, below, name, INK);
        }
        let entries = self.entries();
        let has_slopes = entries.iter().any(|(_, _, slope)| !slope[0].is_empty());
        let (width, head) = if has_slopes {
            (PLOT, "slope from 64 on")
        } else {
            (WIDE_PLOT, "")
        };
        let (plot, beside) = canvas.split_horizontally(width);
        chart.draw(&plot)?;
        legend::draw(&beside, (10, 50), &[head], &[SLOPES], &entries)
    }

    fn csv(&self) -> String {
        let mut csv = "pattern,samples,median_error,low_10,high_90,rms_error\n".to_owned();
        for curve in &self.curves {
            for Error {
                n,
                median,
                low,
                high,
                rms,
            } in &curve.errors
            {
                let _ = writeln!(csv, "{},{n},{median},{low},{high},{rms}", curve.key);
            }
        }
        csv
    }
}

/// The same curves, a panel for each: its own curve in colour, and the others pale. Curves that hide each other in a single plot are
/// told apart.
#[derive(Debug)]
pub struct OneByOne<'a>(pub &'a ErrorPlot);

/// Panels in a row, and the width and height of a panel in pixels.
const PANELS: u32 = 4;
const PANEL: (u32, u32) = (330, 250);

impl Plot for OneByOne<'_> {
    fn size(&self) -> (u32, u32) {
        let rows = (self.0.curves.len() as u32).div_ceil(PANELS);
        (PANELS * PANEL.0, rows * PANEL.1)
    }

    fn draw(&self, canvas: &Canvas) -> Drawn {
        let [left, right, bottom, top] = self.0.range();
        let places = |curve: &Curve| -> Vec<_> {
            let inside = curve.errors.iter().filter(|e| e.median >= bottom);
            inside.map(|e| (e.n as f64, e.median)).collect()
        };
        let rows = self.0.curves.len().div_ceil(PANELS as usize);
        let panels = canvas.split_evenly((rows, PANELS as usize));
        for (curve, panel) in self.0.curves.iter().zip(&panels) {
            let samples = Axis::log2(left..1.1 * right).named("samples").labels(5);
            let errors = Axis::log(bottom..top).named("error").format(power_of_ten);
            let mut chart = Chart::new(samples, errors).titled(&curve.title).text(26);
            for other in &self.0.curves {
                chart.line(places(other), FAINT.stroke_width(2));
            }
            chart.curve(places(curve), curve.pen);
            chart.draw(panel)?;
        }
        Ok(())
    }

    fn csv(&self) -> String {
        self.0.csv()
    }
}

/// A pen's colour.
fn rgb(pen: Pen) -> RGBColor {
    let colour = pen.stroke.color;
    RGBColor(colour.0, colour.1, colour.2)
}

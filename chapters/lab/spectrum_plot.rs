//! A power spectrum as a picture, its mean over rings, and how much it varies within them.

use crate::kit::axis::Axis;
use crate::kit::chart::Chart;
use crate::kit::figure::{CENTRE, text, write};
use crate::kit::palette::{BLUE, FAINT};
use crate::kit::stage::Drawn;
use crate::lab::plot::Plot;
use crate::lab::spectrum::Spectrum;
use plotters::coord::Shift;
use plotters::prelude::{Color, DrawingArea, DrawingBackend, RGBColor, Rectangle};
use raybook::image::rgb::Rgb;
use raybook::image::tone;
use std::fmt::Write;

/// Sides of the picture, in pixels of the canvas.
const SIDE: i32 = 520;
/// The space above it and to its left.
const TOP: i32 = 90;
const LEFT: i32 = 40;

/// The spectrum of a pattern.
#[derive(Debug)]
pub struct SpectrumPlot {
    /// The pattern's name, as people write it, and of how many points.
    pub title: String,
    /// The spectrum.
    pub spectrum: Spectrum,
}

impl SpectrumPlot {
    /// Black for no power, white for twice that of random points and more.
    fn grey(&self, x: i32, y: i32) -> RGBColor {
        let power = if x == 0 && y == 0 {
            0.0 // always n: it says nothing
        } else {
            self.spectrum.at(x, y)
        };
        let Rgb { g, .. } = Rgb::gray((0.5 * power).clamp(0.0, 1.0) as f32).map(tone::encode_srgb);
        let code = (255.0 * g).round() as u8;
        RGBColor(code, code, code)
    }
}

impl Plot for SpectrumPlot {
    fn size(&self) -> (u32, u32) {
        (1000, 330)
    }

    fn draw<B: DrawingBackend>(&self, canvas: &DrawingArea<B, Shift>) -> Drawn
    where
        B::ErrorType: 'static,
    {
        let limit = self.spectrum.limit as i32;
        let edge = |f: i32| (f + limit) * SIDE / (2 * limit + 1);
        let above = (LEFT + SIDE / 2, TOP / 2);
        write(canvas, &self.title, above, text(40).pos(CENTRE))?;
        for y in -limit..=limit {
            for x in -limit..=limit {
                let corners = [
                    (LEFT + edge(x), TOP + edge(y)),
                    (LEFT + edge(x + 1), TOP + edge(y + 1)),
                ];
                canvas.draw(&Rectangle::new(corners, self.grey(x, y).filled()))?;
            }
        }
        let (_, curves) = canvas.split_horizontally(LEFT + SIDE + 20);
        let (radial, anisotropy) = curves.split_horizontally(700);
        let power = self.spectrum.radial();
        curve(&radial, "mean power", [0.0, 3.0], 1.0, &power)?;
        let decibels: Vec<_> = self.spectrum.anisotropy();
        let decibels: Vec<_> = decibels
            .into_iter()
            .map(|(r, a)| (r, 10.0 * a.max(1e-4).log10()))
            .collect();
        curve(&anisotropy, "anisotropy, dB", [-30.0, 20.0], 0.0, &decibels)
    }

    fn csv(&self) -> String {
        let mut csv = "frequency,mean_power,anisotropy\n".to_owned();
        let rings = self.spectrum.radial().into_iter();
        for ((r, power), (_, anisotropy)) in rings.zip(self.spectrum.anisotropy()) {
            let _ = writeln!(csv, "{r},{power},{anisotropy}");
        }
        csv
    }
}

/// A curve over the frequency, what is beyond the range cut off, with a faint line at a level.
fn curve<B: DrawingBackend>(
    canvas: &DrawingArea<B, Shift>,
    title: &str,
    [low, high]: [f64; 2],
    level: f64,
    points: &[(f64, f64)],
) -> Drawn
where
    B::ErrorType: 'static,
{
    let right = points.last().map_or(1.0, |p| p.0);
    let whole = |v: f64| format!("{v:.0}");
    let frequencies = Axis::linear(0.0..right)
        .named("frequency, waves across the square")
        .labels(6)
        .format(whole);
    let values = Axis::linear(low..high).labels(6).format(whole);
    let mut chart = Chart::new(frequencies, values).titled(title).text(28);
    let cut = points.iter().map(|&(r, v)| (r, v.clamp(low, high)));
    chart
        .line([(0.0, level), (right, level)], FAINT.stroke_width(4))
        .line(cut, BLUE.stroke_width(5));
    chart.draw(canvas)
}

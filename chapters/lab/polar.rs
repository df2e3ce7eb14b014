//! The error of an edge, by the angle at which it passes through the pixel.

use crate::kit::figure::{CENTRE as MIDDLE, LEFT, RIGHT, text, write};
use crate::kit::palette::FAINT;
use crate::kit::stage::Drawn;
use crate::lab::edge;
use crate::lab::plot::{Plot, strokes};
use crate::lab::subject::Subject;
use plotters::coord::Shift;
use plotters::prelude::{Circle, Color, DrawingArea, DrawingBackend, PathElement, ShapeStyle};
use plotters::style::text_anchor::Pos;
use rayon::prelude::*;
use std::f64::consts::PI;
use std::fmt::Write;

/// Angles of the half circle that are measured; the other half is the same.
const ANGLES: usize = 180;

/// The centre of the plot and its radius, in pixels of the canvas.
const CENTRE: (i32, i32) = (560, 600);
const RADIUS: f64 = 500.0;

/// Where the legend's lines, names and two columns of numbers are, from left to right.
const LEGEND: [i32; 4] = [1370, 1450, 1900, 2060];

/// A curve for each pattern.
#[derive(Debug)]
pub struct Polar {
    /// How many points a pixel.
    n: usize,
    curves: Vec<Curve>,
}

/// A pattern's errors.
#[derive(Debug)]
struct Curve {
    key: String,
    title: String,
    stroke: ShapeStyle,
    /// The RMS error at each angle of the half circle.
    errors: Vec<f64>,
}

impl Polar {
    /// Measures the patterns, random ones by so many realisations.
    pub fn measure(subjects: &[Subject], n: usize, realisations: u64) -> Self {
        let curve = |(subject, stroke): (&Subject, ShapeStyle)| {
            let angle = |i: usize| PI * i as f64 / ANGLES as f64;
            let errors = (0..ANGLES)
                .into_par_iter()
                .map(|i| edge::rms(subject, n, angle(i), realisations))
                .collect();
            Curve {
                key: subject.key(),
                title: subject.title(),
                stroke,
                errors,
            }
        };
        Self {
            n,
            curves: subjects.iter().zip(strokes(subjects)).map(curve).collect(),
        }
    }
}

impl Plot for Polar {
    fn size(&self) -> (u32, u32) {
        (1060, 610)
    }

    fn draw<B: DrawingBackend>(&self, canvas: &DrawingArea<B, Shift>) -> Drawn
    where
        B::ErrorType: 'static,
    {
        let all = self.curves.iter().flat_map(|curve| &curve.errors);
        let largest = all.fold(0.0_f64, |largest, e| largest.max(*e));
        let step = if largest > 0.1 { 0.05 } else { 0.02 };
        let rings = (largest / step).ceil().max(1.0);
        let place = |error: f64, angle: f64| {
            let r = RADIUS * error / (rings * step);
            let (x, y) = (r * angle.cos(), r * angle.sin());
            (CENTRE.0 + x.round() as i32, CENTRE.1 - y.round() as i32)
        };
        for ring in 1..=rings as i32 {
            let r = (RADIUS * f64::from(ring) / rings) as i32;
            canvas.draw(&Circle::new(CENTRE, r, FAINT.stroke_width(2)))?;
        }
        for spoke in 0..8 {
            let angle = PI * f64::from(spoke) / 8.0;
            let ends = [angle, angle + PI].map(|angle| place(rings * step, angle));
            canvas.draw(&PathElement::new(ends.to_vec(), FAINT.stroke_width(2)))?;
        }
        for curve in &self.curves {
            let mut line: Vec<_> = (0..=2 * ANGLES)
                .map(|k| place(curve.errors[k % ANGLES], PI * k as f64 / ANGLES as f64))
                .collect();
            line.dedup();
            canvas.draw(&PathElement::new(line, curve.stroke))?;
        }
        for ring in 1..=rings as i32 {
            let error = f64::from(ring) * step;
            let at = place(error, 0.62 * PI / 4.0);
            write(canvas, &format!("{error:.2}"), at, text(30).pos(MIDDLE))?;
        }
        for (label, angle) in [("vertical edge", 0.0), ("horizontal edge", 0.5 * PI)] {
            let (x, y) = place(rings * step, angle);
            let at = if angle == 0.0 {
                (x + 130, y)
            } else {
                (x, y - 40)
            };
            write(canvas, label, at, text(32).pos(MIDDLE))?;
        }
        self.legend(canvas)
    }

    fn csv(&self) -> String {
        let mut csv = "pattern,samples,degrees,rms_error\n".to_owned();
        for Curve { key, errors, .. } in &self.curves {
            for (i, error) in errors.iter().enumerate() {
                let degrees = 180.0 * i as f64 / ANGLES as f64;
                let _ = writeln!(csv, "{key},{},{degrees},{error}", self.n);
            }
        }
        csv
    }
}

impl Polar {
    /// What is measured, and each curve's line with its name, mean and worst.
    fn legend<B: DrawingBackend>(&self, canvas: &DrawingArea<B, Shift>) -> Drawn
    where
        B::ErrorType: 'static,
    {
        let say =
            |words: &str, at: (i32, i32), end: Pos| write(canvas, words, at, text(32).pos(end));
        let samples = if self.n == 1 { "sample" } else { "samples" };
        let heading = format!("RMS error of the covered area, {} {samples}", self.n);
        say(&heading, (LEGEND[0], 70), LEFT)?;
        let [swatch, name, mean, worst] = LEGEND;
        say("mean", (mean, 150), RIGHT)?;
        say("worst", (worst, 150), RIGHT)?;
        for (curve, i) in self.curves.iter().zip(0..) {
            let y = 220 + 70 * i;
            let line = vec![(swatch, y), (swatch + 60, y)];
            canvas.draw(&PathElement::new(line, curve.stroke))?;
            say(&curve.title, (name, y), LEFT)?;
            let of_angles = curve.errors.iter().sum::<f64>() / ANGLES as f64;
            let largest = curve.errors.iter().fold(0.0_f64, |most, e| most.max(*e));
            say(&format!("{of_angles:.4}"), (mean, y), RIGHT)?;
            say(&format!("{largest:.4}"), (worst, y), RIGHT)?;
        }
        Ok(())
    }
}

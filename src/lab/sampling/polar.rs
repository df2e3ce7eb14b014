//! The error of an edge, by the angle at which it passes through the pixel.

use crate::lab::palette::{FAINT, INK};
use crate::lab::sampling::plot::{Drawn, Plot, colour, coloured, text};
use crate::lab::sampling::{edge, title};
use crate::sample::pattern::Pattern;
use plotters::coord::Shift;
use plotters::prelude::{Circle, Color, DrawingArea, DrawingBackend, PathElement, Text};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use rayon::prelude::*;
use std::f64::consts::PI;
use std::fmt::Write;

/// Angles of the half circle that are measured; the other half is the same.
const ANGLES: usize = 180;

/// The centre of the plot and its radius, in pixels of the canvas.
const CENTRE: (i32, i32) = (560, 600);
const RADIUS: f64 = 500.0;

/// A curve for each pattern.
pub struct Polar {
    /// How many points a pixel.
    n: usize,
    /// Name, and the RMS error at each angle of the half circle.
    curves: Vec<(&'static str, String, Vec<f64>)>,
}

impl Polar {
    /// Measures the patterns, random ones by so many realisations.
    pub fn measure(patterns: &[Pattern], n: usize, realisations: u64) -> Self {
        let curve = |pattern: &Pattern| {
            let angle = |i: usize| PI * i as f64 / ANGLES as f64;
            let errors = (0..ANGLES)
                .into_par_iter()
                .map(|i| edge::rms(pattern, n, angle(i), realisations))
                .collect();
            (pattern.name, title(pattern), errors)
        };
        Self {
            n,
            curves: patterns.iter().map(curve).collect(),
        }
    }
}

impl Plot for Polar {
    fn size(&self) -> (u32, u32) {
        (960, 610)
    }

    fn draw<B: DrawingBackend>(&self, canvas: &DrawingArea<B, Shift>) -> Drawn
    where
        B::ErrorType: 'static,
    {
        let all = self.curves.iter().flat_map(|curve| &curve.2);
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
        for (i, (_, name, errors)) in self.curves.iter().enumerate() {
            let mut line: Vec<_> = (0..=2 * ANGLES)
                .map(|k| place(errors[k % ANGLES], PI * k as f64 / ANGLES as f64))
                .collect();
            line.dedup();
            canvas.draw(&PathElement::new(line, colour(i).stroke_width(5)))?;
            let mean = errors.iter().sum::<f64>() / ANGLES as f64;
            let worst = errors.iter().fold(0.0_f64, |worst, e| worst.max(*e));
            let left = Pos::new(HPos::Left, VPos::Center);
            let at = (1360, 240 + 120 * i as i32);
            canvas.draw(&Text::new(
                name.as_str(),
                at,
                coloured(40, colour(i)).pos(left),
            ))?;
            let numbers = format!("mean {mean:.4}, worst {worst:.4}");
            canvas.draw(&Text::new(numbers, (at.0, at.1 + 48), text(32).pos(left)))?;
        }
        for ring in 1..=rings as i32 {
            let error = f64::from(ring) * step;
            let at = place(error, 0.62 * PI / 4.0);
            canvas.draw(&Text::new(format!("{error:.2}"), at, coloured(30, INK)))?;
        }
        for (label, angle) in [("vertical edge", 0.0), ("horizontal edge", 0.5 * PI)] {
            let (x, y) = place(rings * step, angle);
            let at = if angle == 0.0 {
                (x + 130, y)
            } else {
                (x, y - 40)
            };
            canvas.draw(&Text::new(label, at, text(32)))?;
        }
        let heading = format!("RMS error of the covered area, {} samples", self.n);
        let left = Pos::new(HPos::Left, VPos::Center);
        canvas.draw(&Text::new(heading, (1160, 90), text(36).pos(left)))?;
        Ok(())
    }

    fn csv(&self) -> String {
        let mut csv = "pattern,samples,degrees,rms_error\n".to_owned();
        for (name, _, errors) in &self.curves {
            for (i, error) in errors.iter().enumerate() {
                let degrees = 180.0 * i as f64 / ANGLES as f64;
                let _ = writeln!(csv, "{name},{},{degrees},{error}", self.n);
            }
        }
        csv
    }
}

//! The error of an edge, by the angle at which it passes through the pixel.

use crate::kit::figure::{CENTRE as MIDDLE, Canvas, LEFT, text, write};
use crate::kit::of_each::of_each;
use crate::kit::palette::{FAINT, INK};
use crate::kit::pen::Pen;
use crate::kit::stage::Drawn;
use crate::lab::edge;
use crate::lab::legend;
use crate::lab::legend::number;
use crate::lab::pens::pens;
use crate::lab::plot::Plot;
use crate::lab::subject::Subject;
use plotters::prelude::{Circle, Color, PathElement, Rectangle, WHITE};
use std::f64::consts::PI;
use std::fmt::Write;

/// Angles of the half circle that are measured; the other half is the same.
const ANGLES: usize = 180;

/// Number of angles from one mark to the next.
const MARKED: usize = 24;

/// Where a polar plot is on its canvas, in pixels.
#[derive(Clone, Copy, Debug)]
pub struct Dial {
    /// The centre.
    pub centre: (i32, i32),
    /// The radius of the outermost ring; small edges are outside of it.
    pub radius: f64,
}

/// The polar plot that has a legend at its right.
const DIAL: Dial = Dial {
    centre: (350, 400),
    radius: 280.0,
};

/// Height of the numbers on the rings, in radii: 34 pixels beside a legend.
const LETTERS: f64 = 34.0 / DIAL.radius;

/// Where the legend is, and its columns of numbers.
const LEGEND: (i32, i32) = (720, 90);
const COLUMNS: [i32; 2] = [490, 600];

/// A curve for each pattern.
#[derive(Debug)]
pub struct Polar {
    /// Points per pixel.
    n: usize,
    /// The curves.
    pub curves: Vec<Curve>,
}

/// A pattern's errors.
#[derive(Debug)]
pub struct Curve {
    key: String,
    title: String,
    pen: Pen,
    /// The RMS error at each angle of the half circle.
    errors: Vec<f64>,
}

impl Curve {
    /// The mean over all angles.
    pub fn mean(&self) -> f64 {
        self.errors.iter().sum::<f64>() / self.errors.len() as f64
    }

    /// The error at the worst angle.
    pub fn worst(&self) -> f64 {
        self.errors.iter().copied().fold(0.0, f64::max)
    }

    /// The mean error at edges that are at most 2° off an axis.
    pub fn along_axes(&self) -> f64 {
        let near = (0..ANGLES).filter(|i| (i % 90).min(90 - i % 90) <= 2);
        let all: Vec<_> = near.map(|i| self.errors[i]).collect();
        all.iter().sum::<f64>() / all.len() as f64
    }
}

impl Polar {
    /// Measures the patterns by this number of realisations.
    pub fn measure(subjects: &[Subject], n: usize, realisations: u64) -> Self {
        let curve = |(subject, pen): (&Subject, Pen)| {
            let count = subject.realisations(n, realisations);
            let mut drawn = of_each(count as usize, |k| subject.points(n, k as u64));
            drawn.dedup(); // all realisations of a grid are the same
            let angle = |i: usize| PI * i as f64 / ANGLES as f64;
            Curve {
                key: subject.key.clone(),
                title: subject.title.clone(),
                pen,
                errors: of_each(ANGLES, |i| edge::rms(&drawn, angle(i))),
            }
        };
        Self {
            n,
            curves: subjects.iter().zip(pens(subjects)).map(curve).collect(),
        }
    }

    /// The step from ring to ring, and how many there are.
    fn rings(&self) -> (f64, f64) {
        let largest = self.curves.iter().map(Curve::worst).fold(0.0, f64::max);
        let steps = [0.002, 0.005, 0.01, 0.02, 0.05, 0.1];
        let few = steps.into_iter().find(|step| largest / step <= 6.0);
        let step = few.unwrap_or(0.1);
        (step, (largest / step).ceil().max(1.0))
    }

    /// The error from ring to ring, in words.
    pub fn per_ring(&self) -> String {
        format!("{} per ring", written(self.rings().0))
    }

    /// Where an error at an angle is.
    fn place(&self, dial: Dial, error: f64, angle: f64) -> (i32, i32) {
        let (step, rings) = self.rings();
        let r = dial.radius * error / (rings * step);
        let (x, y) = (r * angle.cos(), r * angle.sin());
        let (left, top) = dial.centre;
        (left + x.round() as i32, top - y.round() as i32)
    }

    /// Draws the plot without its heading and its legend.
    ///
    /// # Errors
    /// What the backend reports.
    pub fn draw_on(&self, canvas: &Canvas, dial: Dial) -> Drawn {
        self.grid(canvas, dial)?;
        for (number, curve) in self.curves.iter().enumerate() {
            let at = |k: usize| {
                let angle = PI * k as f64 / ANGLES as f64;
                self.place(dial, curve.errors[k % ANGLES], angle)
            };
            let mut line: Vec<_> = (0..=2 * ANGLES).map(at).collect();
            line.dedup();
            curve.pen.line(canvas, &line)?;
            // No two curves have their marks at the same angles.
            let first = number * MARKED / self.curves.len();
            for k in (first..2 * ANGLES).step_by(MARKED) {
                curve.pen.mark(canvas, at(k))?;
            }
        }
        self.labels(canvas, dial)
    }

    fn grid(&self, canvas: &Canvas, dial: Dial) -> Drawn {
        let (step, rings) = self.rings();
        for ring in 1..=rings as i32 {
            let r = (dial.radius * f64::from(ring) / rings) as i32;
            canvas.draw(&Circle::new(dial.centre, r, FAINT.stroke_width(2)))?;
        }
        for spoke in 0..8 {
            let angle = PI * f64::from(spoke) / 8.0;
            let ends = [angle, angle + PI].map(|angle| self.place(dial, rings * step, angle));
            canvas.draw(&PathElement::new(ends.to_vec(), FAINT.stroke_width(2)))?;
        }
        Ok(())
    }

    /// The number of the outermost ring, where there are no curves, and small edges outside of it, as they pass through a pixel there.
    fn labels(&self, canvas: &Canvas, dial: Dial) -> Drawn {
        let (step, rings) = self.rings();
        let (words, at) = (
            written(rings * step),
            self.place(dial, rings * step, 0.31 * PI),
        );
        let height = LETTERS * dial.radius;
        // The ring itself does not cross its number.
        let half = [0.3 * height * words.len() as f64, 0.5 * height].map(|half| half as i32);
        let corners = [-1, 1].map(|side| (at.0 + side * half[0], at.1 + side * half[1]));
        canvas.draw(&Rectangle::new(corners, WHITE.filled()))?;
        write(canvas, &words, at, text(height).pos(MIDDLE))?;
        for spoke in 0..16 {
            let angle = PI * f64::from(spoke) / 8.0;
            let (sin, cos) = angle.sin_cos();
            let outside = dial.radius + 36.0;
            let (x, y) = (
                dial.centre.0 + (outside * cos) as i32,
                dial.centre.1 - (outside * sin) as i32,
            );
            let corners = [(-20, -20), (20, -20), (20, 20), (-20, 20), (-20, -20)];
            let pixel: Vec<_> = corners.iter().map(|(dx, dy)| (x + dx, y + dy)).collect();
            canvas.draw(&PathElement::new(pixel, FAINT.stroke_width(2)))?;
            let reach = 20.0 / sin.abs().max(cos.abs());
            let end = |t: f64| (x + (t * reach * sin) as i32, y + (t * reach * cos) as i32);
            canvas.draw(&PathElement::new(
                [end(-1.0), end(1.0)],
                INK.stroke_width(5),
            ))?;
        }
        Ok(())
    }
}

/// An error as a ring's number.
fn written(error: f64) -> String {
    (error as f32).to_string()
}

impl Plot for Polar {
    fn size(&self) -> (u32, u32) {
        let below = LEGEND.1 + legend::LINE * (self.curves.len() as i32 + 2);
        // Two stand side by side in a window of 1400 pixels.
        (670, 380_i32.max(below / 2) as u32)
    }

    fn draw(&self, canvas: &Canvas) -> Drawn {
        self.draw_on(canvas, DIAL)?;
        let samples = if self.n == 1 { "sample" } else { "samples" };
        let heading = format!("RMS error, {} {samples}", self.n);
        write(canvas, &heading, (LEGEND.0, 46), text(32).pos(LEFT))?;
        let below = (LEGEND.0, LEGEND.1 + legend::LINE / 2);
        write(canvas, &self.per_ring(), below, text(30).pos(LEFT))?;
        let entry = |curve: &Curve| {
            let numbers = [curve.mean(), curve.worst()].map(|error| number(error, 4));
            (curve.pen, curve.title.clone(), numbers.to_vec())
        };
        let entries: Vec<_> = self.curves.iter().map(entry).collect();
        legend::draw(canvas, LEGEND, &["mean", "worst"], &COLUMNS, &entries)
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

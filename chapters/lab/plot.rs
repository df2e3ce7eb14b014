//! A plot that can be drawn as pixels and as an SVG file, and its numbers as a table.

use crate::kit::figure::{Figure, SCALE, figure};
use crate::kit::stage::Drawn;
use crate::lab::subject::Subject;
use plotters::coord::Shift;
use plotters::prelude::{
    BLACK, Color, DrawingArea, DrawingBackend, IntoDrawingArea, RGBColor, SVGBackend, ShapeStyle,
    WHITE,
};
use std::error::Error;

/// Something to be looked at, in whatever form.
pub trait Plot {
    /// Width and height in pixels; the canvas has [`SCALE`] times as many.
    fn size(&self) -> (u32, u32);

    /// Draws it.
    ///
    /// # Errors
    /// What the backend reports.
    fn draw<B: DrawingBackend>(&self, canvas: &DrawingArea<B, Shift>) -> Drawn
    where
        B::ErrorType: 'static;

    /// Its numbers: a line of names, and a line for each point.
    fn csv(&self) -> String;

    /// As pixels.
    ///
    /// # Errors
    /// What plotters reports.
    fn image(&self) -> Figure {
        let (width, height) = self.size();
        figure(width, height, |canvas| self.draw(canvas))
    }

    /// As the text of an SVG file.
    ///
    /// # Errors
    /// What plotters reports.
    fn svg(&self) -> Result<String, Box<dyn Error>> {
        let (width, height) = self.size();
        // The font is registered with the first figure.
        figure(1, 1, |_| Ok(()))?;
        let mut text = String::new();
        {
            let size = (SCALE * width, SCALE * height);
            let canvas = SVGBackend::with_string(&mut text, size).into_drawing_area();
            canvas.fill(&WHITE)?;
            self.draw(&canvas)?;
            canvas.present()?;
        }
        Ok(text)
    }
}

/// The colours of curves, in order: seven, and then the same ones darker.
pub fn colour(i: usize) -> RGBColor {
    use crate::kit::palette::{BLUE, GREEN, ORANGE, PURPLE, SKY, VERMILION};
    let RGBColor(r, g, b) = [VERMILION, BLUE, GREEN, ORANGE, PURPLE, SKY, BLACK][i % 7];
    match i / 7 {
        0 => RGBColor(r, g, b),
        _ => RGBColor(r / 2, g / 2, b / 2),
    }
}

/// How the curve of each subject is drawn.
///
/// A pattern has a colour, and somebody's own curve has its pattern's: the library's is then a broad pale line, on which the
/// own one lies if it is right.
pub fn strokes(subjects: &[Subject]) -> Vec<ShapeStyle> {
    let mut names: Vec<_> = subjects.iter().map(|s| s.pattern.name).collect();
    names.dedup();
    let stroke = |subject: &Subject| {
        let name = subject.pattern.name;
        let colour = colour(names.iter().position(|n| *n == name).unwrap_or(0));
        let beneath = |other: &Subject| other.is_own() && other.pattern.name == name;
        if !subject.is_own() && subjects.iter().any(beneath) {
            colour.mix(0.35).stroke_width(16)
        } else {
            colour.stroke_width(5)
        }
    };
    subjects.iter().map(stroke).collect()
}

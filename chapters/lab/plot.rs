//! A plot that can be drawn as pixels and as an SVG file, and its numbers as a table.

use crate::kit::figure::{Figure, SCALE, canvas, figure};
use crate::kit::stage::Drawn;
use crate::lab::raster::Raster;
use plotters::coord::Shift;
use plotters::prelude::{DrawingArea, DrawingBackend, IntoDrawingArea, SVGBackend, WHITE};
use std::error::Error;

/// Something to be looked at, in whatever form.
pub trait Plot {
    /// Width and height in pixels; the canvas has [`SCALE`] times as many.
    fn size(&self) -> (u32, u32);

    /// Draws it, but for what is made of pixels.
    ///
    /// # Errors
    /// What the backend reports.
    fn draw<B: DrawingBackend>(&self, canvas: &DrawingArea<B, Shift>) -> Drawn
    where
        B::ErrorType: 'static;

    /// What is made of pixels; nothing is drawn over it.
    fn rasters(&self) -> Vec<Raster> {
        Vec::new()
    }

    /// Its numbers: a line of names, and a line for each point.
    fn csv(&self) -> String;

    /// As pixels.
    ///
    /// # Errors
    /// What plotters reports.
    fn image(&self) -> Figure {
        let (width, height) = self.size();
        figure(width, height, |canvas| self.draw_all(canvas))
    }

    /// As pixels, at twice the resolution.
    ///
    /// # Errors
    /// What plotters reports.
    fn large_image(&self) -> Figure {
        let (width, height) = self.size();
        canvas(width, height, |canvas| self.draw_all(canvas))
    }

    /// As the text of an SVG file, with pictures inside.
    ///
    /// # Errors
    /// What plotters reports, and if a picture has no pixels.
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
        let pictures: String = self
            .rasters()
            .iter()
            .map(Raster::svg)
            .collect::<Result<_, _>>()?;
        // It is shown as large as the figure is, not as its canvas.
        let [on_canvas, shown] = [SCALE, 1]
            .map(|scale| format!("width=\"{}\" height=\"{}\"", scale * width, scale * height));
        Ok(text
            .replacen(&on_canvas, &shown, 1)
            .replace("</svg>", &format!("{pictures}</svg>")))
    }

    /// Draws all of it.
    ///
    /// # Errors
    /// What the backend reports.
    fn draw_all<B: DrawingBackend>(&self, canvas: &DrawingArea<B, Shift>) -> Drawn
    where
        B::ErrorType: 'static,
    {
        self.draw(canvas)?;
        for raster in self.rasters() {
            raster.draw(canvas)?;
        }
        Ok(())
    }
}

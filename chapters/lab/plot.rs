//! A plot that can be drawn as pixels and as an SVG file, and its numbers as a table.

use crate::kit::figure::{Figure, canvas, figure};
use crate::kit::stage::Drawn;
use crate::lab::raster::Raster;
use plotters::coord::Shift;
use plotters::prelude::{DrawingArea, DrawingBackend};
use raybook::image::Image;
use std::error::Error;

/// Something to be looked at, in whatever form.
pub trait Plot {
    /// Width and height in pixels; the canvas has twice as many.
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

    /// As a figure; what is made of pixels is vectors in its SVG, too.
    ///
    /// # Errors
    /// What plotters reports.
    fn figure(&self) -> Figure {
        let (width, height) = self.size();
        figure(width, height, |canvas| self.draw_all(canvas))
    }

    /// As pixels, at twice the resolution.
    ///
    /// # Errors
    /// What plotters reports.
    fn large_image(&self) -> Result<Image, Box<dyn Error>> {
        let (width, height) = self.size();
        Ok(canvas(width, height, |canvas| self.draw_all(canvas))?.pixels)
    }

    /// As the text of an SVG file, with pictures inside.
    ///
    /// # Errors
    /// What plotters reports, and if a picture has no pixels.
    fn svg(&self) -> Result<String, Box<dyn Error>> {
        let (width, height) = self.size();
        let lines = figure(width, height, |canvas| self.draw(canvas))?.svg;
        let rasters = self.rasters();
        let pictures: String = rasters.iter().map(Raster::svg).collect::<Result<_, _>>()?;
        Ok(lines.replace("</svg>", &format!("{pictures}</svg>")))
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

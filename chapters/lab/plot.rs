//! A plot that can be drawn as pixels and as an SVG file, and its numbers as a table.

use crate::kit::figure::{Canvas, Diagram, Figure, canvas, smoothed};
use crate::kit::stage::Drawn;
use crate::lab::raster::Raster;

/// A figure of the lab, in every form in which it is written.
pub trait Plot {
    /// Width and height in pixels; the canvas has twice as many.
    fn size(&self) -> (u32, u32);

    /// Draws the figure, except the parts that are made of pixels.
    ///
    /// # Errors
    /// What the backend reports.
    fn draw(&self, canvas: &Canvas) -> Drawn;

    /// The parts that are made of pixels; nothing is drawn over them.
    fn rasters(&self) -> Vec<Raster> {
        Vec::new()
    }

    /// Its numbers: a line of names, and a line for each point.
    fn csv(&self) -> String;

    /// As a figure.
    ///
    /// # Errors
    /// As for [`Plot::large`].
    fn figure(&self) -> Figure {
        let Diagram { pixels, svg } = self.large()?;
        let pixels = smoothed(&pixels);
        Ok(Diagram { pixels, svg })
    }

    /// As pixels, at twice the resolution, and as the text of an SVG file with pictures inside.
    ///
    /// # Errors
    /// What plotters reports, and if a picture has no pixels.
    fn large(&self) -> Figure {
        let (width, height) = self.size();
        let drawn = canvas(width, height, &mut |canvas| self.draw(canvas))?;
        let Diagram { mut pixels, svg } = drawn;
        let mut pictures = String::new();
        for raster in self.rasters() {
            raster.paste(&mut pixels);
            pictures += &raster.svg()?;
        }
        let svg = svg.replace("</svg>", &format!("{pictures}</svg>"));
        Ok(Diagram { pixels, svg })
    }
}

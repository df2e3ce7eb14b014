//! A picture inside of a figure.

use crate::kit::address;
use crate::kit::stage::Drawn;
use plotters::coord::Shift;
use plotters::prelude::{Color, DrawingArea, DrawingBackend, RGBColor, Rectangle};
use raybook::image::{Image, file, tone};
use std::io;

/// A picture, and where it is on the canvas.
#[derive(Clone, Debug)]
pub struct Raster {
    /// The picture; each of its pixels is a square.
    pub picture: Image,
    /// Its left and top, in pixels of the canvas.
    pub at: (i32, i32),
    /// Its width and height there.
    pub size: (i32, i32),
}

impl Raster {
    /// Draws it on a canvas of pixels.
    ///
    /// # Errors
    /// What the backend reports.
    pub fn draw<B: DrawingBackend>(&self, canvas: &DrawingArea<B, Shift>) -> Drawn
    where
        B::ErrorType: 'static,
    {
        let (width, height) = (self.picture.width() as i32, self.picture.height() as i32);
        let corner = |x: i32, y: i32| {
            let (across, down) = (x * self.size.0 / width, y * self.size.1 / height);
            (self.at.0 + across, self.at.1 + down)
        };
        let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        for ((x, y), code) in places.zip(tone::to_bytes(&self.picture).chunks_exact(3)) {
            let cell = [corner(x, y), corner(x + 1, y + 1)];
            let colour = RGBColor(code[0], code[1], code[2]);
            canvas.draw(&Rectangle::new(cell, colour.filled()))?;
        }
        Ok(())
    }

    /// As an element of an SVG file: the picture is inside, and each pixel keeps its sharp edges.
    ///
    /// # Errors
    /// If the picture has no pixels.
    pub fn svg(&self) -> io::Result<String> {
        let [(left, top), (width, height)] = [self.at, self.size];
        let data = address::of_bytes("image/png", &file::to_png(&self.picture)?);
        Ok(format!(
            "<image x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" preserveAspectRatio=\"none\" style=\"image-rendering:pixelated\" href=\"{data}\"/>\n"
        ))
    }
}

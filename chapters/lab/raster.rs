//! A picture inside of a figure.

use crate::kit::address;
use raybook::image::{Image, file};
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
    /// Copies the picture into the pixels of a canvas.
    ///
    /// # Panics
    /// If it reaches beyond the canvas.
    pub fn paste(&self, canvas: &mut Image) {
        let [at, size] = [self.at, self.size].map(|(x, y)| (x.max(0) as usize, y.max(0) as usize));
        let (width, height) = (self.picture.width(), self.picture.height());
        for y in 0..size.1 {
            for x in 0..size.0 {
                let colour = self.picture.at(x * width / size.0, y * height / size.1);
                canvas.set(at.0 + x, at.1 + y, colour);
            }
        }
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

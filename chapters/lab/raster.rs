//! A picture inside of a figure.

use crate::kit::stage::Drawn;
use plotters::coord::Shift;
use plotters::prelude::{Color, DrawingArea, DrawingBackend, RGBColor, Rectangle};
use raybook::image::Image;
use raybook::image::rgb::Rgb;
use raybook::image::tone;
use std::fmt::Write;

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

/// The codes of a colour, as a display takes them.
fn codes(colour: Rgb) -> [u8; 3] {
    let Rgb { r, g, b } = colour.map(tone::encode_srgb);
    [r, g, b].map(|code| (255.0 * code.clamp(0.0, 1.0)).round() as u8)
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
        for y in 0..height {
            for x in 0..width {
                let [r, g, b] = codes(self.picture.at(x as usize, y as usize));
                let cell = [corner(x, y), corner(x + 1, y + 1)];
                canvas.draw(&Rectangle::new(cell, RGBColor(r, g, b).filled()))?;
            }
        }
        Ok(())
    }

    /// As an element of an SVG file: the picture is inside, as a BMP file, which every browser reads, and each pixel keeps its sharp edges.
    pub fn svg(&self) -> String {
        let [(left, top), (width, height)] = [self.at, self.size];
        let data = base64(&bmp(&self.picture));
        format!(
            "<image x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" preserveAspectRatio=\"none\" style=\"image-rendering:pixelated\" href=\"data:image/bmp;base64,{data}\"/>\n"
        )
    }
}

/// A BMP file of a picture: 8 bits of grey a pixel where it is grey, and otherwise 24 bits; rows from the bottom, each filled up to four bytes.
fn bmp(picture: &Image) -> Vec<u8> {
    let grey = picture.pixels().iter().all(|p| p.r == p.g && p.g == p.b);
    let (channels, colours) = if grey { (1, 256) } else { (3, 0) };
    let (width, height) = (picture.width(), picture.height());
    let row = (channels * width).next_multiple_of(4);
    let start = 54 + 4 * colours;
    let mut bytes = b"BM".to_vec();
    let word = |n: usize| (n as u32).to_le_bytes();
    for n in [start + row * height, 0, start, 40, width, height] {
        bytes.extend(word(n));
    }
    bytes.extend([1, 0, 8 * channels as u8, 0]); // planes, bits a pixel
    for n in [0, row * height, 2835, 2835, colours, 0] {
        bytes.extend(word(n));
    }
    bytes.extend((0..colours).flat_map(|code| [code as u8, code as u8, code as u8, 0]));
    for y in (0..height).rev() {
        let from = bytes.len();
        for x in 0..width {
            let [r, g, b] = codes(picture.at(x, y));
            if grey {
                bytes.push(g);
            } else {
                bytes.extend([b, g, r]);
            }
        }
        bytes.resize(from + row, 0);
    }
    bytes
}

/// Bytes as text (RFC 4648).
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for three in bytes.chunks(3) {
        let byte = |i: usize| u32::from(three.get(i).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for digit in 0..4 {
            let _ = if digit <= three.len() {
                write!(
                    text,
                    "{}",
                    DIGITS[(bits >> (18 - 6 * digit)) as usize & 63] as char
                )
            } else {
                write!(text, "=")
            };
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{base64, bmp};
    use raybook::image::Image;
    use raybook::image::rgb::Rgb;

    #[test]
    fn bytes_become_the_text_of_the_standard() {
        for (bytes, text) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foobar", "Zm9vYmFy"),
        ] {
            assert_eq!(base64(bytes.as_bytes()), text, "{bytes}");
        }
    }

    #[test]
    fn a_bmp_file_says_how_long_it_is() {
        for colour in [Rgb::gray(0.5), Rgb::new(0.2, 0.4, 0.6)] {
            let file = bmp(&Image::from_fn(5, 3, |_, _| colour));
            let length = u32::from_le_bytes([file[2], file[3], file[4], file[5]]);
            assert_eq!(length as usize, file.len(), "{colour:?}");
        }
    }
}

//! Floor 1: pictures of linear radiance, their files, their way to a display, and their comparison.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let ramp = Image::from_fn(3, 1, |x, _| Rgb::gray(x as f32));
//! let brighter = ramp.map(|pixel| tone::expose(pixel, 1.0)); // one stop: twice the light
//! assert_eq!(brighter.at(2, 0), Rgb::gray(4.0));
//! ```

#[cfg(feature = "files")]
mod codec;
pub mod compare;
pub mod denoise;
#[cfg(feature = "files")]
pub mod file;
pub mod mip;
pub mod rgb;
pub mod rms;
pub mod spectrum;
pub mod tone;

use crate::image::rgb::Rgb;

/// A picture: `height` rows of `width` pixels, from the top left, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    width: usize,
    height: usize,
    pixels: Vec<Rgb>,
}

impl Image {
    /// The picture whose pixel in column x and row y is `pixel(x, y)`.
    pub fn from_fn(
        width: usize,
        height: usize,
        mut pixel: impl FnMut(usize, usize) -> Rgb,
    ) -> Self {
        let pixels = (0..width * height)
            .map(|i| pixel(i % width, i / width))
            .collect();
        Self {
            width,
            height,
            pixels,
        }
    }

    /// Columns.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// All pixels, row by row from the top left.
    pub fn pixels(&self) -> &[Rgb] {
        &self.pixels
    }

    /// The pixel in column x and row y.
    ///
    /// # Panics
    /// If x or y is outside the picture.
    #[track_caller]
    pub fn at(&self, x: usize, y: usize) -> Rgb {
        assert!(
            x < self.width && y < self.height,
            "no pixel ({x}, {y}) in {}×{}",
            self.width,
            self.height
        );
        self.pixels[y * self.width + x]
    }

    /// Replaces the pixel in column x and row y.
    ///
    /// # Panics
    /// If x or y is outside the picture.
    #[track_caller]
    pub fn set(&mut self, x: usize, y: usize, colour: Rgb) {
        assert!(
            x < self.width && y < self.height,
            "no pixel ({x}, {y}) in {}×{}",
            self.width,
            self.height
        );
        self.pixels[y * self.width + x] = colour;
    }

    /// The picture with f applied to each pixel; f may be an exposure or a tone curve.
    #[must_use]
    pub fn map(&self, f: impl Fn(Rgb) -> Rgb) -> Self {
        Self {
            pixels: self.pixels.iter().map(|&p| f(p)).collect(),
            ..*self
        }
    }

    /// The picture with each pixel as a square of `times` × `times` pixels: to show single pixels.
    #[must_use]
    pub fn enlarged(&self, times: usize) -> Self {
        Self::from_fn(self.width * times, self.height * times, |x, y| {
            self.at(x / times, y / times)
        })
    }

    /// The picture in another size: each pixel is the mean of the area that it covers; black if the picture has no pixel.
    ///
    /// ```
    /// use raybook::prelude::*;
    ///
    /// let ramp = Image::from_fn(3, 1, |x, _| Rgb::gray(3.0 * x as f32));
    /// let two = ramp.resized(2, 1); // each covers a pixel, and half of the one in the middle
    /// assert_eq!([two.at(0, 0), two.at(1, 0)].map(|pixel| pixel.g.round()), [1.0, 5.0]);
    /// ```
    #[must_use]
    pub fn resized(&self, width: usize, height: usize) -> Self {
        Self::from_fn(width, height, |x, y| {
            let mut sum = Rgb::BLACK;
            for (row, high) in covered(y, self.height, height) {
                for (column, wide) in covered(x, self.width, width) {
                    sum += self.at(column, row) * (wide * high);
                }
            }
            sum
        })
    }

    /// Whether the other picture has the same size and the same bits in every channel.
    ///
    /// This differs from `==` in two cases: here 0 and −0 are different, and a NaN equals a NaN with the same bits.
    pub fn same_bits(&self, other: &Self) -> bool {
        let bits = |picture: &Self| -> Vec<u32> {
            let channels = picture.pixels.iter().flat_map(|p| p.channels());
            channels.map(f32::to_bits).collect()
        };
        (self.width, self.height) == (other.width, other.height) && bits(self) == bits(other)
    }
}

/// A row of n pixels becomes one of m: the pixels that pixel i of the m covers, each with its share of pixel i.
fn covered(i: usize, n: usize, m: usize) -> impl Iterator<Item = (usize, f32)> {
    // In units of 1/m of a pixel, all numbers are whole.
    let (begin, end) = (i * n, (i + 1) * n);
    (begin / m..end.div_ceil(m)).map(move |pixel| {
        let part = end.min((pixel + 1) * m) - begin.max(pixel * m);
        (pixel, part as f32 / n as f32)
    })
}

/// The pixels at most `reach` columns and rows away from a pixel, in a picture of this size, row by row: those outside are left out.
pub(crate) fn around(
    pixel: [usize; 2],
    reach: usize,
    size: [usize; 2],
) -> impl Iterator<Item = [usize; 2]> {
    let along = |axis: usize| {
        let i: usize = pixel[axis];
        i.saturating_sub(reach)..(i + reach + 1).min(size[axis])
    };
    let (columns, rows) = (along(0), along(1));
    rows.flat_map(move |y| columns.clone().map(move |x| [x, y]))
}

//! A picture that can be looked up between its pixels, and blurred where many of them would fall into one pixel (a mip map).
//!
//! ```
//! use raybook::prelude::*;
//!
//! let stripes = Image::from_fn(4, 4, |x, _| Rgb::gray((x % 2) as f32));
//! let map = MipMap::new(&stripes);
//! assert_eq!(map.levels().len(), 3); // 4 × 4, 2 × 2 and 1 × 1 pixels
//! assert_eq!(map.at(vec2(0.3, 0.3), 1.0), Rgb::gray(0.5)); // as wide as the picture: the mean
//! ```

use crate::image::{Image, rgb::Rgb};
use glam::Vec2;

/// A mip map: a picture, the same picture at half its width and height, and so on down to one pixel (Williams, "Pyramidal
/// parametrics", 1983).
///
/// Places are texture coordinates: (0, 0) is the lower left corner of the picture, (1, 1) the upper right corner. Outside
/// [0, 1]² the picture is repeated.
#[derive(Clone, Debug, PartialEq)]
pub struct MipMap {
    levels: Vec<Image>,
}

impl MipMap {
    /// The mip map of a picture; a channel that is not finite counts as 0.
    ///
    /// # Panics
    /// If the picture has no pixel.
    #[track_caller]
    pub fn new(picture: &Image) -> Self {
        assert!(!picture.pixels().is_empty(), "a texture has pixels");
        let finite = |v: f32| if v.is_finite() { v } else { 0.0 };
        let mut levels = vec![picture.map(|pixel| pixel.map(finite))];
        while let Some(last) = levels.last().filter(|last| last.pixels().len() > 1) {
            let half = |n: usize| (n / 2).max(1);
            levels.push(last.resized(half(last.width()), half(last.height())));
        }
        Self { levels }
    }

    /// The levels, from the whole picture to a single pixel.
    pub fn levels(&self) -> &[Image] {
        &self.levels
    }

    // ANCHOR: bilinear
    /// Bilinear interpolation between the middles of the four pixels around a place: with x and y the place's distances from the
    /// left column and from the upper row, in pixels, the weights are (1 − x)(1 − y), x(1 − y), (1 − x)y and xy.
    ///
    /// A level beyond the last counts as the last.
    pub fn bilinear(&self, level: usize, place: Vec2) -> Rgb {
        let picture = &self.levels[level.min(self.levels.len() - 1)];
        let (width, height) = (picture.width(), picture.height());
        // The picture is repeated: the pixel before the first is the last.
        let between = |v: f32, n: usize| {
            let v = if v.is_finite() { v - v.floor() } else { 0.0 };
            let at = v * n as f32 + n as f32 - 0.5;
            let (first, rest) = (at as usize, at.fract());
            (first % n, (first + 1) % n, rest)
        };
        let (left, right, x) = between(place.x, width);
        let (top, bottom, y) = between(1.0 - place.y, height);
        let row = |row: usize| picture.at(left, row).lerp(picture.at(right, row), x);
        row(top).lerp(row(bottom), y)
    }
    // ANCHOR_END: bilinear

    // ANCHOR: mip_map
    /// The mean colour over a square around a place, `width` wide in texture coordinates (trilinear interpolation): the two
    /// levels whose pixels are just smaller and just larger than the square are interpolated. A width of 0 gives the sharp
    /// picture.
    pub fn at(&self, place: Vec2, width: f32) -> Rgb {
        let (first, last) = (&self.levels[0], self.levels.len() - 1);
        let pixels = width * first.width().max(first.height()) as f32;
        let level = pixels.max(1.0).log2().min(last as f32);
        let (sharp, rest) = (level as usize, level.fract());
        if rest == 0.0 {
            return self.bilinear(sharp, place);
        }
        let (sharp, soft) = (self.bilinear(sharp, place), self.bilinear(sharp + 1, place));
        sharp.lerp(soft, rest)
    }
    // ANCHOR_END: mip_map
}

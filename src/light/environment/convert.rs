//! Conversion between layouts of an environment's picture.
//!
//! ```
//! use raybook::light::environment::{convert, convert::LatLong, cube::Cross};
//! use raybook::prelude::*;
//!
//! let gray = Image::from_fn(8, 4, |_, _| Rgb::gray(0.5));
//! let cross = convert::convert(&gray, &LatLong, &Cross, 8, 6);
//! assert_eq!(cross.at(2, 2), Rgb::gray(0.5)); // on a face
//! assert_eq!(cross.at(0, 0), Rgb::BLACK); // beside the cross there is no direction
//! ```

use crate::image::{Image, rgb::Rgb};
use crate::light::environment::latlong;
use crate::math::dir3::Dir3;
use glam::{Vec2, vec2};

/// The layout of an environment's picture: a place for each direction. Places are in [0, 1]² from the top left.
pub trait Layout {
    /// The direction at a place; `None` where the picture shows nothing.
    fn direction(&self, place: Vec2) -> Option<Dir3>;

    /// The place of a direction.
    fn place(&self, direction: Dir3) -> Vec2;
}

/// The layout of [`latlong`].
#[derive(Clone, Copy, Debug)]
pub struct LatLong;

impl Layout for LatLong {
    fn direction(&self, place: Vec2) -> Option<Dir3> {
        Some(latlong::direction(place))
    }

    fn place(&self, direction: Dir3) -> Vec2 {
        latlong::place(direction)
    }
}

/// Number of points per texel that are averaged, along each axis.
const POINTS: usize = 4;

// ANCHOR: convert
/// The environment `map` in another layout, `width` × `height` texels large: each texel is the mean of 4 × 4 points, looked up in
/// `map`.
///
/// Texel (x, y) of w × h covers the places from (x/w, y/h) to ((x + 1)/w, (y + 1)/h), in both pictures, so nothing moves by
/// half a texel. A direction finds its texel on whichever face it is, so there is no seam. A texel without a direction is black.
///
/// # Panics
/// If `map` has no pixel and the result has some.
pub fn convert(
    map: &Image,
    from: &impl Layout,
    to: &impl Layout,
    width: usize,
    height: usize,
) -> Image {
    let texel = |x: f32, n: usize| ((x * n as f32) as usize).min(n - 1);
    let seen = |direction: Dir3| {
        let place = from.place(direction);
        map.at(texel(place.x, map.width()), texel(place.y, map.height()))
    };
    Image::from_fn(width, height, |x, y| {
        let points = (0..POINTS).flat_map(|j| (0..POINTS).map(move |i| vec2(i as f32, j as f32)));
        let places = points.map(|p| {
            let p = vec2(x as f32, y as f32) + (p + 0.5) / POINTS as f32;
            p / vec2(width as f32, height as f32)
        });
        let (mut sum, mut count) = (Rgb::BLACK, 0.0);
        for direction in places.filter_map(|place| to.direction(place)) {
            sum += seen(direction);
            count += 1.0;
        }
        if count > 0.0 { sum / count } else { sum }
    })
}
// ANCHOR_END: convert

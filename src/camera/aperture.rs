//! The aperture: the opening of the lens.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let blades = Aperture::Blades { count: 6, turn: 0.0 };
//! // Half-way between two corners, the edge is at √3/2 = 0.87 of the radius.
//! let edge = blades.point(vec2(1.0, 1.0 / 12.0)).length();
//! assert!((edge - 0.75_f32.sqrt()).abs() < 1e-5);
//! ```

use crate::sample::{disk::concentric_disk, polygon::regular_polygon};
use glam::Vec2;

/// The shape of the aperture, in units of its radius, which is f/2N. The corners of a polygon are on the unit circle, so its area
/// is smaller than that of the disc: six blades let through 17 % less light.
///
/// A point light that is out of focus has this shape in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Aperture {
    /// A disc.
    Round,
    /// A regular polygon, whose corners are on the unit circle.
    Blades {
        /// Number of blades, and of corners; fewer than 3 count as 3.
        count: u32,
        /// The angle of the first corner, in radians, from the camera's right towards its up.
        turn: f32,
    },
}

impl Aperture {
    /// The point of the aperture for u in [0, 1)², uniform over the area.
    pub fn point(&self, u: Vec2) -> Vec2 {
        match *self {
            Self::Round => concentric_disk(u),
            Self::Blades { count, turn } => regular_polygon(count, turn, u),
        }
    }
}

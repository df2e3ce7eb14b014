//! The aperture: the hole that the blades leave to the light.

use crate::sample::{disk::concentric_disk, polygon::regular_polygon};
use glam::Vec2;

/// The shape of the hole, in the unit circle, whose diameter is f/N. With blades the corners are on that circle, and the hole is
/// a little smaller: of six it lets through 17 % less light.
///
/// A point of light out of focus has this shape in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Aperture {
    /// A disc.
    Round,
    /// A regular polygon, whose corners are on the unit circle.
    Blades {
        /// How many blades, and so corners; at least 3.
        count: u32,
        /// The angle of the first corner, in radians, from the camera's right towards its up.
        turn: f32,
    },
}

impl Aperture {
    /// The point that belongs to u in [0, 1)², uniform by area.
    pub fn point(&self, u: Vec2) -> Vec2 {
        match *self {
            Self::Round => concentric_disk(u),
            Self::Blades { count, turn } => regular_polygon(count, turn, u),
        }
    }
}

//! Two materials in squares.
//!
//! ```
//! use raybook::material::{checkered::Checkered, texture::Texture};
//! use raybook::prelude::*;
//!
//! let [white, black] = [0.9, 0.1].map(|v| Lambert { albedo: Rgb::gray(v) });
//! let at = |u| Checkered(white, black).at(&Surface { texture: vec2(u, 0.5), ..Surface::flat(Vec3::ZERO, 0.0, Dir3::Y) });
//! assert_eq!([at(0.5), at(1.5), at(2.5)], [white, black, white]);
//! ```

use crate::material::{Material, texture::Texture};
use crate::math::whole::below;
use crate::shape::Surface;
use glam::Vec2;

/// A chess board of two materials, whose squares have the side 1 in texture coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Checkered<M>(pub M, pub M);

impl<M: Material + Copy> Texture for Checkered<M> {
    type Material = M;

    fn at(&self, surface: &Surface) -> M {
        if is_odd(surface.texture) {
            self.1
        } else {
            self.0
        }
    }
}

/// Whether a place of a chess board, whose squares have the side 1, is in a square of the second material.
pub fn is_odd(place: Vec2) -> bool {
    (below(place.x) ^ below(place.y)) & 1 != 0
}

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
use crate::shape::Surface;

/// A chess board of two materials, whose squares have the side 1 in texture coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Checkered<M>(pub M, pub M);

impl<M: Material + Copy> Texture for Checkered<M> {
    type Material = M;

    fn at(&self, surface: &Surface) -> M {
        let square = surface.texture.floor().as_ivec2();
        if (square.x ^ square.y) & 1 == 0 {
            self.0
        } else {
            self.1
        }
    }
}

//! Two materials in squares.

use crate::material::{Material, texture::Texture};
use crate::shape::Surface;

/// A chess board of two materials, whose squares have the side 1 in texture coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Checkered<M>(pub M, pub M);

impl<M: Material + Copy> Texture for Checkered<M> {
    type Material = M;

    fn at(&self, surface: &Surface) -> M {
        if surface.texture.floor().element_sum() % 2.0 == 0.0 {
            self.0
        } else {
            self.1
        }
    }
}

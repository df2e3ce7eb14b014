//! Two materials in squares.

use crate::image::rgb::Rgb;
use crate::light::LightSample;
use crate::material::{Material, See};
use crate::math::dir3::Dir3;
use crate::shape::Surface;

/// Squares of two materials, side 1 in texture coordinates, as on a chess board.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Checkered<M>(pub M, pub M);

impl<M> Checkered<M> {
    fn at(&self, surface: &Surface) -> &M {
        if surface.texture.floor().element_sum() % 2.0 == 0.0 {
            &self.0
        } else {
            &self.1
        }
    }
}

impl<M: Material> Material for Checkered<M> {
    fn lit(&self, at: &Surface, view: Dir3, light: &LightSample) -> Rgb {
        self.at(at).lit(at, view, light)
    }

    fn ambient(&self, at: &Surface) -> Rgb {
        self.at(at).ambient(at)
    }

    fn beyond(&self, at: &Surface, view: Dir3, see: &mut See) -> Rgb {
        self.at(at).beyond(at, view, see)
    }
}

//! A polished surface: a mirror over another material.

use crate::image::rgb::Rgb;
use crate::light::LightSample;
use crate::material::{Material, See, mirror::Mirror};
use crate::math::dir3::Dir3;
use crate::shape::Surface;

/// What the polish does not mirror goes through it, to the material below.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polished<M> {
    /// The polish.
    pub mirror: Mirror,
    /// What is below it.
    pub below: M,
}

impl<M> Polished<M> {
    /// The share of the light that the polish lets through.
    fn through(&self) -> Rgb {
        self.mirror.share.map(|share| 1.0 - share)
    }
}

impl<M: Material> Material for Polished<M> {
    fn lit(&self, at: &Surface, view: Dir3, light: &LightSample) -> Rgb {
        self.through() * self.below.lit(at, view, light)
    }

    fn ambient(&self, at: &Surface) -> Rgb {
        self.through() * self.below.ambient(at)
    }

    fn beyond(&self, at: &Surface, view: Dir3, see: &mut See) -> Rgb {
        let mirrored = self.mirror.beyond(at, view, see);
        mirrored + self.through() * self.below.beyond(at, view, see)
    }
}

//! A polished surface: a mirror over another material.
//!
//! ```
//! use raybook::material::polished::Polished;
//! use raybook::prelude::*;
//!
//! let at = Surface::flat(Vec3::ZERO, 0.0, Dir3::Y);
//! let wood = Lambert { albedo: Rgb::gray(0.5) };
//! let floor = Polished { mirror: Mirror { share: Rgb::gray(0.25) }, below: wood };
//! // A quarter is mirrored, so three quarters reach the wood.
//! assert_eq!(floor.eval(&at, Dir3::Y, Dir3::Y), wood.eval(&at, Dir3::Y, Dir3::Y) * 0.75);
//! ```

use crate::image::rgb::Rgb;
use crate::light::LightSample;
use crate::material::{Delta, Material, mirror::Mirror};
use crate::math::dir3::Dir3;
use crate::shape::Surface;
use glam::Vec2;

/// A mirror over another material: the light that is not mirrored goes through to the material below.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polished<M> {
    /// The mirror on top.
    pub mirror: Mirror,
    /// The material below the mirror.
    pub below: M,
}

impl<M> Polished<M> {
    /// The share of the light that goes through the mirror, per channel.
    fn through(&self) -> Rgb {
        self.mirror.share.map(|share| 1.0 - share)
    }
}

impl<M: Material> Material for Polished<M> {
    fn eval(&self, at: &Surface, view: Dir3, toward: Dir3) -> Rgb {
        self.through() * self.below.eval(at, view, toward)
    }

    fn sample(&self, at: &Surface, view: Dir3, u: Vec2) -> Option<Dir3> {
        self.below.sample(at, view, u)
    }

    fn pdf(&self, at: &Surface, view: Dir3, toward: Dir3) -> f32 {
        self.below.pdf(at, view, toward)
    }

    fn emitted(&self, at: &Surface, view: Dir3) -> Rgb {
        self.through() * self.below.emitted(at, view)
    }

    fn ambient(&self, at: &Surface) -> Rgb {
        self.through() * self.below.ambient(at)
    }

    fn delta_lobes(&self, at: &Surface, view: Dir3, visit: &mut dyn FnMut(Delta)) {
        self.mirror.delta_lobes(at, view, visit);
        self.below.delta_lobes(at, view, &mut |lobe| {
            let share = self.through() * lobe.share;
            visit(Delta { share, ..lobe });
        });
    }

    fn scatters(&self, at: &Surface) -> bool {
        self.below.scatters(at)
    }

    fn lit(&self, at: &Surface, view: Dir3, light: &LightSample) -> Rgb {
        self.through() * self.below.lit(at, view, light)
    }
}

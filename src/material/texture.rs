//! Surfaces that are not the same everywhere.
//!
//! ```
//! use raybook::material::texture::Texture;
//! use raybook::prelude::*;
//!
//! struct Snow; // the higher, the whiter
//! impl Texture for Snow {
//!     type Material = Lambert;
//!     fn at(&self, surface: &Surface) -> Lambert {
//!         Lambert { albedo: Rgb::gray(surface.position.y.clamp(0.0, 1.0)) }
//!     }
//! }
//! let [top, foot] = [1.0, 0.0].map(|y| Surface::flat(vec3(0.0, y, 0.0), 0.0, Dir3::Y));
//! let light = |at| Snow.eval(at, Dir3::Y, Dir3::Y).g; // a texture is a material
//! assert!(light(&top) > 0.3 && light(&foot) == 0.0);
//! ```

use crate::image::rgb::Rgb;
use crate::light::LightSample;
use crate::material::{Delta, Material, Scatter};
use crate::math::dir3::Dir3;
use crate::shape::Surface;
use glam::Vec2;

// ANCHOR: texture
/// A material for each place of a surface. A texture is itself a [`Material`]: it asks the material of the place.
pub trait Texture: Send + Sync {
    /// The type of the materials.
    type Material: Material;

    /// The material at a place, found by the texture coordinates or the position of the surface.
    fn at(&self, surface: &Surface) -> Self::Material;
}
// ANCHOR_END: texture

impl<T: Texture> Material for T {
    fn eval(&self, at: &Surface, view: Dir3, toward: Dir3) -> Rgb {
        self.at(at).eval(at, view, toward)
    }

    fn sample(&self, at: &Surface, view: Dir3, u: Vec2) -> Option<Dir3> {
        self.at(at).sample(at, view, u)
    }

    fn scatter(&self, at: &Surface, view: Dir3, u: Vec2) -> Option<Scatter> {
        self.at(at).scatter(at, view, u)
    }

    fn pdf(&self, at: &Surface, view: Dir3, toward: Dir3) -> f32 {
        self.at(at).pdf(at, view, toward)
    }

    fn emitted(&self, at: &Surface, view: Dir3) -> Rgb {
        self.at(at).emitted(at, view)
    }

    fn ambient(&self, at: &Surface) -> Rgb {
        self.at(at).ambient(at)
    }

    fn delta_lobes(&self, at: &Surface, view: Dir3, visit: &mut dyn FnMut(Delta)) {
        self.at(at).delta_lobes(at, view, visit);
    }

    fn scatters(&self, at: &Surface) -> bool {
        self.at(at).scatters(at)
    }

    fn lit(&self, at: &Surface, view: Dir3, light: &LightSample) -> Rgb {
        self.at(at).lit(at, view, light)
    }
}

//! A surface that emits light.
//!
//! ```
//! use raybook::material::glowing::Glowing;
//! use raybook::prelude::*;
//!
//! let screen = Glowing { radiance: Rgb::gray(5.0) };
//! assert_eq!(screen.emitted(&Surface::flat(Vec3::ZERO, 0.0, Dir3::Y), Dir3::Y), Rgb::gray(5.0));
//! ```

use crate::image::rgb::Rgb;
use crate::material::Material;
use crate::math::dir3::Dir3;
use crate::shape::Surface;

/// A surface that emits light to all sides, and reflects none.
///
/// A path finds it only by chance, so a small bright surface should be a [`Light`](crate::light::Light) instead.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glowing {
    /// L_e: the emitted radiance, in W·m⁻²·sr⁻¹.
    pub radiance: Rgb,
}

impl Material for Glowing {
    fn emitted(&self, _at: &Surface, _view: Dir3) -> Rgb {
        self.radiance
    }

    fn scatters(&self, _at: &Surface) -> bool {
        false
    }
}

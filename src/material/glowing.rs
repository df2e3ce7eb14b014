//! A surface that shines by itself.

use crate::image::rgb::Rgb;
use crate::material::Material;
use crate::math::dir3::Dir3;
use crate::shape::Surface;

/// A surface that sends out light by itself to all sides, and reflects none.
///
/// A path finds it only by chance; a small bright one is better made a [`Light`](crate::light::Light).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glowing {
    /// L_e, in W·m⁻²·sr⁻¹.
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

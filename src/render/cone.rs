//! How wide the beam is that a sample of a pixel sees: what a texture's colour is averaged over.

use crate::camera::Camera;
use crate::math::dir3::Dir3;
use crate::render::film::Film;
use crate::shape::Surface;
use glam::{Vec2, vec2};

/// A cone around a ray (Akenine-Möller et al., "Texture level of detail strategies for real-time ray tracing", 2019).
///
/// It goes on in a mirror and through glass as the ray does, as if all surfaces were flat: in a mirror ball that shows more
/// of a texture in a pixel, the texture is sharper than it need be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    /// How wide it is where the ray starts, in metres.
    pub width: f32,
    /// How much wider it is after each metre, in metres: an angle in radians.
    pub spread: f32,
}

impl Cone {
    /// A ray without width, which sees a single place of a texture.
    pub const THIN: Self = Self {
        width: 0.0,
        spread: 0.0,
    };

    /// The cone of a pixel's sample in the middle of a film: the pixel's angle over √N for N samples, as the others see the rest
    /// of the pixel; at least an eighth of the pixel's.
    pub fn of_sample(camera: &dyn Camera, film: &Film) -> Self {
        let toward = |pixels: Vec2| {
            let place = 0.5 + pixels / vec2(film.width as f32, film.height as f32);
            *camera.ray(place, Vec2::splat(0.5)).direction
        };
        let angle = |pixels: Vec2| toward(-0.5 * pixels).distance(toward(0.5 * pixels));
        let pixel = (angle(Vec2::X) * angle(Vec2::Y)).sqrt();
        Self {
            width: 0.0,
            spread: pixel * (film.samples as f32).sqrt().recip().max(0.125),
        }
    }

    /// The cone after t more metres.
    #[must_use]
    pub fn after(self, t: f32) -> Self {
        Self {
            width: self.width + self.spread * t,
            ..self
        }
    }

    // ANCHOR: cone_on
    /// Tells a surface the width w/|n·v| that the cone covers there, in texture coordinates: more at a grazing view.
    pub fn cover(self, at: &mut Surface, view: Dir3) {
        let covered = self.width / at.normal.dot(*view).abs();
        at.texture_width = covered * at.texture_per_metre;
    }
    // ANCHOR_END: cone_on
}

//! The width of the beam that a sample of a pixel sees, over which a texture's colour is averaged.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::render::cone::Cone;
//!
//! let cone = Cone { width: 0.0, spread: 0.001 }.after(20.0);
//! assert!((cone.width - 0.02).abs() < 1e-6); // 1 mm more for every metre
//! let mut floor = Surface { texture_per_metre: 1.0, ..Surface::flat(Vec3::ZERO, 0.0, Dir3::Y) };
//! cone.cover(&mut floor, Dir3::new_or(vec3(0.866_025_4, 0.5, 0.0), Dir3::Y));
//! assert!((floor.texture_width - 0.04).abs() < 1e-6); // at 60° to the normal, it covers twice as much
//! ```

use crate::camera::Camera;
use crate::math::{dir3::Dir3, ray::Ray};
use crate::render::film::Film;
use crate::shape::Surface;
use glam::{Vec2, vec2};

/// A cone around a ray (Akenine-Möller et al., "Texture level of detail strategies for real-time ray tracing", 2019).
///
/// The cone follows the ray by mirrors and through glass as if all surfaces were flat. A mirror ball shows more of a texture in a
/// pixel than the cone covers, so the texture there is not averaged enough.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    /// The width where the ray starts, in metres.
    pub width: f32,
    /// The growth of the width per metre: an angle in radians.
    pub spread: f32,
}

impl Cone {
    /// A cone without width, which sees a single point of a texture.
    pub const THIN: Self = Self {
        width: 0.0,
        spread: 0.0,
    };

    /// The cone of one of N samples of a pixel in the film's middle: its width and its angle are those of the pixel over √N, because
    /// the other samples see the rest of the pixel; at least an eighth of the pixel's. Where rays start at one point, the width
    /// is 0; where they are parallel, the angle.
    pub fn of_sample(camera: &dyn Camera, film: &Film) -> Self {
        let ray = |pixels: Vec2| {
            let place = 0.5 + pixels / vec2(film.width as f32, film.height as f32);
            camera.central_ray(place)
        };
        let [across, down] = [Vec2::X, Vec2::Y].map(|by| [ray(-0.5 * by), ray(0.5 * by)]);
        let part = (film.samples as f32).sqrt().recip().max(0.125);
        let of_sample = |apart: fn([Ray; 2]) -> f32| part * (apart(across) * apart(down)).sqrt();
        Self {
            width: of_sample(|[a, b]| a.origin.distance(b.origin)),
            spread: of_sample(|[a, b]| a.direction.distance(*b.direction)),
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
    /// Sets the surface's `texture_width` to the width that the cone covers there, w/|n·v| in metres, converted to texture
    /// coordinates. It is larger at a grazing view.
    pub fn cover(self, at: &mut Surface, view: Dir3) {
        let covered = self.width / at.normal.dot(*view).abs();
        at.texture_width = covered * at.texture_per_metre;
    }
    // ANCHOR_END: cone_on
}

//! Floor 5: cameras, which turn a place on the film into a ray.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let camera = Pinhole::look_at(Vec3::ZERO, -Vec3::Z, Vec3::Y, focal_length(90.0), 1.0)?;
//! assert_eq!(camera.central_ray(vec2(0.5, 0.5)).direction, -Dir3::Z); // the middle of the picture
//! // The upper edge of a view of 90° is 45° above the middle.
//! let top = camera.central_ray(vec2(0.5, 0.0)).direction;
//! assert!((top.y + top.z).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod aperture;
pub mod fisheye;
pub mod lens;
pub mod panorama;
pub mod pinhole;
pub mod pose;
pub mod thin_lens;

use crate::math::ray::Ray;
use glam::Vec2;

/// A camera: a ray for each place on the film.
pub trait Camera: Send + Sync {
    /// The ray along which a place on the film sees the scene.
    ///
    /// `film` is in [0, 1]², from the picture's top left to its bottom right. `lens`, in [0, 1)², chooses a point of the lens, if
    /// the camera has a lens.
    fn ray(&self, film: Vec2, lens: Vec2) -> Ray;

    /// The ray through the middle of the lens; without a lens, the only ray of a place on the film. `film` as for [`Camera::ray`].
    ///
    /// It is that of `lens` = (½, ½), unless the camera has its own.
    fn central_ray(&self, film: Vec2) -> Ray {
        self.ray(film, Vec2::splat(0.5))
    }

    /// Whether light falls on a place of the film. Elsewhere the film stays black, and [`Camera::ray`] has no meaning.
    fn sees(&self, _film: Vec2) -> bool {
        true
    }

    /// Whether the ray depends on `lens`.
    fn has_lens(&self) -> bool {
        false
    }
}

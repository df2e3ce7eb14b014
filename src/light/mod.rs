//! Floor 4: where light comes from.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let lamp = PointLight { position: Vec3::Y, intensity: Rgb::gray(12.0) };
//! let sample = lamp.sample(-Vec3::Y, Vec2::ZERO).expect("shines everywhere");
//! assert_eq!((sample.toward, sample.distance), (Dir3::Y, 2.0));
//! assert_eq!(sample.arriving, Rgb::gray(3.0)); // I/r²
//! ```

pub mod black_body;
pub mod directional;
pub mod environment;
pub mod extent;
pub mod point;
pub mod rect_light;
pub mod sphere_light;

use crate::image::rgb::Rgb;
use crate::math::{dir3::Dir3, ray::Ray};
use glam::{Vec2, Vec3};

// ANCHOR: light
/// A light source.
pub trait Light: Send + Sync {
    /// A sample of the light that would arrive at the point `at` if nothing were in the way; `None` if no light would.
    ///
    /// u, uniform in [0, 1)², chooses a point of an area light. The average of f cos θ · `arriving` over u is the reflected
    /// radiance without shadows.
    fn sample(&self, at: Vec3, u: Vec2) -> Option<LightSample>;

    /// Whether a point of the light is chosen, by the random numbers of [`Light::sample`]; a light without an extent takes none.
    fn has_extent(&self) -> bool {
        true
    }

    /// What a ray that meets the light itself finds, at a distance of at most `farthest`, in metres; `None` for a light without
    /// an extent.
    fn seen(&self, _ray: &Ray, _farthest: f32) -> Option<LightHit> {
        None
    }

    /// A photon that leaves the light: `place`, uniform in [0, 1)², chooses where, and `direction`, likewise, in which direction.
    ///
    /// The average of its `power` is the light's flux. `None` for a light that sends out no photons, such as a light at infinity: its
    /// flux is as large as the scene is wide, which with a plane is without end.
    fn emit(&self, _place: Vec2, _direction: Vec2) -> Option<Emitted> {
        None
    }

    /// The density per steradian with which [`Light::sample`] chooses a direction; 0 for a light without an extent.
    fn pdf(&self, at: Vec3, toward: Dir3) -> f32 {
        let hit = self.seen(&Ray::new(at, toward), f32::INFINITY);
        hit.map_or(0.0, |hit| hit.pdf)
    }
}
// ANCHOR_END: light

/// Light on its way to a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSample {
    /// The direction from the point to the light.
    pub toward: Dir3,
    /// The distance to the light, in metres; ∞ for a light at infinity.
    pub distance: f32,
    /// The irradiance of a surface that faces the light, in W/m²; for an area light, its estimate, radiance over `pdf`.
    pub arriving: Rgb,
    /// The density of this direction, per steradian; ∞ for a light without an extent, whose direction is not chosen.
    pub pdf: f32,
}

/// The hit of a ray on a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightHit {
    /// Distance along the ray, in metres; ∞ for a light at infinity.
    pub t: f32,
    /// The radiance that comes along the ray, in W·m⁻²·sr⁻¹.
    pub radiance: Rgb,
    /// The density per steradian with which [`Light::sample`], at the ray's origin, chooses the ray's direction.
    pub pdf: f32,
}

/// A photon that leaves a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Emitted {
    /// The ray from a point of the light.
    pub ray: Ray,
    /// The estimate of the light's flux, in W: L cos θ/(p_A p_ω), where the point was chosen with the density p_A per m², and the
    /// direction, at the angle θ to the normal, with the density p_ω per steradian. I/p_ω for a light without an extent.
    pub power: Rgb,
}

impl LightSample {
    /// Light of 1 W/m² from a direction, from infinitely far away.
    pub fn unit(toward: Dir3) -> Self {
        Self {
            toward,
            distance: f32::INFINITY,
            arriving: Rgb::WHITE,
            pdf: f32::INFINITY,
        }
    }
}

//! Floor 4: where light comes from.

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
/// Something that shines.
pub trait Light: Send + Sync {
    /// Light that would arrive at a point if nothing were in the way; `None` where none would.
    ///
    /// u, uniform in [0, 1)², chooses a place on a light that has an extent; the mean over u is the light that arrives.
    fn sample(&self, at: Vec3, u: Vec2) -> Option<LightSample>;

    /// What a ray that meets the light itself finds at a distance of at most `farthest`, in metres; `None` for a light without extent.
    fn seen(&self, _ray: &Ray, _farthest: f32) -> Option<LightHit> {
        None
    }

    /// The density per steradian with which [`Light::sample`] chooses a direction; 0 for a light without extent.
    fn pdf(&self, at: Vec3, toward: Dir3) -> f32 {
        let hit = self.seen(&Ray::new(at, toward), f32::INFINITY);
        hit.map_or(0.0, |hit| hit.pdf)
    }
}
// ANCHOR_END: light

/// Light on its way to a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSample {
    /// From the point to where the light comes from.
    pub toward: Dir3,
    /// How far that is, in metres; ∞ for a light that is not of this world.
    pub distance: f32,
    /// What arrives on a surface that faces the light, in W/m²; for a light with an extent, its radiance over `pdf`.
    pub arriving: Rgb,
    /// The density of this direction, per steradian; ∞ for a light without extent, whose direction is no choice.
    pub pdf: f32,
}

/// A light, where a ray meets it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightHit {
    /// Distance along the ray, in metres; ∞ for a light that is not of this world.
    pub t: f32,
    /// The radiance that comes along the ray, in W·m⁻²·sr⁻¹.
    pub radiance: Rgb,
    /// The density per steradian with which [`Light::sample`] chooses the ray's direction, seen from where the ray begins.
    pub pdf: f32,
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

//! The fisheye: a view of up to 360°, drawn as a disc.
//!
//! ```
//! use raybook::camera::fisheye::{Fisheye, Projection};
//! use raybook::camera::pose::Pose;
//! use raybook::prelude::*;
//!
//! let eye = Fisheye::new(Pose::level(Vec3::ZERO), Projection::Equidistant, 180.0, 1.0)?;
//! let rim = eye.central_ray(vec2(1.0, 0.5)).direction;
//! assert!((rim.x - 1.0).abs() < 1e-5); // 90° to the right
//! assert!(!eye.sees(vec2(0.01, 0.01))); // beside the disc
//! # Ok::<(), raybook::camera::fisheye::ViewError>(())
//! ```

use crate::camera::{Camera, pose::Pose};
use crate::math::{dir3::Dir3, ray::Ray};
use glam::{Vec2, vec2};
use std::f32::consts::TAU;

/// The function ρ(α) of a fisheye: the distance from the middle of the disc, in focal lengths, at which a direction is drawn that
/// makes the angle α with the optical axis.
///
/// (The four are compared in Kannala and Brandt, "A generic camera model and calibration method for conventional,
/// wide-angle, and fish-eye lenses", 2006.)
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Projection {
    /// ρ = α: equal angles are equal distances along a radius.
    Equidistant,
    /// ρ = 2 sin(α/2): equal solid angles have equal areas, as in a mirror ball seen from far away.
    Equisolid,
    /// ρ = 2 tan(α/2): angles are kept, so small things keep their shapes.
    Stereographic,
    /// ρ = sin α: at most a hemisphere, as a globe looks from far away; areas are solid angle times cosine.
    Orthographic,
}

impl Projection {
    /// All four projections.
    pub const ALL: [Self; 4] = [
        Self::Equidistant,
        Self::Equisolid,
        Self::Stereographic,
        Self::Orthographic,
    ];

    // ANCHOR: fisheye_radius
    /// ρ, in focal lengths, of an angle α in radians.
    pub fn radius(self, alpha: f32) -> f32 {
        match self {
            Self::Equidistant => alpha,
            Self::Equisolid => 2.0 * (0.5 * alpha).sin(),
            Self::Stereographic => 2.0 * (0.5 * alpha).tan(),
            Self::Orthographic => alpha.sin(),
        }
    }

    /// α, in radians, of a radius ρ in focal lengths: the inverse of [`Projection::radius`].
    pub fn angle(self, rho: f32) -> f32 {
        match self {
            Self::Equidistant => rho,
            Self::Equisolid => 2.0 * (0.5 * rho).min(1.0).asin(),
            Self::Stereographic => 2.0 * (0.5 * rho).atan(),
            Self::Orthographic => rho.min(1.0).asin(),
        }
    }
    // ANCHOR_END: fisheye_radius

    /// The widest view, in degrees. A stereographic picture of 360° would be infinitely large; at 350° the middle of the view is
    /// already small.
    pub fn widest(self) -> f32 {
        match self {
            Self::Equidistant | Self::Equisolid => 360.0,
            Self::Stereographic => 350.0,
            Self::Orthographic => 180.0,
        }
    }
}

/// A camera whose view is a cone, drawn as a disc that touches the nearer edges of the film. Beside the disc the film stays black.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fisheye {
    pose: Pose,
    projection: Projection,
    /// ρ at the rim of the disc: the disc's radius in focal lengths.
    rim: f32,
    aspect: f32,
}

/// A view that a projection cannot show.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error(
    "this fisheye's view, {view}°, must be more than 0° and at most {}°: its projection is {projection:?}",
    projection.widest()
)]
pub struct ViewError {
    /// The view that was asked for, in degrees.
    pub view: f32,
    /// The projection.
    pub projection: Projection,
}

impl Fisheye {
    /// A fisheye that sees a cone whose full angle is `view`, in degrees; `aspect` is the film's width over its height.
    ///
    /// # Errors
    /// If `view` is not above 0°, or is above the projection's [widest](Projection::widest).
    pub fn new(
        pose: Pose,
        projection: Projection,
        view: f32,
        aspect: f32,
    ) -> Result<Self, ViewError> {
        if !(view > 0.0 && view <= projection.widest()) {
            return Err(ViewError { view, projection });
        }
        let rim = projection.radius(view / 720.0 * TAU);
        Ok(Self {
            pose,
            projection,
            rim,
            aspect,
        })
    }

    // ANCHOR: fisheye_direction
    /// The direction that a place on the film shows, in the camera's coordinates; `film` as for [`Camera::ray`]. `None` beside the
    /// disc.
    ///
    /// q is the distance of the place from the film's middle, 1 at the rim; α is the angle of the radius q·ρ(view/2). The
    /// direction is forward, turned by α towards the side on which the place is.
    pub fn direction(&self, film: Vec2) -> Option<Dir3> {
        let stretch = vec2(self.aspect.max(1.0), (1.0 / self.aspect).max(1.0));
        let p = vec2(2.0 * film.x - 1.0, 1.0 - 2.0 * film.y) * stretch;
        let q = p.length();
        if q > 1.0 {
            return None;
        }
        let (sin, cos) = self.projection.angle(q * self.rim).sin_cos();
        let across = sin * p.normalize_or_zero();
        Some(Dir3::new_or(across.extend(-cos), -Dir3::Z))
    }
    // ANCHOR_END: fisheye_direction
}

impl Camera for Fisheye {
    fn ray(&self, film: Vec2, _lens: Vec2) -> Ray {
        self.pose.ray(self.direction(film).unwrap_or(-Dir3::Z))
    }

    fn sees(&self, film: Vec2) -> bool {
        self.direction(film).is_some()
    }
}

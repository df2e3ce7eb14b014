//! Curved light rays around a black hole that does not rotate (Schwarzschild 1916).
//!
//! The hole is at the origin. The unit of length is the radius of the hole, r_s = 2GM/c² = 1, and times are lengths too: c = 1.
//!
//! ```
//! use glam::dvec3;
//! use raybook::render::curved::{CRITICAL, Photon};
//!
//! // Far away, the impact parameter is the distance at which the straight ray would pass.
//! let photon = Photon { x: dvec3(-1e6, 3.0, 0.0), v: dvec3(1.0, 0.0, 0.0) };
//! assert!((photon.impact_parameter() - 3.0).abs() < 1e-6 && photon.impact_parameter() > CRITICAL); // it escapes
//! ```

pub mod black_hole;
pub mod deflection;
pub mod doppler;
pub mod fan;
pub mod follow;
pub mod geodesic;
pub mod observer;

use glam::DVec3;
use std::ops::{Add, Mul};

/// The radius of the horizon: nothing comes back from inside.
pub const HORIZON: f64 = 1.0;

/// The radius of the photon sphere, on which light can circle, but not stably.
pub const PHOTON_SPHERE: f64 = 1.5;

/// b_c = 3√3/2: the critical impact parameter. Light from far away with a smaller impact parameter falls in.
pub const CRITICAL: f64 = 2.598_076_211_353_316;

/// A point of a light ray, and the ray's velocity there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Photon {
    /// The point, in radii of the hole.
    pub x: DVec3,
    /// dx/dλ. The scale of the parameter λ is arbitrary: with twice the velocity, the ray is the same.
    pub v: DVec3,
}

impl Photon {
    /// h = |x × v|, which does not change along the ray: the ray stays in one plane.
    pub fn angular_momentum(&self) -> f64 {
        self.x.cross(self.v).length()
    }

    /// E = √(|v|² − h²/r³): the energy, which does not change along the ray either.
    pub fn energy(&self) -> f64 {
        let h = self.angular_momentum();
        let r = self.x.length();
        (self.v.length_squared() - h * h / (r * r * r)).sqrt()
    }

    /// b = h/E: the impact parameter, the distance from the hole's middle at which a straight ray would pass, in radii of the
    /// hole.
    pub fn impact_parameter(&self) -> f64 {
        self.angular_momentum() / self.energy()
    }
}

/// Photons are added and scaled as vectors of six numbers: a step along a ray is made of such sums.
impl Add for Photon {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            x: self.x + other.x,
            v: self.v + other.v,
        }
    }
}

impl Mul<f64> for Photon {
    type Output = Self;

    fn mul(self, scale: f64) -> Self {
        Self {
            x: scale * self.x,
            v: scale * self.v,
        }
    }
}

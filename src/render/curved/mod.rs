//! Light around a black hole that does not turn (Schwarzschild 1916): its rays are curved.
//!
//! The hole is at the origin. Lengths are in its radii, r_s = 2GM/c² = 1, and times are lengths too: c = 1.

pub mod black_hole;
pub mod deflection;
pub mod doppler;
pub mod fan;
pub mod follow;
pub mod geodesic;
pub mod observer;

use glam::DVec3;
use std::ops::{Add, Mul};

/// Nothing comes back from behind this radius.
pub const HORIZON: f64 = 1.0;

/// At this radius light can circle, if nothing disturbs it.
pub const PHOTON_SPHERE: f64 = 1.5;

/// b_c = 3√3/2: light that aims nearer to the middle falls in.
pub const CRITICAL: f64 = 2.598_076_211_353_316;

/// A place on a light ray, and how the ray goes on there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Photon {
    /// Where it is.
    pub x: DVec3,
    /// dx/dλ. How fast the parameter λ runs is arbitrary: twice the velocity is the same ray.
    pub v: DVec3,
}

impl Photon {
    /// h = |x × v|, which does not change along the ray: the ray stays in one plane.
    pub fn angular_momentum(&self) -> f64 {
        self.x.cross(self.v).length()
    }

    /// E, with E² = |v|² − h²/r³, which does not change along the ray either.
    pub fn energy(&self) -> f64 {
        let h = self.angular_momentum();
        let r = self.x.length();
        (self.v.length_squared() - h * h / (r * r * r)).sqrt()
    }

    /// b = h/E: how far from the hole's middle the ray would have passed if it were straight.
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

//! The view of an observer at rest above the hole.
//!
//! ```
//! use raybook::render::curved::{PHOTON_SPHERE, observer::shadow_half_angle};
//! use std::f64::consts::FRAC_PI_2;
//!
//! assert!((shadow_half_angle(PHOTON_SPHERE) - FRAC_PI_2).abs() < 1e-6); // half of the sky is black
//! assert!((shadow_half_angle(1000.0) - 0.0026).abs() < 1e-5); // from far away, b_c/r
//! ```

use crate::render::curved::{CRITICAL, PHOTON_SPHERE, Photon};
use glam::DVec3;

/// The ray that an observer at rest at `at`, outside the horizon, sees in the direction `toward` (of length 1), followed
/// backwards from the eye.
///
/// A length along the radius is larger than the difference of the radii at its ends, by the factor 1/√(1 − 1/r). So in
/// coordinates, the radial part of the direction is multiplied by √(1 − 1/r).
pub fn seen(at: DVec3, toward: DVec3) -> Photon {
    let up = at.normalize();
    let radial = toward.dot(up);
    let shorter = (1.0 - 1.0 / at.length()).max(0.0).sqrt();
    Photon {
        x: at,
        v: toward + (shorter - 1.0) * radial * up,
    }
}

/// The angle α, in radians, between the middle and the edge of the hole's shadow, for an observer at rest at the radius r > 1:
/// sin α = b_c √(1 − 1/r)/r (Synge 1966).
///
/// On the photon sphere half of the sky is black, and nearer to the hole more than half.
pub fn shadow_half_angle(r: f64) -> f64 {
    let sine = (CRITICAL * (1.0 - 1.0 / r).sqrt() / r).min(1.0);
    if r < PHOTON_SPHERE {
        std::f64::consts::PI - sine.asin()
    } else {
        sine.asin()
    }
}

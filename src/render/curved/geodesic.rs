//! One step along a curved light ray.
//!
//! ```
//! use glam::dvec3;
//! use raybook::render::curved::{Photon, geodesic::geodesic_step};
//!
//! let photon = Photon { x: dvec3(0.0, 1.5, 0.0), v: dvec3(1.0, 0.0, 0.0) };
//! let (next, error) = geodesic_step(photon, 0.01);
//! assert!((next.x.length() - 1.5).abs() < 1e-6); // on the photon sphere, light circles
//! assert!(error < 1e-4);
//! ```

use crate::render::curved::Photon;
use glam::DVec3;

// ANCHOR: geodesic_step
/// The photon after a step dλ, and an estimate of its relative error: the larger of |Δx|/|x| and |Δv|/|v|.
///
/// Around a black hole, light moves as if a force pulled it: dx/dλ = v, dv/dλ = −(3/2) h² x/|x|⁵, with h² = |x × v|². A ray that
/// aims at the middle has h = 0 and goes straight on.
///
/// Four slopes give two results, one of third order and one of second order (Bogacki and Shampine 1989). The step uses the
/// third-order result. The difference of the two, Δx and Δv, estimates the error of the second-order result.
pub fn geodesic_step(photon: Photon, step: f64) -> (Photon, f64) {
    let slope = |p: Photon| {
        let h_squared = p.x.cross(p.v).length_squared();
        let r_squared = p.x.length_squared();
        let pull = -1.5 * h_squared / (r_squared * r_squared * r_squared.sqrt());
        Photon {
            x: p.v,
            v: pull * p.x,
        }
    };
    let k1 = slope(photon);
    let k2 = slope(photon + k1 * (step / 2.0));
    let k3 = slope(photon + k2 * (3.0 / 4.0 * step));
    let third = photon + (k1 * 2.0 + k2 * 3.0 + k3 * 4.0) * (step / 9.0);
    let k4 = slope(third);
    let second = photon + (k1 * 7.0 + k2 * 6.0 + k3 * 8.0 + k4 * 3.0) * (step / 24.0);
    let error = third + second * -1.0;
    let relative = |error: DVec3, whole: DVec3| error.length() / whole.length();
    (
        third,
        relative(error.x, photon.x).max(relative(error.v, photon.v)),
    )
}
// ANCHOR_END: geodesic_step

/// The point of the ray at the fraction s of a step between two photons: the cubic with the places and velocities of both photons
/// (Hermite interpolation).
pub fn between(from: &Photon, to: &Photon, step: f64, s: f64) -> DVec3 {
    let (s2, s3) = (s * s, s * s * s);
    (2.0 * s3 - 3.0 * s2 + 1.0) * from.x
        + (s3 - 2.0 * s2 + s) * step * from.v
        + (3.0 * s2 - 2.0 * s3) * to.x
        + (s3 - s2) * step * to.v
}

//! What area lights have in common.
//!
//! ```
//! use raybook::light::extent::per_steradian;
//! use raybook::prelude::*;
//!
//! // A lamp of 1 m², seen from straight below at 3 m: p_A r² = 1 · 9.
//! assert_eq!(per_steradian(1.0, vec3(0.0, 3.0, 0.0), -Dir3::Y), 9.0);
//! assert_eq!(per_steradian(1.0, vec3(0.0, 3.0, 0.0), Dir3::Y), 0.0); // its back
//! ```

use crate::image::rgb::Rgb;
use crate::light::{Emitted, LightSample};
use crate::math::dir3::Dir3;
use crate::sample::hemisphere::cosine_hemisphere;
use crate::shape::{ROUNDING, Surface};
use glam::{Vec2, Vec3};
use std::f32::consts::PI;

/// How an area light chooses one of its points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LightSampling {
    /// Uniformly over the area. [`LightSample::arriving`] then varies with cos θ/r² from point to point.
    ByArea,
    /// Uniformly over the solid angle as seen from the surface. [`LightSample::arriving`] is then the same for all points.
    BySolidAngle,
}

// ANCHOR: per_steradian
/// The density per steradian of a point on a light that is chosen with the density p_A per m²: p_ω = p_A r²/cos θ.
///
/// `r` is the vector to the point, in metres, and θ the angle at the point between −r and the normal: an area dA of the light
/// has the solid angle dω = cos θ dA/r². 0 where the light's back is seen, cos θ ≤ 0.
pub fn per_steradian(per_area: f32, r: Vec3, normal: Dir3) -> f32 {
    let cosine = -r.dot(*normal) / r.length();
    if cosine > 0.0 {
        per_area * r.length_squared() / cosine
    } else {
        0.0
    }
}
// ANCHOR_END: per_steradian

/// The sample of light of this radiance from a direction that was chosen with the density `pdf`, per steradian; `None` if `pdf`
/// is 0 or not finite.
pub fn shine(toward: Dir3, distance: f32, radiance: Rgb, pdf: f32) -> Option<LightSample> {
    let usable = pdf > 0.0 && pdf.is_finite();
    usable.then(|| LightSample {
        toward,
        distance,
        arriving: radiance / pdf,
        pdf,
    })
}

// ANCHOR: emit
/// A photon from a point of a light that shines with the `radiance` L to the side of the `normal`: u, uniform in [0, 1)², chooses its
/// direction. The point was chosen uniformly over the `area` A, in m².
///
/// The densities are p_A = 1/A and p_ω = cos θ/π ([`cosine_hemisphere`]), so L cos θ/(p_A p_ω) = π A L: each photon has the flux of
/// the whole light (Jensen, "Global illumination using photon maps", 1996).
pub fn emit(position: Vec3, normal: Dir3, area: f32, radiance: Rgb, u: Vec2) -> Emitted {
    // A lamp in a ceiling must not shine into the ceiling: the ray starts in front of the lamp.
    let error = ROUNDING * position.abs().max_element();
    let at = Surface::flat(position, error, normal);
    Emitted {
        ray: at.leave(cosine_hemisphere(normal, u)),
        power: radiance * (PI * area),
    }
}
// ANCHOR_END: emit

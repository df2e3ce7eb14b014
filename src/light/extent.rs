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
use crate::light::LightSample;
use crate::math::dir3::Dir3;
use glam::Vec3;

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

//! What lights with an extent have in common.

use crate::image::rgb::Rgb;
use crate::light::LightSample;
use crate::math::dir3::Dir3;
use glam::Vec3;

/// How a light with an extent chooses one of its points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choose {
    /// Every part of its surface is as likely as its area. What arrives then varies with cos θ/r² from point to point.
    ByArea,
    /// Every part is as likely as the solid angle under which it is seen. What arrives is then the same from all points.
    BySolidAngle,
}

// ANCHOR: per_steradian
/// The density per steradian of a point that is chosen with a density per area: p_ω = p_A r²/cos θ.
///
/// r is the vector to the point, and θ the angle there between −r and the normal: a piece dA of the light fills
/// dω = cos θ dA/r² of the view. 0 where the light turns its back.
pub fn per_steradian(per_area: f32, r: Vec3, normal: Dir3) -> f32 {
    let cosine = -r.dot(*normal) / r.length();
    if cosine > 0.0 {
        per_area * r.length_squared() / cosine
    } else {
        0.0
    }
}
// ANCHOR_END: per_steradian

/// Light of some radiance from a direction that was chosen with a density; `None` if nothing can come from there.
pub fn shine(toward: Dir3, distance: f32, radiance: Rgb, pdf: f32) -> Option<LightSample> {
    let usable = pdf > 0.0 && pdf.is_finite();
    usable.then(|| LightSample {
        toward,
        distance,
        arriving: radiance / pdf,
        pdf,
    })
}

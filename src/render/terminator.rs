//! The line where light ends on a mesh that pretends to be round.

use crate::math::dir3::Dir3;
use crate::shape::Surface;

// ANCHOR: terminator
/// The share of light that a mesh keeps near the line where light ends: G + G² − G³, where
/// G = (l·n)/((l·s)(n·s)) is below 1, with n the facet's normal and s the interpolated one
/// (Chiang, Li and Burley, "Taming the shadow terminator", 2019).
///
/// Where a facet turns away from the light it shadows itself, all at once, while s still sees much light. Here it loses the
/// light before, and smoothly: G is 0 where the shadow begins. 1 where n is s, and where the facet sees more light than s does.
pub fn terminator(at: &Surface, view: Dir3, toward: Dir3) -> f32 {
    if at.normal == at.shading_normal {
        return 1.0;
    }
    let smooth = at.facing(view);
    let flat = if at.normal.dot(*view) < 0.0 {
        -at.normal
    } else {
        at.normal
    };
    let g = flat.dot(*toward) / (smooth.dot(*toward) * flat.dot(*smooth));
    if g.is_nan() || g >= 1.0 {
        return 1.0;
    }
    let g = g.max(0.0);
    g + g * g - g * g * g
}
// ANCHOR_END: terminator

//! Chapter 13: `reflect`.

use crate::exercise::exercises;
use glam::Vec3;
use raybook::material::mirror;
use raybook::math::dir3::Dir3;

exercises! { ($) ch13_reflection
    /// Return the unit direction in which a mirror with this normal sends a ray on, from the direction in which the ray
    /// arrives; the normal may point to either side.
    Reflect: reflect(
        /// i: where the ray goes, to the surface.
        incoming: Dir3,
        /// n: the normal, on either side.
        normal: Dir3,
    ) -> (
        /// Where the reflected ray goes, of length 1.
        reflected: Vec3,
    ) {
        *mirror::reflect(incoming, normal)
    }
}

//! Normal maps: small bumps that only the shading knows, kept in a picture.

use crate::image::{Image, mip::MipMap};
use crate::math::dir3::Dir3;
use glam::{Vec2, Vec3, vec3};

/// A picture of normals, as they lean where a surface is flat: red along u, green along v, blue off the surface, each from −1
/// to 1 (Cohen, Olano and Manocha, "Appearance-preserving simplification", 1998).
#[derive(Clone, Debug, PartialEq)]
pub struct NormalMap {
    map: MipMap,
}

impl NormalMap {
    /// The map of a picture whose channels go from 0 to 1, and 0.5 means 0.
    ///
    /// The values are those that a PNG stores: [`file::load`](crate::image::file::load) has decoded them from sRGB, and
    /// [`encode_srgb`](crate::image::tone::encode_srgb) makes them what they were.
    ///
    /// # Panics
    /// If the picture has no pixel.
    pub fn new(picture: &Image) -> Self {
        Self {
            map: MipMap::new(&picture.map(|pixel| pixel.map(|v| 2.0 * v - 1.0))),
        }
    }

    // ANCHOR: normal_map
    /// The normal at a place: x·t + y·b + z·n, normalised, with n the smooth normal, t along u and b along v.
    ///
    /// t is where u grows in the triangle, made perpendicular to n; b is perpendicular to both, on the side where v grows. Where
    /// the texture coordinates of a triangle do not say it, or the bump would lean below the surface, n stays.
    pub fn tilt(&self, normal: Dir3, edges: [Vec3; 2], along: [Vec2; 2], place: Vec2) -> Dir3 {
        let turned = along[0].perp_dot(along[1]);
        let u = (edges[0] * along[1].y - edges[1] * along[0].y) * turned.signum();
        let Some(tangent) = Dir3::new(u - *normal * normal.dot(u)) else {
            return normal;
        };
        let bitangent = normal.cross(*tangent) * turned.signum();
        let lean = self.map.at(place, 0.0);
        let bump = vec3(lean.r, lean.g, lean.b);
        if bump.z <= 0.0 || turned == 0.0 {
            return normal;
        }
        Dir3::new_or(
            bump.x * *tangent + bump.y * bitangent + bump.z * *normal,
            normal,
        )
    }
    // ANCHOR_END: normal_map
}

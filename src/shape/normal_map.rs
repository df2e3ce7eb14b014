//! Normal maps: small bumps for shading only, stored in a picture.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::shape::normal_map::NormalMap;
//!
//! let even = NormalMap::new(&Image::from_fn(1, 1, |_, _| Rgb::new(0.5, 0.5, 1.0)));
//! let slope = NormalMap::new(&Image::from_fn(1, 1, |_, _| Rgb::new(1.0, 0.5, 1.0)));
//! let tilt = |map: &NormalMap| map.tilt(Dir3::Z, [Vec3::X, Vec3::Y], [Vec2::X, Vec2::Y], Vec2::ZERO);
//! assert_eq!(tilt(&even), Dir3::Z);
//! assert!((tilt(&slope).x - tilt(&slope).z).abs() < 1e-6); // (1, 0, 1): by 45° towards u
//! ```

use crate::image::{Image, mip::MipMap};
use crate::math::dir3::Dir3;
use glam::{Vec2, Vec3, vec3};

/// A picture of normals relative to the smooth surface: red is the component along u, green along v, and blue along the surface's
/// normal, each from −1 to 1 (Cohen, Olano and Manocha, "Appearance-preserving simplification", 1998).
#[derive(Clone, Debug, PartialEq)]
pub struct NormalMap {
    map: MipMap,
}

impl NormalMap {
    /// The map of a picture whose channels are from 0 to 1, where 0.5 means the component 0.
    ///
    /// The values must be those that a PNG stores. [`file::load`](crate::image::file::load) decodes them from sRGB, so they must
    /// be encoded again by [`encode_srgb`](crate::image::tone::encode_srgb).
    ///
    /// # Panics
    /// If the picture has no pixel.
    #[track_caller]
    pub fn new(picture: &Image) -> Self {
        Self {
            map: MipMap::new(&picture.map(|pixel| pixel.map(|v| 2.0 * v - 1.0))),
        }
    }

    // ANCHOR: normal_map
    /// The normal at a place: x·t + y·b + z·n, normalised. (x, y, z) is the map's value, n = `normal` the smooth normal, t the
    /// tangent along u and b the tangent along v.
    ///
    /// t is the direction in which u grows in the triangle, made perpendicular to n; b is perpendicular to both, on the side
    /// where v grows. `edges` are e₁ and e₂ of the triangle, and `along` the changes of the texture coordinates along them. The
    /// result is n if the texture coordinates give no such directions, or if z ≤ 0.
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

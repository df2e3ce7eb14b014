//! Floor 2: what a ray can hit.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let ball = Sphere::new(Vec3::ZERO, 1.0);
//! let ray = Ray::new(vec3(0.0, 0.0, 3.0), -Dir3::Z);
//! let hit = ball.hit(&ray, Interval::AHEAD).expect("in the way");
//! let surface = ball.surface(&ray, &hit);
//! assert_eq!((hit.t, surface.normal), (2.0, Dir3::Z));
//! // A ray that leaves to the outside does not hit the ball again.
//! assert!(!ball.blocks(&surface.leave(Dir3::Z), Interval::AHEAD));
//! ```

pub mod attributes;
pub mod bezier;
pub mod cuboid;
pub mod instance;
pub mod mesh;
#[cfg(feature = "files")]
pub mod mesh_file;
pub mod mesh_looks;
pub mod normal_map;
pub mod obj;
pub mod plane;
pub mod ply;
pub mod sphere;
pub mod stl;
pub mod teapot;
pub mod triangle;
pub mod triangle_by_determinants;
pub mod triangle_by_plane;
pub mod triangle_watertight;
pub mod word;

use crate::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray};
use glam::{Vec2, Vec3};

// ANCHOR: shape
/// A shape: something with a surface that a ray can hit.
///
/// A shape must not panic for any ray. For a ray with NaN or infinite coordinates, its answer has no meaning.
pub trait Shape: Send + Sync {
    /// A box that holds the whole shape; infinite for a plane.
    fn bounds(&self) -> Aabb;

    /// The nearest hit whose distance lies in the interval.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit>;

    /// Whether there is any hit in the interval, which is all that a shadow ray needs.
    fn blocks(&self, ray: &Ray, within: Interval) -> bool {
        self.hit(ray, within).is_some()
    }

    /// [`Shape::hit`] of one ray, for many shapes: what is the same for all shapes is computed once.
    fn hit_by(ray: &Ray) -> impl Fn(&Self, Interval) -> Option<Hit>
    where
        Self: Sized,
    {
        |shape, within| shape.hit(ray, within)
    }

    /// [`Shape::blocks`] of one ray, for many shapes.
    fn blocked_by(ray: &Ray) -> impl Fn(&Self, Interval) -> bool
    where
        Self: Sized,
    {
        |shape, within| shape.blocks(ray, within)
    }

    /// The surface where this ray hit the shape; it is computed once, for the nearest of all hits.
    fn surface(&self, ray: &Ray, hit: &Hit) -> Surface;
}
// ANCHOR_END: shape

/// A hit: the few numbers that a candidate for the nearest hit must carry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Distance along the ray, in metres.
    pub t: f32,
    /// The place on the shape, in the shape's own coordinates; on a triangle, the barycentric coordinates (b₁, b₂).
    pub uv: Vec2,
    /// The number of the shape in an aggregate, else 0.
    pub id: u32,
}

/// A point of a surface, with all that shading needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// The point, in metres.
    pub position: Vec3,
    /// Maximum distance of the true surface from `position`, along each axis, in metres.
    pub error: f32,
    /// The direction perpendicular to the surface, on the side that the shape calls outside.
    pub normal: Dir3,
    /// The normal for shading; on a mesh it is interpolated.
    pub shading_normal: Dir3,
    /// Texture coordinates.
    pub texture: Vec2,
    /// The change of the texture coordinates along the surface, per metre; 0 if they are constant.
    pub texture_per_metre: f32,
    /// The width over which a texture is averaged, in texture coordinates; 0 for a single point.
    pub texture_width: f32,
    /// The vector from the point to the round surface that a smooth mesh imitates, in metres; 0 for other surfaces.
    pub lift: Vec3,
    /// The vector from the point to where rays start on the side from which the point was seen ([`Surface::seen_along`]), in
    /// metres; 0 if it was not seen by a ray.
    pub clear: Vec3,
}

impl Surface {
    /// A surface without a shading normal of its own, and with constant texture coordinates.
    pub fn flat(position: Vec3, error: f32, normal: Dir3) -> Self {
        Self {
            position,
            error,
            normal,
            shading_normal: normal,
            texture: Vec2::ZERO,
            texture_per_metre: 0.0,
            texture_width: 0.0,
            lift: Vec3::ZERO,
            clear: Vec3::ZERO,
        }
    }

    // ANCHOR: leave
    /// A ray that leaves this point in a direction and does not hit this surface again.
    ///
    /// This is the only rule against self-intersection. `position` is not exactly on the surface, but at most
    /// e = `error` away along each axis, that is e·(|nₓ| + |n_y| + |n_z|) along the normal n. The ray starts at this distance,
    /// on the side to which it leaves (Pharr, Jakob and Humphreys, *Physically Based Rendering*, 4th edition, 2023, §6.8).
    /// So its origin is certainly on this side, at any scale of the scene, and AHEAD needs no 0.001. On the side from which the
    /// point was seen, `clear` is used instead, which is as far off the surface, and better where two surfaces meet.
    #[inline]
    pub fn leave(&self, direction: Dir3) -> Ray {
        let side = self.normal.dot(*direction);
        let away = if side * self.normal.dot(self.clear) > 0.0 {
            self.clear
        } else if side < 0.0 {
            -self.off() * *self.normal
        } else {
            self.off() * *self.normal
        };
        Ray::new(self.position + away, direction)
    }
    // ANCHOR_END: leave

    /// e·(|nₓ| + |n_y| + |n_z|): the maximum distance of the true surface from `position`, along the normal, in metres.
    fn off(&self) -> f32 {
        self.error * self.normal.abs().element_sum()
    }

    // ANCHOR: seen_along
    /// The same surface, with `clear` for the ray that hit it at the distance t.
    ///
    /// Where two surfaces meet, a point of one surface may be rounded to a place behind the other. A ray that starts off the
    /// first surface along the normal may still start behind the second: then light is blocked, or arrives from behind. But the
    /// way along which the point was seen is free. So rays start on this way, back from the point, four times as far off the
    /// surface as [`Surface::leave`] needs, because the other surface may be seen at a more grazing angle. The distance along the
    /// way is at least the rounding error of the way itself, but at most a hundred times the needed distance, and at most half of
    /// the way. If the start is then too close to the surface, the rest is added along the normal.
    #[must_use]
    #[inline]
    pub fn seen_along(self, ray: &Ray, t: f32) -> Self {
        let (off, cosine) = (self.off(), -self.normal.dot(*ray.direction));
        let rounded = ROUNDING * (ray.origin.abs().max_element() + t);
        let back = (4.0 * off / cosine.abs()).min(100.0 * off);
        let back = back.max(rounded).min(0.5 * t);
        let rest = (off - back * cosine.abs()).max(0.0).copysign(cosine);
        let clear = rest * *self.normal - back * *ray.direction;
        Self { clear, ..self }
    }
    // ANCHOR_END: seen_along

    // ANCHOR: leave_smooth
    /// A ray that leaves the round surface that a smooth mesh imitates: to the outside, it starts at `lift` from the point.
    ///
    /// A facet that is turned away from the light is entirely in its own shadow, where the round surface would still get a little
    /// light (the shadow terminator). From the lifted start, the ray passes over the facet (Hanika, "Hacking the shadow
    /// terminator", 2021).
    pub fn leave_smooth(&self, direction: Dir3) -> Ray {
        if self.lift == Vec3::ZERO || self.shading_normal.dot(*direction) <= 0.0 {
            return self.leave(direction);
        }
        let off = self.leave(self.normal).origin;
        Ray::new(off + self.lift, direction)
    }
    // ANCHOR_END: leave_smooth
}

/// The bound on rounding errors from which a shape computes [`Surface::error`], as a part of the largest number that the position
/// was computed from.
///
/// An `f32` operation is right to 2⁻²⁴ = 6.0e-8 of its result. The shapes here need fewer than ten operations in a row for a
/// position, and a hit test on the way back adds about as many; most of their errors cancel. Measured over 2 million rays per
/// shape at scales from 1e-6 to 1e6: with a bound of 2 roundings, up to 30 rays hit the surface that they left, with 4 none. 32
/// roundings leave a factor of 8 as a margin (`tests/library/laws/leave.rs` sees no ray fail with 32, and some with 1). Embree,
/// which rounds differently, agrees about rays that start there (`tests/embree`); with 16, Embree hit a plane again.
pub const ROUNDING: f32 = 32.0 * (f32::EPSILON / 2.0);

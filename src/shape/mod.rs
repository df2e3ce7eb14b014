//! Floor 2: what a ray can hit.

pub mod attributes;
pub mod bezier;
pub mod cuboid;
pub mod mesh;
#[cfg(feature = "files")]
pub mod mesh_file;
pub mod mesh_looks;
pub mod normal_map;
pub mod obj;
pub mod placed;
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
/// Something with a surface that a ray can hit.
///
/// No ray makes a shape panic, not even one with NaN or infinite coordinates; its answer then means nothing.
pub trait Shape: Send + Sync {
    /// A box that holds the whole shape; infinite for a plane.
    fn bounds(&self) -> Aabb;

    /// The nearest hit whose distance lies in the interval.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit>;

    /// Whether there is any hit in the interval: all that a shadow needs to know.
    fn blocks(&self, ray: &Ray, within: Interval) -> bool {
        self.hit(ray, within).is_some()
    }

    /// [`Shape::hit`] of one ray, for many shapes: what is the same for all of them is computed once.
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

    /// The surface where this ray hit it; asked once, for the nearest hit of all.
    fn surface(&self, ray: &Ray, hit: &Hit) -> Surface;
}
// ANCHOR_END: shape

/// The little that a candidate for the nearest hit must carry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Distance along the ray, in metres.
    pub t: f32,
    /// Where on the shape, in the shape's own coordinates: barycentrics on a triangle.
    pub uv: Vec2,
    /// Which shape of an aggregate, else 0.
    pub id: u32,
}

/// A point of a surface, as shading wants to know it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// The point.
    pub position: Vec3,
    /// How far the true surface may be from `position`, at most, along each axis, in metres.
    pub error: f32,
    /// The direction perpendicular to the surface, on the side that the shape calls outside.
    pub normal: Dir3,
    /// The direction that shading takes for the normal: interpolated on a mesh.
    pub shading_normal: Dir3,
    /// Texture coordinates.
    pub texture: Vec2,
    /// How much the texture coordinates change along the surface, per metre; 0 where they are the same everywhere.
    pub texture_per_metre: f32,
    /// The width over which a texture is averaged, in texture coordinates; 0 for the place alone.
    pub texture_width: f32,
    /// From the point to the round surface that a mesh pretends to be, in metres; 0 where a surface is what it seems.
    pub lift: Vec3,
    /// From the point to where rays start on the side from which it was seen ([`Surface::seen_along`]); 0 if nobody saw it.
    pub clear: Vec3,
}

impl Surface {
    /// A surface that is what it seems, with the same texture coordinates everywhere.
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
    /// A ray that leaves this point in a direction and does not find this surface again.
    ///
    /// This is the one rule against self-intersection: `position` is not exactly on the surface, but at most
    /// e = `error` away along each axis, that is e·(|nₓ| + |n_y| + |n_z|) along the normal n. The ray starts so far off,
    /// on the side to which it leaves (Pharr, Jakob and Humphreys, *Physically Based Rendering*, §3.9).
    /// So it is certainly on that side, at any scale of the scene, and AHEAD needs no 0.001. To the side from which the
    /// point was seen, `clear` is as far off, and better where two surfaces meet.
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

    /// e·(|nₓ| + |n_y| + |n_z|): how far the true surface may be from `position`, along the normal.
    fn off(&self) -> f32 {
        self.error * self.normal.abs().element_sum()
    }

    // ANCHOR: seen_along
    /// The same surface, with `clear` for the ray that found it at the distance t.
    ///
    /// Where two surfaces meet, a point of the one may be rounded to behind the other, and a start that is off along the normal
    /// is behind it still: no light arrives, or light from behind does. But the way on which the point was seen is free.
    /// So the start is back on this way, until it is off the surface four times as far as [`Surface::leave`] needs, for the other
    /// surface may be seen at a more grazing angle, and as far as the way itself is rounded; but not more than a hundred times as
    /// far, nor half of the way. What is missing is along the normal.
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
    /// A ray that leaves the surface that the shading pretends: to the outside it starts `lift` off.
    ///
    /// A facet that turns away from the light lies in its own shadow, as a whole, where the round surface would still see a little
    /// light. From there the ray passes over the facet (Hanika, "Hacking the shadow terminator", 2021).
    pub fn leave_smooth(&self, direction: Dir3) -> Ray {
        if self.lift == Vec3::ZERO || self.shading_normal.dot(*direction) <= 0.0 {
            return self.leave(direction);
        }
        let off = self.leave(self.normal).origin;
        Ray::new(off + self.lift, direction)
    }
    // ANCHOR_END: leave_smooth
}

/// The bound on rounding errors that a shape states as [`Surface::error`], in units of the largest number
/// that went into the position.
///
/// An `f32` operation is right to 2⁻²⁴ = 6.0e-8 of its result. The shapes here need fewer than ten in a row for a
/// position, and a hit test on the way back adds about as many; most of their errors cancel. Measured over 2 million rays
/// per shape at scales from 1e-6 to 1e6: with 2 of them up to 30 rays find the surface that they left, with 4 none.
/// 32 leave a margin of 8 (`tests/library/laws/leave.rs` sees none fail with 32, and some with 1), and Embree, which rounds otherwise,
/// agrees about rays that start there (`tests/embree`): with 16 it found a plane again.
pub const ROUNDING: f32 = 32.0 * (f32::EPSILON / 2.0);

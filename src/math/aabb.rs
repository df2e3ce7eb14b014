//! The axis-aligned bounding box (AABB).
//!
//! ```
//! use raybook::prelude::*;
//!
//! let cube = Aabb::of([Vec3::ZERO, vec3(1.0, 1.0, 1.0)]);
//! let both = cube.union(&Aabb::of([vec3(5.0, 0.5, 0.5)]));
//! assert_eq!(both.size(), vec3(5.0, 1.0, 1.0));
//! assert_eq!(cube.union(&Aabb::EMPTY), cube); // the empty box adds nothing
//! ```

use glam::Vec3;

/// The points p with min ≤ p ≤ max in every component.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// The least corner.
    pub min: Vec3,
    /// The greatest corner.
    pub max: Vec3,
}

impl Aabb {
    /// The box of no points: inverted and infinite, so that its union with any box is that box.
    pub const EMPTY: Self = Self {
        min: Vec3::INFINITY,
        max: Vec3::NEG_INFINITY,
    };

    /// The box of all points: the bounds of a plane.
    pub const EVERYTHING: Self = Self {
        min: Vec3::NEG_INFINITY,
        max: Vec3::INFINITY,
    };

    /// The box from its least to its greatest corner.
    pub const fn new(min: Vec3, max: Vec3) -> Self {
        Self { min, max }
    }

    // ANCHOR: bounds_of
    /// The smallest box that holds all the points; [`Aabb::EMPTY`] for none.
    ///
    /// A NaN coordinate is ignored.
    pub fn of(points: impl IntoIterator<Item = Vec3>) -> Self {
        // p first: if a comparison is false, as with NaN, glam's a.min(b) and a.max(b) are b.
        points.into_iter().fold(Self::EMPTY, |bounds, p| Self {
            min: p.min(bounds.min),
            max: p.max(bounds.max),
        })
    }
    // ANCHOR_END: bounds_of

    /// The smallest box that holds both.
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// The box that reaches `margin` metres further on each side.
    #[must_use]
    pub fn grown(&self, margin: f32) -> Self {
        Self {
            min: self.min - margin,
            max: self.max + margin,
        }
    }

    /// Whether p lies inside or on a face.
    pub fn contains(&self, p: Vec3) -> bool {
        self.min.cmple(p).all() && p.cmple(self.max).all()
    }

    /// The point in the middle.
    pub fn center(&self) -> Vec3 {
        0.5 * (self.min + self.max)
    }

    /// The extent along each axis, in metres; negative for an empty box.
    pub fn size(&self) -> Vec3 {
        self.max - self.min
    }
}

//! Stage 1: what a builder knows of a shape.

use crate::math::aabb::Aabb;
use glam::Vec3A;

/// A box whose corners are four floats wide. It is for the builders, which take millions of unions: a corner is one vector
/// register.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The least corner.
    pub min: Vec3A,
    /// The greatest corner.
    pub max: Vec3A,
}

impl Bounds {
    /// The box of no points: its union with any box is that box.
    pub const EMPTY: Self = Self {
        min: Vec3A::INFINITY,
        max: Vec3A::NEG_INFINITY,
    };

    /// The smallest box that holds both.
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// The box of the points that are in both boxes; [`Bounds::EMPTY`] if there are none.
    #[must_use]
    pub fn intersection(&self, other: &Self) -> Self {
        let (min, max) = (self.min.max(other.min), self.max.min(other.max));
        if min.cmple(max).all() {
            Self { min, max }
        } else {
            Self::EMPTY
        }
    }

    /// Whether the box holds no point.
    pub fn is_empty(&self) -> bool {
        !self.min.cmple(self.max).all()
    }

    /// Half the surface area: xy + yz + zx, in square metres; 0 for an empty box.
    pub fn half_area(&self) -> f32 {
        let size = (self.max - self.min).max(Vec3A::ZERO);
        size.x * size.y + size.y * size.z + size.z * size.x
    }
}

impl From<&Aabb> for Bounds {
    fn from(bounds: &Aabb) -> Self {
        Self {
            min: bounds.min.into(),
            max: bounds.max.into(),
        }
    }
}

impl From<Bounds> for Aabb {
    fn from(bounds: Bounds) -> Self {
        Self {
            min: bounds.min.into(),
            max: bounds.max.into(),
        }
    }
}

/// A shape as a builder sees it: its box and its number.
#[derive(Clone, Copy, Debug)]
pub struct Item {
    /// The shape's box.
    pub(crate) bounds: Bounds,
    /// The shape's number, from 0.
    pub index: u32,
}

impl Item {
    /// The item of shape number `index`, whose box is `bounds`.
    pub fn new((index, bounds): (usize, &Aabb)) -> Self {
        Self {
            bounds: bounds.into(),
            index: index as u32,
        }
    }

    /// Twice the centre of the box, which is as good as the centre for comparing.
    pub fn center2(&self) -> Vec3A {
        self.bounds.min + self.bounds.max
    }

    /// Twice the centre of the box along one axis.
    pub fn center2_along(&self, axis: usize) -> f32 {
        // As arrays: glam's own `[axis]` compares `axis` with each axis, which is a branch in the innermost loop.
        let (min, max): (&[f32; 3], &[f32; 3]) =
            (self.bounds.min.as_ref(), self.bounds.max.as_ref());
        min[axis] + max[axis]
    }
}

/// How far items extend.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent {
    /// The smallest box that holds the items' boxes.
    pub bounds: Bounds,
    /// The smallest box that holds twice the items' centres.
    pub centers2: Bounds,
}

impl Extent {
    /// The extent of these items.
    pub(crate) fn of(items: &[Item]) -> Self {
        let mut all = Self {
            bounds: Bounds::EMPTY,
            centers2: Bounds::EMPTY,
        };
        for item in items {
            let (min, max) = (item.center2(), item.center2());
            all.bounds = all.bounds.union(&item.bounds);
            all.centers2 = all.centers2.union(&Bounds { min, max });
        }
        all
    }

    /// The axis along which the centres are spread most.
    pub(crate) fn widest(&self) -> usize {
        (self.centers2.max - self.centers2.min).max_position()
    }
}

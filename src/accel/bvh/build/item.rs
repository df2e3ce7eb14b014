//! Stage 1: all that a builder knows of a shape.

use crate::math::aabb::Aabb;
use glam::Vec3A;

/// A box whose corners are four floats wide, for the builders: they unite boxes by the million.
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

    /// The smallest box that holds all boxes of the items.
    pub fn of(items: &[Item]) -> Self {
        let boxes = items.iter().map(|item| &item.bounds);
        boxes.fold(Self::EMPTY, |all, bounds| all.union(bounds))
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

/// A shape as a builder sees it: its box, and which one it is.
#[derive(Clone, Copy, Debug)]
pub struct Item {
    /// The box.
    pub bounds: Bounds,
    /// Which shape.
    pub index: u32,
}

impl Item {
    /// The item of a box and its place.
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
}

/// The smallest box that holds twice the centres of the items.
pub fn centers2(items: &[Item]) -> Bounds {
    items.iter().fold(Bounds::EMPTY, |all, item| {
        let p = item.center2();
        Bounds {
            min: all.min.min(p),
            max: all.max.max(p),
        }
    })
}

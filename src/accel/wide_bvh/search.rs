//! The two questions of one ray, as work for any [`Lanes`].

use super::lanes::{Lanes, Work};
use super::nearest::{Nearest, Seeker};
use super::tree::Tree;
use super::walk;
use crate::accel::Count;
use crate::math::{interval::Interval, ray::Ray};

/// The search for the nearest hit.
pub(super) struct Closest<'a, C> {
    /// The tree.
    pub tree: &'a Tree,
    /// The ray.
    pub ray: &'a Ray,
    /// The distances that count.
    pub within: Interval,
    /// Counts the work.
    pub count: &'a mut C,
}

impl<C: Count> Work for Closest<'_, C> {
    type Answer = Nearest;

    #[inline(always)]
    fn with<L: Lanes>(self, lanes: L) -> Nearest {
        let found = Nearest::nothing(self.within.max);
        let Some(root) = self.tree.root else {
            return found;
        };
        let seeker = Seeker::new(self.ray, self.within.min, self.tree);
        walk::closest(lanes, self.tree, root, &seeker, found, self.count)
    }
}

/// The search for any hit.
pub(super) struct Any<'a> {
    /// The tree.
    pub tree: &'a Tree,
    /// The ray.
    pub ray: &'a Ray,
    /// The distances that count.
    pub within: Interval,
}

impl Work for Any<'_> {
    type Answer = bool;

    #[inline(always)]
    fn with<L: Lanes>(self, lanes: L) -> bool {
        let Some(root) = self.tree.root else {
            return false;
        };
        let seeker = Seeker::new(self.ray, self.within.min, self.tree);
        walk::any(lanes, self.tree, root, &seeker, self.within.max)
    }
}

//! The shapes of one list after another, each asked only once.

use crate::accel::{Count, grid::mailbox::Mailbox};
use crate::math::{interval::Interval, ray::Ray};
use crate::shape::{Hit, Shape};

/// A ray that comes through the lists of cells.
pub(crate) struct Lists<'a, 'r, S> {
    shapes: &'a [S],
    ray: &'r Ray,
    asked: Mailbox,
}

impl<'a, 'r, S: Shape> Lists<'a, 'r, S> {
    /// Before the first list; lists hold places in `shapes`.
    pub(crate) fn new(shapes: &'a [S], ray: &'r Ray) -> Self {
        Self {
            shapes,
            ray,
            asked: Mailbox::new(),
        }
    }

    /// The nearest hit of the shapes in a list that no earlier list had; the interval ends there.
    #[inline]
    pub(crate) fn nearest(
        &mut self,
        list: &[u32],
        within: &mut Interval,
        count: &mut impl Count,
    ) -> Option<(&'a S, Hit)> {
        let mut nearest = None;
        for &place in list {
            if self.asked.is_first(place) {
                count.tested_shape();
                let shape = &self.shapes[place as usize];
                if let Some(hit) = shape.hit(self.ray, *within) {
                    *within = within.before(hit.t);
                    nearest = Some((shape, hit));
                }
            }
        }
        nearest
    }

    /// Whether any of the shapes in a list that no earlier list had is hit.
    #[inline]
    pub(crate) fn block(&mut self, list: &[u32], within: Interval) -> bool {
        list.iter().any(|&place| {
            self.asked.is_first(place) && self.shapes[place as usize].blocks(self.ray, within)
        })
    }
}

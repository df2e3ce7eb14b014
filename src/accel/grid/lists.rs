//! The shapes of one list after another, each tested only once per ray.

use crate::accel::{Count, grid::mailbox::Mailbox};
use crate::math::interval::Interval;
use crate::shape::{Hit, Shape};

/// The shapes that the lists name, and which of them a ray has tested.
pub(crate) struct Lists<'a, S> {
    shapes: &'a [S],
    asked: Mailbox,
}

impl<'a, S: Shape> Lists<'a, S> {
    /// The state before the first list; lists hold places in `shapes`.
    pub(crate) fn new(shapes: &'a [S]) -> Self {
        Self {
            shapes,
            asked: Mailbox::new(),
        }
    }

    /// The nearest hit, by [`Shape::hit_by`], of the shapes in this list that were in no earlier list; `within` is shortened to
    /// end at the hit.
    ///
    /// Most cells are empty: callers do not ask their lists. So this is a call for the few others, and the walk has the registers.
    #[inline(never)]
    pub(crate) fn nearest(
        &mut self,
        list: &[u32],
        hit_by_ray: &impl Fn(&S, Interval) -> Option<Hit>,
        within: &mut Interval,
        count: &mut impl Count,
    ) -> Option<(&'a S, Hit)> {
        let mut nearest = None;
        for &place in list {
            if self.asked.is_first(place) {
                count.tested_shape();
                let shape = &self.shapes[place as usize];
                if let Some(hit) = hit_by_ray(shape, *within) {
                    *within = within.before(hit.t);
                    nearest = Some((shape, hit));
                }
            }
        }
        nearest
    }

    /// Whether any shape in this list that was in no earlier list is in the way, by [`Shape::blocked_by`]. A call, as [`Lists::nearest`] is.
    #[inline(never)]
    pub(crate) fn block(&mut self, list: &[u32], blocks: impl Fn(&S) -> bool) -> bool {
        list.iter()
            .any(|&place| self.asked.is_first(place) && blocks(&self.shapes[place as usize]))
    }
}

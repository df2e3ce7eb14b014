//! What a search has put aside.

use super::node::Link;

/// A child that waits, and where the ray enters it: the distance's bits, then the link's, in one number.
///
/// Distances of 0 and more are in the same order as their bits. Among those below 0 the order is another; it
/// is of no importance for the answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[repr(transparent)]
pub(super) struct Waiting(u64);

impl Waiting {
    /// A child that the ray enters at t.
    #[inline(always)]
    pub(super) fn new(t: f32, link: Link) -> Self {
        Self(u64::from(t.to_bits()) << 32 | u64::from(link.bits()))
    }

    /// Where the ray enters it.
    #[inline(always)]
    pub(super) fn t(self) -> f32 {
        f32::from_bits((self.0 >> 32) as u32)
    }

    /// Which it is.
    #[inline(always)]
    pub(super) fn link(self) -> Link {
        Link::from_bits(self.0 as u32)
    }
}

/// Number of places; few trees need more than half of them.
pub(super) const PLACES: usize = 40;

/// Places on the processor's stack, where they cost no allocation.
#[derive(Clone, Copy)]
#[repr(C, align(64))]
pub(super) struct Places([Waiting; PLACES]);

impl Default for Places {
    #[inline(always)]
    fn default() -> Self {
        Self::new()
    }
}

impl Places {
    /// Empty ones.
    #[inline(always)]
    pub(super) fn new() -> Self {
        Self([Waiting(0); PLACES])
    }

    /// Puts a child aside, below those from the place `base` on that are nearer.
    #[inline(always)]
    pub(super) fn insert(&mut self, base: usize, len: usize, item: Waiting) {
        let mut place = len;
        while place > base && self.0[place - 1] < item {
            self.0[place] = self.0[place - 1];
            place -= 1;
        }
        self.0[place] = item;
    }

    /// The child in a place.
    #[inline(always)]
    pub(super) fn at(&self, place: usize) -> Waiting {
        self.0[place]
    }
}

//! The mailbox: which shapes a ray has asked already.

/// The shapes that one ray asked last: a table in which a new one pushes out what has the same place.
///
/// A shape is in several cells, and a ray that passes through all of them should ask it once. Amanatides and Woo (1987)
/// leave the ray's number with each shape; but then two threads cannot use the same shapes. Here the ray keeps the numbers
/// of its shapes (Benthin, *Realtime Ray Tracing on Current CPU Architectures*, 2006, hashes them so).
///
/// A triangle's test costs little more than to look it up, so the table is small, in two lines of the cache. A table of everything
/// that was asked, which grows, saves a few more tests and took a quarter longer on the Stanford bunny. Where there are few
/// large shapes, all of them have a place.
pub(super) struct Mailbox {
    last: [u32; PLACES],
}

/// A power of two.
const PLACES: usize = 32;

/// No shape has this number: their count is a `u32`.
const FREE: u32 = u32::MAX;

impl Mailbox {
    /// Nothing asked yet.
    pub(super) fn new() -> Self {
        Self {
            last: [FREE; PLACES],
        }
    }

    /// Whether this shape was not asked before, as far as is known; now it is.
    #[inline]
    pub(super) fn is_first(&mut self, shape: u32) -> bool {
        // Shapes of one neighbourhood have numbers in a row, which are their places: few of them meet.
        let place = &mut self.last[shape as usize % PLACES];
        let is_first = *place != shape;
        *place = shape;
        is_first
    }
}

//! The mailbox: which shapes a ray has tested already.

/// The shapes that one ray has tested last: a table in which a new shape replaces the one with the same place.
///
/// A shape is in several cells, and a ray that passes through all of them should test it once. Amanatides and Woo (1987)
/// store the ray's number with each shape; but then two threads cannot use the same shapes. Here the ray stores the numbers
/// of its shapes, in a hash table (as Benthin, *Realtime Ray Tracing on Current CPU Architectures*, 2006).
///
/// A triangle's test costs little more than looking the triangle up, so the table is small: two cache lines. A growing table
/// of all shapes that were tested saves a few more tests, and took a quarter longer on the Stanford bunny. Up to 32 shapes
/// have a place each.
pub(super) struct Mailbox {
    last: [u32; PLACES],
}

/// Number of places in the table: a power of two, so that the remainder costs one instruction.
const PLACES: usize = 32;

/// The mark of a free place. No shape has this number, because the count of shapes is a `u32`.
const FREE: u32 = u32::MAX;

impl Mailbox {
    /// An empty table: no shape has been tested.
    pub(super) fn new() -> Self {
        Self {
            last: [FREE; PLACES],
        }
    }

    /// Whether the shape is not in the table, and so has not been tested as far as the table knows; enters the shape.
    #[inline]
    pub(super) fn is_first(&mut self, shape: u32) -> bool {
        // Shapes near each other have consecutive numbers, and so different places: few of them collide.
        let place = &mut self.last[shape as usize % PLACES];
        let is_first = *place != shape;
        *place = shape;
        is_first
    }
}

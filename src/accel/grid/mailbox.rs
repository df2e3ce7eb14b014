//! The mailbox: which shapes a ray has asked already.

/// The shapes that one ray has asked: a hash table on the stack, which moves to the heap when it is half full.
///
/// A shape is in several cells, and a ray that passes through all of them should ask it once. Amanatides and Woo (1987)
/// leave the ray's number with each shape; but then two threads cannot use the same shapes. Here the ray keeps the numbers
/// of its shapes.
///
/// Measured on the Stanford bunny, in tests per ray from the surface: 30.3 without any of this, 24.0 with it; 28.0 and 24.5 with
/// a table of 8 or 64 numbers where a new one pushes out what has the same place. The times of the four differ by less than
/// they vary from run to run: a triangle's test costs little more than to look it up. Where shapes are dear, or much larger
/// than cells, the whole memory pays.
pub(super) struct Mailbox {
    small: [u32; SMALL],
    /// Empty as long as `small` suffices.
    large: Vec<u32>,
    asked: usize,
}

/// Most rays ask fewer than half as many shapes. A power of two.
const SMALL: usize = 64;

/// No shape has this number: their count is a `u32`.
const FREE: u32 = u32::MAX;

impl Mailbox {
    /// Nothing asked yet.
    pub(super) fn new() -> Self {
        Self {
            small: [FREE; SMALL],
            large: Vec::new(),
            asked: 0,
        }
    }

    /// Whether this shape was not asked before; now it is.
    #[inline]
    pub(super) fn is_first(&mut self, shape: u32) -> bool {
        let table = if self.large.is_empty() {
            &mut self.small[..]
        } else {
            &mut self.large
        };
        let is_first = insert(table, shape);
        if is_first {
            self.asked += 1;
            if 2 * self.asked > table.len() {
                self.grow();
            }
        }
        is_first
    }

    #[cold]
    fn grow(&mut self) {
        let table = if self.large.is_empty() {
            &self.small[..]
        } else {
            &self.large
        };
        let mut larger = vec![FREE; 4 * table.len()];
        for &shape in table {
            if shape != FREE {
                insert(&mut larger, shape);
            }
        }
        self.large = larger;
    }
}

impl Default for Mailbox {
    fn default() -> Self {
        Self::new()
    }
}

/// Puts a number into the first free place from its own on; false if it is there already. Some places must be free.
#[inline]
fn insert(table: &mut [u32], shape: u32) -> bool {
    let last = table.len() - 1;
    // Shapes of one neighbourhood have numbers in a row, which are their places: no two meet.
    let mut place = shape as usize & last;
    loop {
        if table[place] == shape {
            return false;
        }
        if table[place] == FREE {
            table[place] = shape;
            return true;
        }
        place = (place + 1) & last;
    }
}

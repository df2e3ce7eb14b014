//! How many rays were followed: the unit in which a ray tracer's work is told.

use std::cell::Cell;

thread_local! {
    /// Each thread counts for itself: at one count for all, the threads would wait for each other.
    static RAYS: Cell<u64> = const { Cell::new(0) };
}

/// One more ray, on this thread.
pub fn one_more() {
    RAYS.set(RAYS.get() + 1);
}

/// How many rays this thread has followed since it was last asked.
pub fn take() -> u64 {
    RAYS.take()
}

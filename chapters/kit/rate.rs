//! How many rays a second are followed while a chapter draws.

use std::cell::Cell;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::time::Instant;

thread_local! {
    /// When this thread was last done with some pixels.
    static BEFORE: Cell<Option<Instant>> = const { Cell::new(None) };
}

/// Rays, and the time that they took, summed over the threads.
#[derive(Debug, Default)]
pub struct Rate {
    rays: AtomicU64,
    nanoseconds: AtomicU64,
}

impl Rate {
    /// Some pixels are done, on this thread, with this number of rays. The first ones of a thread do not count, because their start
    /// time is not known.
    pub fn done(&self, rays: u64) {
        let now = Instant::now();
        if let Some(before) = BEFORE.replace(Some(now)) {
            self.rays.fetch_add(rays, Relaxed);
            let time = now.duration_since(before).as_nanos() as u64;
            self.nanoseconds.fetch_add(time, Relaxed);
        }
    }

    /// Rays per second of all threads together, since the last call; `None` if there were no rays.
    pub fn take(&self, threads: usize) -> Option<f64> {
        let rays = self.rays.swap(0, Relaxed) as f64;
        let seconds = 1e-9 * self.nanoseconds.swap(0, Relaxed) as f64;
        (rays > 0.0 && seconds > 0.0).then(|| threads as f64 * rays / seconds)
    }
}

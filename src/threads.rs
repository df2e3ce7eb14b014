//! Floor 0: work on several threads; without the feature `threads`, on the current thread only, with the same results.
//!
//! Every function here returns what one thread would return, bit for bit, in the same order.

#[cfg(feature = "threads")]
pub(crate) use many::{fill, join, sort_by_cached_key, workers};
#[cfg(not(feature = "threads"))]
pub(crate) use one::{fill, join, sort_by_cached_key, workers};

/// The list of f(0), f(1), …, f(n − 1).
pub(crate) fn list<T: Send>(n: usize, f: impl Fn(usize) -> T + Sync + Send) -> Vec<T> {
    let mut list = Vec::with_capacity(n);
    fill(&mut list, n, f);
    list
}

#[cfg(feature = "threads")]
mod many {
    use rayon::prelude::*;
    use std::thread;

    /// Below this number of items, another thread does not pay.
    const ALONE: usize = 1 << 10;

    /// Replaces the contents of a list by f(0), f(1), …, f(n − 1).
    pub(crate) fn fill<T: Send>(list: &mut Vec<T>, n: usize, f: impl Fn(usize) -> T + Sync + Send) {
        let all = (0..n).into_par_iter().with_min_len(ALONE);
        all.map(f).collect_into_vec(list);
    }

    /// The results of both functions.
    pub(crate) fn join<A: Send, B: Send>(
        a: impl FnOnce() -> A + Send,
        b: impl FnOnce() -> B + Send,
    ) -> (A, B) {
        rayon::join(a, b)
    }

    /// Sorts by keys, each of which is computed once; items with equal keys keep their order.
    pub(crate) fn sort_by_cached_key<T: Send + Sync, K: Ord + Send + Sync>(
        list: &mut [T],
        key: impl Fn(&T) -> K + Sync,
    ) {
        list.par_sort_by_cached_key(key);
    }

    /// Calls `work` on n threads at the same time, which share the work. A panic of a thread is passed on.
    pub(crate) fn workers(n: usize, work: &(dyn Fn() + Sync)) {
        thread::scope(|scope| {
            for worker in (0..n).map(|_| scope.spawn(work)).collect::<Vec<_>>() {
                worker
                    .join()
                    .unwrap_or_else(|panic| std::panic::resume_unwind(panic));
            }
        });
    }
}

#[cfg(not(feature = "threads"))]
mod one {
    /// Replaces the contents of a list by f(0), f(1), …, f(n − 1).
    pub(crate) fn fill<T>(list: &mut Vec<T>, n: usize, f: impl Fn(usize) -> T) {
        list.clear();
        list.extend((0..n).map(f));
    }

    /// The results of both functions.
    pub(crate) fn join<A, B>(a: impl FnOnce() -> A, b: impl FnOnce() -> B) -> (A, B) {
        (a(), b())
    }

    /// Sorts by keys, each of which is computed once; items with equal keys keep their order.
    pub(crate) fn sort_by_cached_key<T, K: Ord>(list: &mut [T], key: impl Fn(&T) -> K) {
        list.sort_by_cached_key(key);
    }

    /// Calls `work` once, on the current thread.
    pub(crate) fn workers(_n: usize, work: &(dyn Fn() + Sync)) {
        work();
    }
}

//! Floor 0: work on several threads; without the feature `threads`, on the current thread only, with the same results.
//!
//! Every function here returns what one thread would return, bit for bit, in the same order.

#[cfg(feature = "threads")]
pub(crate) use many::{fill, join, workers};
#[cfg(not(feature = "threads"))]
pub(crate) use one::{fill, join, workers};

/// The list of f(0), f(1), …, f(n − 1).
pub(crate) fn list<T: Send>(n: usize, f: impl Fn(usize) -> T + Sync + Send) -> Vec<T> {
    let mut list = Vec::with_capacity(n);
    fill(&mut list, n, f);
    list
}

/// Sorts a list of at most 2³² by keys, each of which is computed once; what has equal keys keeps its order.
pub(crate) fn sort_by_cached_key<T: Send + Sync>(list: &mut [T], key: impl Fn(&T) -> u64 + Sync) {
    #[cfg(feature = "threads")]
    use many::sort;
    #[cfg(not(feature = "threads"))]
    use one::sort;
    let mut order = self::list(list.len(), |i| (key(&list[i]), i as u32));
    sort(&mut order);
    // Each place gets what belongs there by a swap, and what was there goes to the place of that.
    for to in 0..list.len() {
        let mut from = order[to].1 as usize;
        while from < to {
            from = order[from].1 as usize;
        }
        order[to].1 = from as u32;
        list.swap(to, from);
    }
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

    /// Sorts pairs of a key and a place: equal keys by their places. It stands apart from [`super::sort_by_cached_key`], which is compiled
    /// anew for each use.
    pub(super) fn sort(order: &mut [(u64, u32)]) {
        order.par_sort_unstable();
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

    /// Sorts pairs of a key and a place: equal keys by their places.
    pub(super) fn sort(order: &mut [(u64, u32)]) {
        order.sort_unstable();
    }

    /// Calls `work` once, on the current thread.
    pub(crate) fn workers(_n: usize, work: &(dyn Fn() + Sync)) {
        work();
    }
}

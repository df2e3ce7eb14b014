//! The same for each of many numbers, by all processors.

use rayon::prelude::*;
use std::sync::OnceLock;

/// The list of f(0), f(1), …, f(n − 1): what one processor would find, in the same order.
pub fn of_each<T: Send + Sync>(n: usize, f: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let found: Vec<_> = (0..n).map(|_| OnceLock::new()).collect();
    side_by_side(n, &|i| {
        found[i].get_or_init(|| f(i));
    });
    found.into_iter().filter_map(OnceLock::into_inner).collect()
}

/// It stands apart from [`of_each`], which is compiled anew for each use.
fn side_by_side(n: usize, work: &(dyn Fn(usize) + Sync)) {
    (0..n).into_par_iter().for_each(work);
}

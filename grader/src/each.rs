//! The same for each of many, on all cores.

use std::panic::resume_unwind;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::{iter, thread};

/// What a function finds for these, in their order.
pub fn found_of_each<T: Sync, R: Send + Sync>(
    of: &[T],
    find: impl Fn(&T) -> Option<R> + Sync,
) -> impl Iterator<Item = R> {
    each(of, find).into_iter().flatten()
}

/// What a function makes of each of these, in their order.
pub fn each<T: Sync, R: Send + Sync>(of: &[T], make: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let made: Vec<_> = of.iter().map(|_| OnceLock::new()).collect();
    on_all_cores(of.len(), &|i| {
        made[i].get_or_init(|| make(&of[i]));
    });
    made.into_iter().filter_map(OnceLock::into_inner).collect()
}

/// Does the work of each number below n. It stands apart from [`each`], which is compiled anew for each use.
///
/// The threads are none of rayon's: one that waits for a part of its work takes up other work meanwhile, which would find there the
/// mistake that is given for what is right. On a thread of rayon's, which has others beside it, no more are begun: if all of them waited
/// here, nobody would do what these ask of rayon.
fn on_all_cores(n: usize, work: &(dyn Fn(usize) + Sync)) {
    let threads = rayon::current_num_threads().min(n);
    if threads < 2 || rayon::current_thread_index().is_some() {
        return (0..n).for_each(work);
    }
    let next = AtomicUsize::new(0);
    let share = || {
        let numbers = iter::repeat_with(|| next.fetch_add(1, Ordering::Relaxed));
        numbers.take_while(|i| *i < n).for_each(work);
    };
    thread::scope(|scope| {
        let others: Vec<_> = (1..threads).map(|_| scope.spawn(share)).collect();
        share();
        for other in others {
            other.join().unwrap_or_else(|panic| resume_unwind(panic));
        }
    });
}

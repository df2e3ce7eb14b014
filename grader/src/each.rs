//! The same for each of many, on all cores.

use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// What a function finds for these, in their order.
pub fn found_of_each<T: Sync, R: Send>(
    of: &[T],
    find: impl Fn(&T) -> Option<R> + Sync,
) -> impl Iterator<Item = R> {
    each(of, find).into_iter().flatten()
}

/// What a function makes of each of these, in their order.
///
/// The threads are none of rayon's: one that waits for a part of its work takes up other work meanwhile, which would find there the
/// mistake that is given for what is right. On a thread of rayon's, which has others beside it, no more are begun: if all of them waited
/// here, nobody would do what these ask of rayon.
pub fn each<T: Sync, R: Send>(of: &[T], make: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let threads = rayon::current_num_threads().min(of.len());
    if threads < 2 || rayon::current_thread_index().is_some() {
        return of.iter().map(make).collect();
    }
    let next = AtomicUsize::new(0);
    let work = || {
        let mut made = Vec::new();
        loop {
            let i = next.fetch_add(1, Ordering::Relaxed);
            let Some(one) = of.get(i) else {
                return made;
            };
            made.push((i, make(one)));
        }
    };
    let mut made = thread::scope(|scope| {
        let others: Vec<_> = (1..threads).map(|_| scope.spawn(work)).collect();
        let mut made = work();
        for other in others {
            made.extend(other.join().unwrap_or_else(|panic| resume_unwind(panic)));
        }
        made
    });
    made.sort_by_key(|(i, _)| *i);
    made.into_iter().map(|(_, one)| one).collect()
}

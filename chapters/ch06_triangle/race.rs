//! Which of several ways is the fastest: measured now, on this machine, on the same questions.

use std::hint::black_box;
use std::time::Instant;

/// Number of rounds, in each of which every contestant answers all questions. The best round counts: other work of the machine
/// can only add time.
const ROUNDS: usize = 60;

/// Nanoseconds per question for each contestant, in their order.
///
/// The contestants take turns, so that a machine that slows down slows all of them.
pub(super) fn nanoseconds<Q, A>(questions: &[Q], contestants: &[fn(&Q) -> A]) -> Vec<f64> {
    let mut best = vec![f64::INFINITY; contestants.len()];
    for _ in 0..ROUNDS {
        for (best, answer) in best.iter_mut().zip(contestants) {
            let start = Instant::now();
            for question in questions {
                black_box(answer(black_box(question)));
            }
            *best = best.min(start.elapsed().as_secs_f64());
        }
    }
    best.iter()
        .map(|seconds| 1e9 * seconds / questions.len().max(1) as f64)
        .collect()
}

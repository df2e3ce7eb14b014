//! Whether a question is fair: whether its answer survives a change in the last digits of its numbers.

use crate::examine::Examiner;
use rand::RngExt;
use raybook::math::pcg::{self, Pcg};
use std::cell::LazyCell;

/// A fair question keeps its answer in this number of tries of moving each of its numbers by at most [`crate::Graded::ULPS`] of its
/// last digits.
const JIGGLES: usize = 8;

/// From this effort on an answer is an estimate, and is judged by bounds much wider than last digits move it: one try is enough.
const ESTIMATE: usize = 100;

/// Whether the answer stays right when the question's numbers move in their last digits.
///
/// A ray that grazes a silhouette is nobody's fault.
pub fn is_stable(examiner: &(dyn Examiner + '_), question: &[f64], rng: &mut Pcg) -> bool {
    is_stable_within(examiner, question, examiner.ulps(), JIGGLES, rng)
}

/// The same for moves by at most `ulps` of the last digits, in this number of tries.
pub fn is_stable_within(
    examiner: &(dyn Examiner + '_),
    question: &[f64],
    ulps: i32,
    tries: usize,
    rng: &mut Pcg,
) -> bool {
    let tries = if examiner.limits().effort < ESTIMATE {
        tries
    } else {
        1
    };
    // A stream of its own: how many tries are made must not change the questions that follow.
    let rng = &mut pcg::stream(rng.random(), 0);
    let call = examiner.asked().call;
    let golden = LazyCell::new(|| call(question));
    (0..tries).all(|_| {
        let moved = jiggle(question, ulps, rng);
        moved == question || examiner.compare(question, &golden, &call(&moved)).is_ok()
    })
}

/// The numbers of a row, each that is not whole moved by a few of its last digits.
fn jiggle(numbers: &[f64], ulps: i32, rng: &mut Pcg) -> Vec<f64> {
    let moved = numbers.iter().map(|&v| {
        if v.is_finite() && v.fract() != 0.0 {
            let bits = (v as f32).to_bits() as i32 + rng.random_range(-ulps..=ulps);
            f32::from_bits(bits as u32).into()
        } else {
            v
        }
    });
    moved.collect()
}

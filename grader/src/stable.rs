//! Whether a question is fair: whether its answer survives a change in the last digits of its numbers.

use crate::Graded;
use rand::RngExt;
use raybook::math::pcg::{self, Pcg};
use raybook_workbook::row::{self, Row};
use std::cell::LazyCell;

/// A fair question keeps its answer in so many tries of moving each of its numbers by at most [`Graded::ULPS`] of its last
/// digits.
const JIGGLES: usize = 8;

/// Whether the answer stays right when the question's numbers move in their last digits.
///
/// A ray that grazes a silhouette is nobody's fault.
pub fn is_stable<E: Graded>(question: &E::Question, rng: &mut Pcg) -> bool {
    // A stream of its own: how many tries are made must not change the questions that follow.
    let rng = &mut pcg::stream(rng.random(), 0);
    let asked = question.write();
    let words: Vec<_> = asked.split_whitespace().collect();
    let golden = LazyCell::new(|| E::answer(question));
    let survives = |moved: &[String]| {
        let moved = row::read::<E::Question>(&moved.join(" "), "question");
        moved.is_ok_and(|moved| E::judge(question, &golden, &E::answer(&moved)).is_ok())
    };
    (0..JIGGLES).all(|_| {
        let moved = jiggle(&words, E::ULPS, rng);
        moved == words || survives(&moved)
    })
}

/// The words of a row, every number that is not whole moved by a few of its last digits.
fn jiggle(words: &[&str], ulps: i32, rng: &mut Pcg) -> Vec<String> {
    let moved = words.iter().map(|word| match word.parse::<f32>() {
        Ok(v) if v.is_finite() && v.fract() != 0.0 => {
            let bits = v.to_bits() as i32 + rng.random_range(-ulps..=ulps);
            f32::from_bits(bits as u32).write()
        }
        _ => (*word).to_owned(),
    });
    moved.collect()
}

//! Hidden cases: made when they are needed, from a key that only the course knows.

use hmac::{Hmac, KeyInit, Mac};
use raybook::math::pcg::Pcg;
use sha2::Sha256;

/// Who is asked, and in which course.
#[derive(Clone, Debug)]
pub struct Key {
    /// The course's secret.
    pub course: String,
    /// The term: another one, other cases.
    pub term: String,
    /// The student.
    pub student: String,
}

impl Key {
    /// The random numbers of an exercise's hidden cases: HMAC-SHA256 under the course key of term, student and exercise,
    /// so that the same key gives the same cases on every machine, and nobody can guess them without it.
    pub fn rng(&self, exercise: &str) -> Pcg {
        // HMAC takes a key of any length.
        let Ok(mut mac) = Hmac::<Sha256>::new_from_slice(self.course.as_bytes()) else {
            unreachable!("any length is right")
        };
        for part in [&self.term, &self.student, exercise] {
            // The length first: "ab", "c" and "a", "bc" must differ.
            mac.update(&(part.len() as u64).to_le_bytes());
            mac.update(part.as_bytes());
        }
        let bytes = mac.finalize().into_bytes();
        let word = |i: usize| {
            bytes[8 * i..8 * (i + 1)]
                .iter()
                .fold(0, |word, &byte| (word << 8) | u64::from(byte))
        };
        Pcg::new(word(0), word(1))
    }
}

//! What an answer program may use.

use crate::budget::Total;
use std::time::Duration;

/// What a program may use: for one answer, for all of an exercise, and for all of a check.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Processor time until the next answer, where the system tells it; else time on the wall.
    pub time: Duration,
    /// Bytes printed until the next answer.
    pub output: usize,
    /// What the cases and the pictures of an exercise take together.
    pub exercise: Total,
    /// What everything takes together.
    pub check: Total,
}

impl Limits {
    /// With `time` for an answer; for an exercise 150 times as much, for a check 900 times: 5 minutes and half an hour of
    /// two seconds each. A megabyte for an answer, more than anyone reads; 64 for an exercise and 256 for a check, of which the
    /// answers are kept.
    pub const fn of(time: Duration) -> Self {
        Self {
            time,
            output: 1 << 20,
            exercise: Total {
                time: time.saturating_mul(150),
                bytes: 1 << 26,
            },
            check: Total {
                time: time.saturating_mul(900),
                bytes: 1 << 28,
            },
        }
    }
}

impl Default for Limits {
    /// Two seconds, a thousand times what an answer takes in any language.
    fn default() -> Self {
        Self::of(Duration::from_secs(2))
    }
}

//! What a program may use in all: time and bytes, for each exercise and for a whole check.

use crate::converse::Limits;
use crate::slowness::{known, slowness};
use std::time::Duration;

/// A limit of what all answers take together; on a slow machine the time is longer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Total {
    /// Time in which the program is waited for.
    pub time: Duration,
    /// Bytes that it prints on both outputs.
    pub bytes: usize,
}

/// What a total limit is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Whole {
    /// The cases and the pictures of an exercise.
    Exercise,
    /// All exercises of a check.
    Check,
}

/// Which total limit is used up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Over {
    /// The time.
    Time(Whole, Duration),
    /// The bytes.
    Bytes(Whole, usize),
}

impl Over {
    /// The limit, in words to whoever wrote the program.
    pub fn why(self) -> String {
        let name = |whole| match whole {
            Whole::Exercise => "an exercise",
            Whole::Check => "a check",
        };
        match self {
            Self::Time(whole, limit) => format!(
                "all answers of {} together may take {} s, and these are over",
                name(whole),
                limit.as_secs_f32()
            ),
            Self::Bytes(whole, limit) => format!(
                "your program may print {limit} bytes for {} in all, and these are over: print less",
                name(whole)
            ),
        }
    }

    /// What whoever checks their own program can do about it, in brackets.
    pub(crate) fn help(self) -> &'static str {
        match self {
            Self::Time(Whole::Exercise, _) => {
                " (--time-limit gives more time; `--case N` asks one case alone)"
            }
            Self::Time(Whole::Check, _) => {
                " (--time-limit gives more time; a chapter or an exercise can be checked alone)"
            }
            Self::Bytes(..) => "",
        }
    }
}

/// What is used of the total limits.
#[derive(Clone, Debug)]
pub(crate) struct Budget {
    accounts: [Account; 2],
}

#[derive(Clone, Debug)]
struct Account {
    whole: Whole,
    limit: Total,
    used: Total,
}

const NOTHING: Total = Total {
    time: Duration::ZERO,
    bytes: 0,
};

impl Budget {
    /// Nothing is used yet.
    pub(crate) fn new(limits: &Limits) -> Self {
        let account = |whole, limit| Account {
            whole,
            limit,
            used: NOTHING,
        };
        Self {
            accounts: [
                account(Whole::Exercise, limits.exercise),
                account(Whole::Check, limits.check),
            ],
        }
    }

    /// Begins another exercise, which has its whole share; of the check, what is left is left.
    pub(crate) fn next_exercise(&mut self) {
        self.accounts[0].used = NOTHING;
    }

    /// Books what a conversation took.
    pub(crate) fn spend(&mut self, time: Duration, bytes: usize) {
        for Account { used, .. } in &mut self.accounts {
            used.time += time;
            used.bytes = used.bytes.saturating_add(bytes);
        }
    }

    /// The limit that another `time` and `bytes` would reach, if they reach one.
    pub(crate) fn over(&self, time: Duration, bytes: usize) -> Option<Over> {
        let over = self.reached(time, bytes, known())?;
        match over {
            Over::Time(..) => self.reached(time, bytes, slowness()),
            Over::Bytes(..) => Some(over),
        }
    }

    /// The same, with limits of time that are `longer` times as long.
    fn reached(&self, time: Duration, bytes: usize, longer: f64) -> Option<Over> {
        self.accounts
            .iter()
            .find_map(|Account { whole, limit, used }| {
                let longest = limit.time.mul_f64(longer);
                if used.time + time >= longest {
                    Some(Over::Time(*whole, longest))
                } else if used.bytes.saturating_add(bytes) > limit.bytes {
                    Some(Over::Bytes(*whole, limit.bytes))
                } else {
                    None
                }
            })
    }

    /// How long a conversation may be at the most.
    pub(crate) fn time_left(&self) -> Duration {
        let longest = |limit: Total| limit.time.mul_f64(known());
        let left = |account: &Account| longest(account.limit).saturating_sub(account.used.time);
        self.accounts.iter().map(left).min().unwrap_or_default()
    }
}

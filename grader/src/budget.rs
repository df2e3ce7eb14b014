//! What a program may use in all: time and bytes, for each exercise and for a whole check.

use crate::clock::waited;
use crate::converse::Limits;
use crate::slowness::{known, slowness};
use std::time::Duration;

/// An answer passes through this number of hands, each of which a busy machine may keep waiting: the program's, those of the thread that
/// listens to it, and of the one that asks.
const HANDS: u32 = 3;

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
pub struct Budget {
    accounts: [Account; 2],
}

#[derive(Clone, Copy, Debug)]
struct Account {
    whole: Whole,
    limit: Total,
    used: Total,
    /// How long the thread that asks had waited for the processor before.
    waited_before: Duration,
    /// What a busy machine took of the time around answers that came too soon for a [`Clock`](crate::clock::Clock) to look. It is found out
    /// when the time seems to be used up.
    forgiven: Duration,
    /// The limit that is used up, once one is: whatever a busy machine takes afterwards, no more is asked.
    over: Option<Over>,
}

impl Account {
    fn new(whole: Whole, limit: Total) -> Self {
        Self {
            whole,
            limit,
            used: NOTHING,
            waited_before: waited(),
            forgiven: Duration::ZERO,
            over: None,
        }
    }

    /// Forgives what the thread that asks waited for the processor, and the other hands about as long: of `time` and what is used already,
    /// at most nine tenths, for a tenth of all time counts.
    fn forgive(&mut self, time: Duration) {
        let taken = HANDS * waited().saturating_sub(self.waited_before);
        self.forgiven = taken.min((self.used.time + time) * 9 / 10);
    }

    /// The limit of time on a machine that takes `longer` times as long.
    fn longest(&self, longer: f64) -> Duration {
        self.limit.time.mul_f64(longer)
    }

    /// The limit that another `time` and `bytes` reach, if they reach one, or that was reached before.
    fn over(&mut self, time: Duration, bytes: usize) -> Option<Over> {
        if self.over.is_none() {
            let mut reached = self.reached(time, bytes, known());
            if matches!(reached, Some(Over::Time(..))) {
                self.forgive(time);
                reached = self.reached(time, bytes, slowness());
            }
            self.over = reached;
        }
        self.over
    }

    /// The same, now, with a limit of time that is `longer` times as long.
    fn reached(&self, time: Duration, bytes: usize, longer: f64) -> Option<Over> {
        if time >= self.time_left(longer) {
            Some(Over::Time(self.whole, self.longest(longer)))
        } else if self.used.bytes.saturating_add(bytes) > self.limit.bytes {
            Some(Over::Bytes(self.whole, self.limit.bytes))
        } else {
            None
        }
    }

    /// What is left of it.
    fn time_left(&self, longer: f64) -> Duration {
        (self.longest(longer) + self.forgiven).saturating_sub(self.used.time)
    }
}

const NOTHING: Total = Total {
    time: Duration::ZERO,
    bytes: 0,
};

impl Budget {
    /// Nothing is used yet.
    pub fn new(limits: &Limits) -> Self {
        Self {
            accounts: [
                Account::new(Whole::Exercise, limits.exercise),
                Account::new(Whole::Check, limits.check),
            ],
        }
    }

    /// Begins another exercise, which has its whole share; of the check, what is left is left.
    pub(crate) fn next_exercise(&mut self) {
        let Account { whole, limit, .. } = self.accounts[0];
        self.accounts[0] = Account::new(whole, limit);
    }

    /// Books what a conversation took.
    pub(crate) fn spend(&mut self, time: Duration, bytes: usize) {
        for Account { used, .. } in &mut self.accounts {
            used.time += time;
            used.bytes = used.bytes.saturating_add(bytes);
        }
    }

    /// The limit that another `time` and `bytes` reach, if they reach one, or that was reached before.
    pub fn over(&mut self, time: Duration, bytes: usize) -> Option<Over> {
        self.accounts
            .iter_mut()
            .find_map(|account| account.over(time, bytes))
    }

    /// How long a conversation may be at the most.
    pub(crate) fn time_left(&self) -> Duration {
        let left = |account: &Account| account.time_left(known());
        self.accounts.iter().map(left).min().unwrap_or_default()
    }
}

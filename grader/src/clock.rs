//! Time for an answer is processor time, where the system tells it: a program is not blamed for a busy machine.
//!
//! Time on the wall is what is waited for. When it is over, a program that is still at work, and has not had the processor for
//! that long, goes on; one that sleeps, or waits for something, does not, unless it is still starting.

use crate::slowness::slowness;
#[cfg(target_os = "linux")]
pub(crate) use crate::stat::waited;
#[cfg(target_os = "linux")]
use crate::stat::{Stat, is_in_group, processes};
use crate::suspend::now;
use std::time::{Duration, Instant};

/// The maximum time for an answer in which a program has the processor or asks for none, in time limits: what works now and then and
/// sleeps between ends too.
const AT_MOST: u32 = 10;

/// The first look at what a program has used comes after the time limit divided by this: most answers come before it, and cost
/// no look.
const LOOK: u32 = 4;

/// What the processes of a group have used and whether any of them is at work: running, waiting for the processor or for a disk.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Usage {
    /// Processor time since they were started.
    pub time: Duration,
    /// Whether one of their threads would go on if it could.
    pub at_work: bool,
}

/// Measures the time for an answer.
pub struct Clock {
    group: Option<u32>,
    /// When it began, and how long it goes on, on the wall.
    since: Instant,
    wall: Duration,
    /// What was used when a part of the time was over.
    noted: Option<Duration>,
    /// The last look after that: when, since the beginning, and what was used.
    looked: Option<(Duration, Duration)>,
    /// Whether it slept at the last look. One look may find nobody at work between the end of one process and the start of the next, as
    /// in a shell's script.
    slept: bool,
    /// How long, whenever it was looked at, the program was at work and did not have the processor.
    lost: Duration,
    /// The rest of the time between the looks since the beginning.
    had: Duration,
}

impl Clock {
    /// For the processes of a group; of none if there is none.
    pub fn new(group: Option<u32>) -> Self {
        Self {
            group,
            since: now(),
            wall: Duration::ZERO,
            noted: None,
            looked: None,
            slept: false,
            lost: Duration::ZERO,
            had: Duration::ZERO,
        }
    }

    /// Begins anew.
    pub(crate) fn restart(&mut self) {
        *self = Self {
            lost: self.lost,
            ..Self::new(self.group)
        };
    }

    /// The time on the wall that a busy machine took from the program, in all its time.
    pub fn lost(&self) -> Duration {
        self.lost
    }

    /// When to look again whether the time is over.
    pub fn next_look(&self, limit: Duration) -> Instant {
        self.since
            + match self.noted {
                None => limit / LOOK,
                Some(_) => self.wall.max(limit),
            }
    }

    /// Whether nobody has looked yet since the beginning, a part of the time limit ago.
    pub(crate) fn is_young(&self) -> bool {
        self.noted.is_none()
    }

    /// Whether a program is at work; not known is no.
    pub(crate) fn is_at_work(&self) -> bool {
        self.usage().is_some_and(|usage| usage.at_work)
    }

    /// Whether the time is over: `limit`, plus `start` for a program that has not answered anything yet; both are longer on a slow machine.
    pub fn is_over(&mut self, limit: Duration, start: Duration) -> bool {
        if now() < self.next_look(limit) {
            return false;
        }
        let elapsed = now().saturating_duration_since(self.since);
        let total = limit + start;
        let usage = self.usage();
        let Some(before) = self.noted else {
            let used = usage.map_or(Duration::ZERO, |usage| usage.time);
            self.noted = Some(used);
            self.looked = Some((elapsed, used));
            return false;
        };
        if let (Some(usage), Some((when, used))) = (usage, self.looked) {
            self.looked = Some((elapsed, usage.time));
            let passed = elapsed.saturating_sub(when);
            let lost = if usage.at_work {
                passed.saturating_sub(usage.time.saturating_sub(used))
            } else {
                Duration::ZERO
            };
            self.lost += lost;
            self.had += passed.saturating_sub(lost);
        }
        // Where nothing is known, what passes on the wall is taken for work.
        let (used, at_work) = usage.map_or((elapsed, true), |usage| {
            // So is what was used before the first look.
            let since = usage.time.saturating_sub(before);
            (limit / LOOK + since, usage.at_work)
        });
        self.wall = elapsed + total.saturating_sub(used).clamp(limit / 16, limit);
        let sleeps = !at_work && self.slept;
        self.slept = !at_work;
        let is_over = |total| {
            let slept = sleeps && elapsed >= total;
            slept || used >= total || self.had >= AT_MOST * total
        };
        is_over(total) && is_over(total.mul_f64(slowness()))
    }

    fn usage(&self) -> Option<Usage> {
        usage(self.group?)
    }
}

/// What the processes of a group use; `None` where the system does not tell, or there is none.
#[cfg(target_os = "linux")]
pub fn usage(group: u32) -> Option<Usage> {
    let ticks = rustix::param::clock_ticks_per_second();
    let mut usage = None;
    for (_, folder) in processes().filter(|(process, _)| is_in_group(*process, group)) {
        let Some(stat) = Stat::read(&folder.join("stat")) else {
            continue;
        };
        let threads = std::fs::read_dir(folder.join("task")).into_iter().flatten();
        let threads = threads
            .flatten()
            .filter_map(|thread| Stat::read(&thread.path().join("stat")));
        let at_work = threads
            .into_iter()
            .any(|thread| matches!(thread.state, b'R' | b'D'));
        let time = Duration::from_millis(1000 * stat.ticks / ticks.max(1));
        let all = usage.get_or_insert(Usage {
            time: Duration::ZERO,
            at_work: false,
        });
        all.time += time;
        all.at_work |= at_work;
    }
    usage
}

/// The same elsewhere: nothing is known.
#[cfg(not(target_os = "linux"))]
pub fn usage(_group: u32) -> Option<Usage> {
    None
}

/// How long this thread waited for a processor: nothing is known.
#[cfg(not(target_os = "linux"))]
pub(crate) fn waited() -> Duration {
    Duration::ZERO
}

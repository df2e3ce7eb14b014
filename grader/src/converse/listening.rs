//! Listening to a program until its questions are answered, or it ends or breaks a limit.

use super::prints::{Printed, Prints};
use super::{Conversation, End, LAST_WORDS, Limits, Process, Questions, Waits};
use crate::budget::Budget;
use crate::listen::Event;
use crate::suspend::now;
use raybook_chapters::kit::untrusted::Untrusted;
use std::ops::ControlFlow::{self, Break, Continue};
use std::sync::mpsc::RecvTimeoutError;
use std::time::{Duration, Instant};

/// What a program that has answered everything does until its output ends is waited for this part of the limit.
const AFTERWARDS: u32 = 8;

/// Whether to listen on; else how the program ended, or `None` if everything is answered.
type Next = ControlFlow<Option<End>>;

/// What is heard of a program since it was asked.
pub(super) struct Listening<'a> {
    process: &'a mut Process,
    /// How many answers are expected.
    wanted: usize,
    limits: &'a Limits,
    waits: Waits,
    budget: &'a mut Budget,
    answers: Vec<(Untrusted, Prints)>,
    /// Since the last answer.
    printed: Printed,
    /// Printed since the last answer.
    bytes: usize,
    /// Printed and answered.
    bytes_in_all: usize,
    start: Instant,
    /// What a busy machine had taken of the program's time before.
    lost_before: Duration,
    /// When the last answer came, or patience was renewed.
    heard: Instant,
    /// When its output ended.
    closed: Option<Instant>,
}

impl<'a> Listening<'a> {
    /// From now on, for as many answers as are wanted.
    pub(super) fn new(
        process: &'a mut Process,
        wanted: usize,
        limits: &'a Limits,
        waits: Waits,
        budget: &'a mut Budget,
    ) -> Self {
        let start = now();
        let lost_before = process.clock.lost();
        process.clock.restart();
        Self {
            process,
            wanted,
            limits,
            waits,
            budget,
            answers: Vec::new(),
            printed: Printed::default(),
            bytes: 0,
            bytes_in_all: 0,
            start,
            lost_before,
            heard: start,
            closed: None,
        }
    }

    /// Listens to the end.
    pub(super) fn conversation(mut self) -> Conversation {
        let end = loop {
            if self.waits.patience.is_none() {
                self.process.questions = None;
            }
            let next = match self.process.next_until(self.deadline()) {
                Ok(event) => self.hear(event),
                Err(RecvTimeoutError::Disconnected) => Break(Some(End::Exited(None))),
                Err(RecvTimeoutError::Timeout) => self.nothing_came(),
            };
            if let Break(end) = next {
                break end;
            }
            if self.bytes > self.limits.output {
                break Some(End::Flooded(self.bytes));
            }
            if let Some(end) = self.over() {
                break Some(end);
            }
        };
        self.budget.spend(self.blamed(), self.bytes_in_all);
        Conversation {
            answers: self.answers,
            end,
            leftover: self.printed.told(),
        }
    }

    fn is_complete(&self) -> bool {
        self.answers.len() == self.wanted
    }

    /// Until when to wait for the next event.
    fn deadline(&self) -> Instant {
        let (clock, limit) = (&self.process.clock, self.limits.time);
        let last = self.closed.unwrap_or(self.heard);
        let deadline = match (self.closed, self.waits.patience) {
            (Some(_), _) => last + LAST_WORDS,
            (None, Some(_)) if self.is_complete() => last + self.waits.breath,
            (None, Some(patience)) => clock.next_look(limit).min(last + patience),
            (None, None) if self.is_complete() => last + limit / AFTERWARDS,
            (None, None) => clock.next_look(limit),
        };
        deadline.min(self.start + self.lost() + self.budget.time_left())
    }

    /// Takes in what came.
    fn hear(&mut self, event: Event) -> Next {
        match event {
            Event::Answer(answer) => {
                self.bytes_in_all += answer.len() + 3;
                let printed = std::mem::take(&mut self.printed).told();
                self.answers.push((Untrusted::from(answer), printed));
                if self.answers.len() > self.wanted {
                    return Break(Some(End::TooMany));
                }
                self.bytes = 0;
                self.heard = now();
                self.process.has_started = true;
                self.process.has_answered = true;
                self.process.clock.restart();
            }
            Event::Print(text, whole) => {
                self.count(text.len() + 1);
                self.printed.print(&text, whole);
            }
            Event::Error(text) => {
                self.count(text.len());
                self.printed.complain(&text);
            }
            Event::End => self.closed = Some(now()),
        }
        Continue(())
    }

    fn count(&mut self, bytes: usize) {
        self.bytes += bytes;
        self.bytes_in_all += bytes;
    }

    /// The deadline is over.
    fn nothing_came(&mut self) -> Next {
        let complete = self.is_complete();
        if self.closed.is_some() {
            return Break(Some(End::Exited(None)));
        }
        if complete && self.process.questions.is_some() {
            return Break(None);
        }
        // Of two reasons the total limit is the one that stays.
        if let Some(end) = self.over() {
            return Break(Some(end));
        }
        let starts = !self.process.has_started;
        let questions = self.process.questions.as_ref();
        if starts && questions.is_some_and(Questions::are_read) {
            self.process.has_started = true;
            // A short start is a part of the first answer.
            if !self.process.clock.is_young() {
                self.process.clock.restart();
                return Continue(());
            }
        }
        let looked = now();
        let limit = self.limits.time;
        let starting = if starts {
            self.waits.start
        } else {
            Duration::ZERO
        };
        if complete || self.process.clock.is_over(limit, starting) {
            let most = self.limits.output;
            self.process.hear_where(&mut self.printed, most);
            return Break(Some(End::TimedOut(limit)));
        }
        let patience = self.waits.patience;
        if patience.is_some_and(|patience| looked >= self.heard + patience) {
            self.waits.patience = patience.filter(|_| self.process.clock.is_at_work());
            self.heard = looked;
        }
        Continue(())
    }

    /// The total limit that is used up, if one is.
    fn over(&mut self) -> Option<End> {
        let blamed = self.blamed();
        let over = self.budget.over(blamed, self.bytes_in_all);
        over.map(End::Over)
    }

    fn elapsed(&self) -> Duration {
        now().saturating_duration_since(self.start)
    }

    /// What a busy machine took: it does not count against a total limit, but a tenth of all time does.
    fn lost(&self) -> Duration {
        let lost = self.process.clock.lost().saturating_sub(self.lost_before);
        lost.min(self.elapsed() * 9 / 10)
    }

    fn blamed(&self) -> Duration {
        self.elapsed().saturating_sub(self.lost())
    }
}

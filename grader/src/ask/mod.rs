//! Asking an answer program: any program, which may crash, hang, flood or lie.
//!
//! An answer carries no number: it belongs to the question that is open when it comes. So that this is certain, questions are
//! asked one after the other, each when the one before is answered. A program that holds its answers back is asked all at once,
//! and gives as many answers as there are questions, or it is asked again in smaller parts, down to one question for a process,
//! to which all that it says belongs.
//!
//! Pixels are thousands of questions, and waiting for each answer takes longer than the answer. Of a program that has answered
//! before, many of them are open at a time; if any has no answer, they are asked again one after the other.

mod reply;

pub use reply::{Reply, Said, Waited};

use crate::budget::Budget;
use crate::converse::{BREATH, Conversation, End, Limits, Prints, Process, Program, Waits};
use reply::silence;
use std::io;
use std::time::{Duration, Instant};

/// After this number of questions in a row without an answer the rest is not asked: seconds instead of minutes, for a program that
/// does not know the exercise, or hangs.
const SILENT: usize = 5;

/// Each wait in vain for an answer to an exercise halves the time for its next answers, this number of times: a loop that never ends is
/// seen in twice the time of one answer. Of a program that has not answered anything yet, the waits of all exercises count, and its
/// start has less time too: whoever hangs in the first exercises and is right in the last is found right.
const HALVED: u32 = 4;

/// After this number of waits in vain for an answer to an exercise the rest is not asked, even if others are answered in between.
const WAITS: u32 = 12;

/// Questions of pixels that are open at a time.
const AHEAD: usize = 256;

/// The grace for the start of a program that has not answered anything yet, in time limits for one answer.
const START: u32 = 4;

/// Parts in which a list of questions is asked again, if it was not answered as it should be.
const PARTS: usize = 8;

/// How a program gives its answers.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Manner {
    /// Not known yet.
    Unknown,
    /// Each before it reads on: the same process can be asked more later.
    Prompt,
    /// At the end of all questions: it does not flush its output, or reads everything first.
    AtTheEnd,
}

/// Asks a program whatever is to be asked, in one process if the program allows it.
///
/// A program that answers each question as it comes is kept for the next questions; a new one is started only after it
/// crashed, kept silent, or broke a limit. A program that holds its answers back is started for each list of questions.
pub struct Asker<'a> {
    program: &'a Program,
    limits: Limits,
    budget: Budget,
    manner: Manner,
    /// How long to wait for an answer until the program is told that there are no more questions.
    patience: Duration,
    /// Time for the program's start: at first more than is needed, and then as much as it was seen to need.
    start: Duration,
    process: Option<Process>,
    /// Whether there was any answer.
    has_answered: bool,
    /// Waits in vain for an answer: to this exercise, or since the beginning if there was none before it.
    waits: u32,
    /// How many of them were before this exercise.
    waits_before: u32,
}

impl<'a> Asker<'a> {
    /// Nothing is started yet.
    pub fn new(program: &'a Program, limits: Limits) -> Self {
        Self {
            program,
            limits,
            budget: Budget::new(&limits),
            manner: Manner::Unknown,
            patience: limits.time / 2,
            start: START * limits.time,
            process: None,
            has_answered: false,
            waits: 0,
            waits_before: 0,
        }
    }

    /// The same, but with a process for each list of questions, which are all asked at once: nothing is waited for.
    pub fn at_once(program: &'a Program, limits: Limits) -> Self {
        Self {
            manner: Manner::AtTheEnd,
            ..Self::new(program, limits)
        }
    }

    /// What is asked from now on is of another exercise, which has its own total limits.
    pub fn next_exercise(&mut self) {
        self.budget.next_exercise();
        if self.has_answered {
            self.waits = 0;
        }
        self.waits_before = self.waits;
    }

    /// What is asked from now on goes to a new process.
    pub(crate) fn begin_anew(&mut self) {
        self.process = None;
    }

    /// Asks all the questions, whatever happens, and returns a reply to each.
    ///
    /// One question is open at a time. Where it has no answer, it is asked again in a process of its own, and the others go to
    /// a new process. After five questions in a row without an answer the rest is not asked, nor when a total limit is used up.
    ///
    /// # Errors
    /// If the program cannot be started.
    pub fn ask(&mut self, questions: &[String]) -> io::Result<Vec<Reply>> {
        self.ask_ahead(questions, 1)
    }

    /// The same for many questions of a kind, such as a picture's pixels: many are open at a time, as long as each is answered.
    ///
    /// # Errors
    /// If the program cannot be started.
    pub fn ask_many(&mut self, questions: &[String]) -> io::Result<Vec<Reply>> {
        self.ask_ahead(questions, AHEAD)
    }

    /// Asks all the questions; at most `ahead` of them are open at a time.
    fn ask_ahead(&mut self, questions: &[String], ahead: usize) -> io::Result<Vec<Reply>> {
        let replies = self.ask_each(questions, ahead)?;
        self.has_answered |= replies.iter().any(|reply| reply.said.is_line());
        Ok(replies)
    }

    fn ask_each(&mut self, questions: &[String], mut ahead: usize) -> io::Result<Vec<Reply>> {
        let mut replies = Vec::new();
        // The first reply of this list that came from the process that is being asked.
        let mut since = 0;
        while let Some(rest) = self.still_to_ask(questions, &mut replies) {
            let fresh = self.process.is_none();
            if fresh {
                since = replies.len();
            }
            if self.manner == Manner::AtTheEnd {
                self.ask_apart(rest, &mut replies)?;
                continue;
            }
            let open = if fresh { 1 } else { ahead.min(rest.len()) };
            let (asked, last) = (&rest[..open], rest.len() == open);
            let Conversation {
                answers,
                end,
                leftover,
            } = self.converse(asked, last)?;
            match end {
                Some(End::TooMany) if fresh => replies.push(Reply::too_many(answers)),
                // Which of its questions has two answers?
                Some(End::TooMany) => {
                    let reached = replies.len() + open;
                    replies.truncate(since);
                    self.ask_apart(&questions[replies.len()..reached], &mut replies)?;
                }
                // Which of them are answered?
                _ if answers.len() < open && open > 1 => ahead = 1,
                _ if !answers.is_empty() => replies.extend(answers.into_iter().map(Reply::of)),
                Some(end @ (End::TimedOut(_) | End::Flooded(_) | End::Over(_))) => {
                    replies.push(Reply::none(self.silence(end), leftover));
                }
                Some(end) if fresh => replies.push(Reply::none(self.silence(end), leftover)),
                // It may have died of an earlier question, or of too many.
                _ => self.ask_apart(asked, &mut replies)?,
            }
        }
        Ok(replies)
    }

    /// The questions without a reply; `None` where there are none, or no more are to be asked: then each has that as its reply.
    fn still_to_ask<'q>(
        &mut self,
        questions: &'q [String],
        replies: &mut Vec<Reply>,
    ) -> Option<&'q [String]> {
        let why = self.stops(replies);
        if let Some(said) = why {
            replies.resize_with(questions.len(), || {
                Reply::none(said.clone(), Prints::default())
            });
        }
        questions
            .get(replies.len()..)
            .filter(|rest| !rest.is_empty())
    }

    /// Why no more is asked, if so.
    fn stops(&mut self, replies: &[Reply]) -> Option<Said> {
        let over = self.budget.over(Duration::ZERO, 0).map(Said::Over);
        let waits = self.waits - self.waits_before;
        let hangs = || (waits >= WAITS).then_some(Said::NotAsked(WAITS as usize));
        let silent = || ends_silent(replies).then_some(Said::NotAsked(SILENT));
        over.or_else(silent).or_else(hangs)
    }

    /// What the next answers may use, and the time for the program's start.
    fn limits(&self) -> (Limits, Duration) {
        let part = 1 << self.waits.min(HALVED);
        let limits = Limits {
            time: self.limits.time / part,
            ..self.limits
        };
        let start = if self.has_answered {
            self.start
        } else {
            self.start / part
        };
        (limits, start)
    }

    /// Why a program that ended like this gave no answer.
    fn silence(&self, end: End) -> Said {
        silence(end, self.limits.time)
    }

    /// Counts a wait in vain for one question. Of several, those without an answer are asked again, and have all of their time. Who has
    /// answered and does not end at once, as on a busy machine, was not waited for in vain.
    fn note(&mut self, questions: &[String], heard: &Conversation) {
        let in_vain = matches!(heard.end, Some(End::TimedOut(_))) && heard.answers.is_empty();
        self.waits += u32::from(in_vain && questions.len() == 1);
    }

    /// Sends questions to the process that runs, or a new one, and returns what it says until it has answered them, or ended.
    fn converse(&mut self, questions: &[String], last: bool) -> io::Result<Conversation> {
        let mut process = match self.process.take() {
            Some(process) => process,
            None => Process::start(self.program)?,
        };
        let (limits, grace) = self.limits();
        let waits = Waits {
            patience: Some(self.patience),
            start: grace,
            // A second answer comes at once, or it is seen at the end of the list.
            breath: if last { BREATH } else { Duration::ZERO },
        };
        let (starts, start) = (!process.has_answered, Instant::now());
        let heard = process.converse(questions, &limits, waits, &mut self.budget);
        self.note(questions, &heard);
        if starts && process.has_answered {
            self.start = self.start.min(2 * start.elapsed());
        }
        match &heard.end {
            None => {
                self.manner = Manner::Prompt;
                self.process = Some(process);
            }
            Some(End::TooMany) => {}
            Some(_) if self.manner == Manner::Unknown && !heard.answers.is_empty() => {
                self.manner = Manner::AtTheEnd;
            }
            Some(end) if end.is_quiet() && heard.answers.len() < questions.len() => {
                self.patience = self.limits.time / 40; // it ignores what it does not know: no use in waiting
            }
            Some(_) => {}
        }
        Ok(heard)
    }

    /// Asks questions in a process of their own, which is told at once that these are all, so that every answer is one to them.
    /// If there are not as many answers as questions, they are asked again in parts. The replies stop where no more is asked.
    ///
    /// # Errors
    /// If the program cannot be started.
    pub(crate) fn ask_apart(
        &mut self,
        questions: &[String],
        replies: &mut Vec<Reply>,
    ) -> io::Result<()> {
        let (limits, start) = self.limits();
        let waits = Waits {
            patience: None,
            start,
            breath: Duration::ZERO,
        };
        let mut process = Process::start(self.program)?;
        let heard = process.converse(questions, &limits, waits, &mut self.budget);
        self.note(questions, &heard);
        let Conversation {
            answers,
            end,
            leftover,
        } = heard;
        if end == Some(End::TooMany) && questions.len() == 1 {
            replies.push(Reply::too_many(answers));
        } else if end != Some(End::TooMany) && answers.len() == questions.len() {
            replies.extend(answers.into_iter().map(Reply::of));
        } else if let [_] = questions {
            let said = end.map_or_else(|| Said::Ended(String::new()), |end| self.silence(end));
            replies.push(Reply::none(said, leftover));
        } else {
            for part in questions.chunks(questions.len().div_ceil(PARTS)) {
                if self.stops(replies).is_none() {
                    self.ask_apart(part, replies)?;
                }
            }
        }
        Ok(())
    }
}

/// Asks a program all the questions, whatever happens, and returns a reply to each: [`Asker::ask`] for one list.
///
/// # Errors
/// If the program cannot be started.
pub fn ask(program: &Program, questions: &[String], limits: Limits) -> io::Result<Vec<Reply>> {
    Asker::new(program, limits).ask(questions)
}

/// Whether there is no answer among the last replies.
fn ends_silent(replies: &[Reply]) -> bool {
    let last = replies.len().checked_sub(SILENT);
    last.is_some_and(|first| replies[first..].iter().all(|reply| !reply.said.is_line()))
}

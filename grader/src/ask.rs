//! Asking an answer program: any program, which may crash, hang, flood or lie.

use crate::contain;
use crate::converse::{Conversation, End, Limits, Process, Program, converse};
use std::io;
use std::process::ExitStatus;
use std::time::Duration;

/// What came back for one question.
#[derive(Clone, Debug, PartialEq)]
pub struct Reply {
    /// The answer, or why there is none.
    pub said: Said,
    /// What else the program printed before it.
    pub printed: String,
}

/// An answer, or why there is none.
#[derive(Clone, Debug, PartialEq)]
pub enum Said {
    /// An answer, as its words.
    Answer(String),
    /// This function is not written yet.
    Todo(String),
    /// The student's function panicked, with this message; the program went on.
    Panicked(String),
    /// The program could not read the question.
    Refused(String),
    /// The program ended without an answer.
    Ended(String),
    /// No answer came in this time.
    TimedOut(Duration),
    /// So many bytes were printed without an answer.
    Flooded(usize),
    /// So many answers were given to the one question.
    TooMany(usize),
    /// It was not asked: there was no answer to so many questions before it.
    NotAsked(usize),
}

impl Said {
    /// Why there is no answer, in words to whoever wrote the program; `None` if there is one.
    pub fn why_none(&self) -> Option<String> {
        Some(match self {
            Self::Answer(_) => return None,
            Self::Todo(name) if name.is_empty() => "it is not written yet".to_owned(),
            Self::Todo(name) => format!("{name} is not written yet"),
            Self::Panicked(message) => format!("your function panicked: {message}"),
            Self::Refused(why) => format!("your program could not read the question: {why}"),
            Self::Ended(how) => format!("your program ended without an answer: {how}"),
            Self::TimedOut(limit) => format!(
                "no answer within {} s: does a loop never end? (--time-limit gives more time)",
                limit.as_secs_f32()
            ),
            Self::Flooded(bytes) => format!("your program printed {bytes} bytes and no answer"),
            Self::TooMany(answers) => {
                format!("your program gave {answers} answers to one question")
            }
            Self::NotAsked(questions) => {
                format!("not asked, since there was no answer to {questions} questions in a row")
            }
        })
    }

    /// Whether the program had to be started again after it.
    fn cost_a_process(&self) -> bool {
        !matches!(
            self,
            Self::Answer(_) | Self::Todo(_) | Self::Panicked(_) | Self::Refused(_)
        )
    }
}

/// So many times a program may end early; from then on it is asked one question at a time, which blames the right one at once.
const PATIENCE: usize = 3;

/// After so many questions in a row without an answer the rest is not asked: seconds instead of minutes, for a program that
/// does not know the exercise, or hangs.
const SILENT: usize = 5;

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
/// crashed, or broke a limit. A program that holds its answers back is started for each list of questions.
pub struct Asker<'a> {
    program: &'a Program,
    limits: Limits,
    manner: Manner,
    /// How long to wait for an answer until the program is told that there are no more questions.
    patience: Duration,
    process: Option<Process>,
}

impl<'a> Asker<'a> {
    /// Nothing is started yet.
    pub fn new(program: &'a Program, limits: Limits) -> Self {
        Self {
            program,
            limits,
            manner: Manner::Unknown,
            patience: limits.time / 2,
            process: None,
        }
    }

    /// The same, for a program whose answers cannot be told apart otherwise: with a process for each list of questions.
    pub fn apart(program: &'a Program, limits: Limits) -> Self {
        Self {
            manner: Manner::AtTheEnd,
            ..Self::new(program, limits)
        }
    }

    /// Asks all the questions, whatever happens, and returns a reply to each.
    ///
    /// All are sent at once, so a program that does not flush its output is answered for too. When it ends early, the
    /// question it had reached is to blame; of a program that may have held answers back, it is asked again alone. The
    /// others go to a new process. After five questions in a row without an answer the rest is not asked.
    ///
    /// # Errors
    /// If the program cannot be started.
    pub fn ask(&mut self, questions: &[String]) -> io::Result<Vec<Reply>> {
        let mut replies = Vec::new();
        let mut misfortunes = 0;
        // Whether the process has been asked another list of questions.
        let mut used = self.process.is_some();
        while replies.len() < questions.len() {
            if ends_silent(&replies) {
                replies.resize_with(questions.len(), || Reply {
                    said: Said::NotAsked(SILENT),
                    printed: String::new(),
                });
                break;
            }
            let rest = &questions[replies.len()..];
            if misfortunes >= PATIENCE {
                replies.push(self.ask_alone(&rest[..1])?);
                continue;
            }
            // The first question of all shows the program's manner.
            let together = if self.manner == Manner::Unknown {
                1
            } else {
                rest.len()
            };
            let Conversation {
                answers,
                end,
                leftover,
            } = self.converse(&rest[..together])?;
            let missing = answers.len() < together;
            let quiet = end.as_ref().is_some_and(End::is_quiet);
            if answers.len() > together || (missing && together > 1 && quiet) {
                misfortunes = PATIENCE; // which one has two answers, or none? ask them one by one
                continue;
            }
            if missing && std::mem::take(&mut used) && answers.is_empty() {
                continue; // it may have died of a question before these, so these go to a new process
            }
            replies.extend(answers.into_iter().map(Reply::of));
            let Some(end) = end.filter(|_| missing) else {
                continue;
            };
            if together == 1 || self.manner == Manner::Prompt {
                replies.push(Reply {
                    said: silence(end),
                    printed: leftover,
                });
            } else {
                misfortunes += 1;
                let reached = replies.len();
                replies.push(self.ask_alone(&questions[reached..=reached])?);
            }
        }
        Ok(replies)
    }

    /// Sends all the questions at once, and returns what the program says until it has answered them, or ended.
    ///
    /// # Errors
    /// If the program cannot be started.
    pub fn converse(&mut self, questions: &[String]) -> io::Result<Conversation> {
        let mut process = match self.process.take() {
            Some(process) => process,
            None => Process::start(self.program)?,
        };
        let patience = (self.manner != Manner::AtTheEnd).then_some(self.patience);
        let heard = process.converse(questions, self.limits, patience);
        match &heard.end {
            None => {
                self.manner = Manner::Prompt;
                self.process = Some(process);
            }
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

    /// Asks one question in a process of its own.
    fn ask_alone(&mut self, question: &[String]) -> io::Result<Reply> {
        self.process = None;
        let mut heard = converse(self.program, question, self.limits)?;
        Ok(match (heard.answers.len(), heard.end) {
            (0, end) => Reply {
                said: end.map_or_else(|| Said::Ended(String::new()), silence),
                printed: heard.leftover,
            },
            (1, _) => Reply::of(heard.answers.swap_remove(0)),
            (answers, _) => Reply {
                said: Said::TooMany(answers),
                printed: heard.answers.swap_remove(0).1,
            },
        })
    }

    /// Asks no more: whether the program gave more answers than it was asked questions, so that none can be relied on.
    pub fn finish(mut self) -> bool {
        let process = self.process.take();
        process.is_some_and(|process| process.says_more(self.limits))
    }
}

impl Reply {
    /// An answer line without its `= `, and what was printed before it.
    fn of((answer, printed): (String, String)) -> Self {
        Self {
            said: understand(&answer),
            printed,
        }
    }
}

/// Asks a program all the questions, whatever happens, and returns a reply to each: [`Asker::ask`] for one list.
///
/// # Errors
/// If the program cannot be started.
pub fn ask(program: &Program, questions: &[String], limits: Limits) -> io::Result<Vec<Reply>> {
    Asker::new(program, limits).ask(questions)
}

/// Whether the last replies, as many as are borne, are no answers.
fn ends_silent(replies: &[Reply]) -> bool {
    let last = replies.len().checked_sub(SILENT);
    last.is_some_and(|first| {
        replies[first..]
            .iter()
            .all(|reply| reply.said.cost_a_process())
    })
}

/// An answer line without its `= `.
pub fn understand(answer: &str) -> Said {
    let (first, rest) = answer.split_once(' ').unwrap_or((answer, ""));
    let rest = rest.trim().to_owned();
    match first {
        "todo" => Said::Todo(rest),
        "panic" => Said::Panicked(rest),
        "error" => Said::Refused(rest),
        _ => Said::Answer(answer.to_owned()),
    }
}

/// Why a program that ended like this gave no answer.
pub fn silence(end: End) -> Said {
    match end {
        End::Exited(status) => Said::Ended(status.map_or_else(String::new, describe)),
        End::TimedOut(limit) => Said::TimedOut(limit),
        End::Flooded(bytes) => Said::Flooded(bytes),
        End::TooMany => Said::TooMany(2),
    }
}

/// An exit status in words.
fn describe(status: ExitStatus) -> String {
    status.code().map_or_else(
        || contain::signal_name(status),
        |code| format!("exit code {code}"),
    )
}

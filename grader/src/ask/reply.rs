//! What came back for a question: an answer, or why there is none.

use crate::budget::Over;
use crate::contain;
use crate::converse::{End, Prints};
use raybook_chapters::kit::untrusted::Untrusted;
use std::fmt::{self, Display, Formatter};
use std::process::ExitStatus;
use std::time::Duration;

/// What came back for one question.
#[derive(Clone, Debug, PartialEq)]
pub struct Reply {
    /// The answer, or why there is none.
    pub said: Said,
    /// What else the program printed before it.
    pub printed: Prints,
}

/// An answer, or why there is none.
#[derive(Clone, Debug, PartialEq)]
pub enum Said {
    /// An answer, as its words.
    Answer(Untrusted),
    /// This function is not written yet.
    Todo(Untrusted),
    /// The student's function panicked, with this message; the program went on.
    Panicked(Untrusted),
    /// The program could not read the question.
    Refused(Untrusted),
    /// The program ended without an answer.
    Ended(String),
    /// No answer came in time.
    TimedOut(Waited),
    /// This number of bytes was printed without an answer.
    Flooded(usize),
    /// This number of answers was given to the one question.
    TooMany(usize),
    /// It was not asked: there was no answer to this number of questions before it.
    NotAsked(usize),
    /// It was not asked or not waited for: a total limit is used up.
    Over(Over),
}

/// How long an answer was waited for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Waited {
    /// The time for this answer.
    pub time: Duration,
    /// The time for an answer as long as none was waited for in vain.
    pub at_first: Duration,
}

impl Said {
    /// Why there is no answer, in words to whoever wrote the program; `None` if there is one.
    pub fn why_none(&self) -> Option<String> {
        Some(match self {
            Self::Answer(_) => return None,
            Self::Todo(name) if name.unescaped().is_empty() => "it is not written yet".to_owned(),
            Self::Todo(name) => format!("{name} is not written yet"),
            Self::Panicked(message) => format!("your function stopped with an error: {message}"),
            Self::Refused(why) => format!("your program could not read the question: {why}"),
            Self::Ended(how) => format!("your program ended without an answer: {how}"),
            Self::TimedOut(waited) => format!("no answer within {waited}: does a loop never end?"),
            Self::Flooded(bytes) => format!("your program printed {bytes} bytes and no answer"),
            Self::TooMany(answers) => {
                format!("your program gave {answers} answers to one question")
            }
            Self::NotAsked(questions) => {
                format!("not asked, since there was no answer to {questions} questions")
            }
            Self::Over(over) => over.why(),
        })
    }

    /// What whoever checks their own program can do about it, in brackets after the reason; in a class the course sets the limits.
    pub fn help(&self) -> &'static str {
        match self {
            Self::TimedOut(_) => " (--time-limit gives more time)",
            Self::Over(over) => over.help(),
            _ => "",
        }
    }

    /// Whether it was not asked.
    pub(crate) fn is_left_out(&self) -> bool {
        matches!(self, Self::NotAsked(_) | Self::Over(_))
    }

    /// Whether it is a line that the program wrote.
    pub fn is_line(&self) -> bool {
        matches!(
            self,
            Self::Answer(_) | Self::Todo(_) | Self::Panicked(_) | Self::Refused(_)
        )
    }
}

impl Display for Waited {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let [time, at_first] = [self.time, self.at_first].map(|time| time.as_secs_f32());
        write!(f, "{time} s")?;
        if time < at_first {
            write!(
                f,
                " (at first it was {at_first} s; the time is shortened after each question without an answer)"
            )?;
        }
        Ok(())
    }
}

impl Reply {
    /// An answer line without its `= `, and what was printed before it.
    pub(super) fn of((answer, printed): (Untrusted, Prints)) -> Self {
        Self {
            said: understand(answer),
            printed,
        }
    }

    /// No answer.
    pub(super) fn none(said: Said, printed: Prints) -> Self {
        Self { said, printed }
    }

    /// More answers than one.
    pub(super) fn too_many(answers: Vec<(Untrusted, Prints)>) -> Self {
        let said = Said::TooMany(answers.len());
        let first = answers.into_iter().next();
        Self::none(
            said,
            first.map_or_else(Prints::default, |(_, printed)| printed),
        )
    }
}

/// An answer line without its `= `.
fn understand(answer: Untrusted) -> Said {
    let text = answer.unescaped();
    let (first, rest) = text.split_once(' ').unwrap_or((text, ""));
    let rest = || rest.trim().into();
    match first {
        "todo" => Said::Todo(rest()),
        "panic" => Said::Panicked(rest()),
        "error" => Said::Refused(rest()),
        _ => Said::Answer(answer),
    }
}

/// Why a program that ended like this gave no answer, for which it has had this time at first.
pub(super) fn silence(end: End, at_first: Duration) -> Said {
    match end {
        End::Exited(status) => Said::Ended(status.map_or_else(String::new, describe)),
        End::TimedOut(time) => Said::TimedOut(Waited { time, at_first }),
        End::Flooded(bytes) => Said::Flooded(bytes),
        End::TooMany => Said::TooMany(2),
        End::Over(over) => Said::Over(over),
    }
}

/// An exit status in words.
fn describe(status: ExitStatus) -> String {
    status.code().map_or_else(
        || contain::signal_name(status),
        |code| format!("exit code {code}"),
    )
}

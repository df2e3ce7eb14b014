//! Asking an answer program: any program, which may crash, hang, flood or lie.

use crate::converse::{Conversation, End, Limits, Program, converse};
use std::io;
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

/// Asks all the questions, whatever happens, and returns a reply to each.
///
/// All are sent at once, so a program that does not flush its output is answered for too. When it ends early, the
/// question it had reached is asked again alone, to blame the right one, and the others go to a new process. After five
/// questions in a row without an answer the rest is not asked.
///
/// # Errors
/// If the program cannot be started.
pub fn ask(program: &Program, questions: &[String], limits: Limits) -> io::Result<Vec<Reply>> {
    let mut replies = Vec::new();
    let mut misfortunes = 0;
    while replies.len() < questions.len() {
        if ends_silent(&replies) {
            replies.resize_with(questions.len(), || Reply {
                said: Said::NotAsked(SILENT),
                printed: String::new(),
            });
            break;
        }
        let rest = &questions[replies.len()..];
        let together = if misfortunes < PATIENCE {
            rest.len()
        } else {
            1
        };
        let Conversation {
            mut answers,
            end,
            leftover,
        } = converse(program, &rest[..together], limits)?;
        if answers.len() > together {
            if together == 1 {
                let printed = answers.swap_remove(0).1;
                replies.push(Reply {
                    said: Said::TooMany(answers.len() + 1),
                    printed,
                });
            } else {
                misfortunes = PATIENCE; // who said too much? ask them one by one
            }
            continue;
        }
        let complete = answers.len() == together;
        replies.extend(answers.into_iter().map(|(answer, printed)| Reply {
            said: understand(&answer),
            printed,
        }));
        if complete {
            continue;
        }
        let (said, printed) = (silence(end), leftover);
        if together == 1 {
            replies.push(Reply { said, printed });
        } else {
            let alone = ask(program, &questions[replies.len()..=replies.len()], limits)?;
            misfortunes += 1;
            replies.extend(alone);
        }
    }
    Ok(replies)
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
        End::Exited(how) => Said::Ended(how),
        End::TimedOut(limit) => Said::TimedOut(limit),
        End::Flooded(bytes) => Said::Flooded(bytes),
        End::TooMany => Said::TooMany(2),
    }
}

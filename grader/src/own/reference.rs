//! The instructor's program: it answers questions as a hand-in does, and judges answers if an exercise says so.

use crate::Verdict;
use crate::ask::{Asker, Said};
use crate::budget::Total;
use crate::converse::{Limits, Program};
use crate::mutex::lock;
use raybook_chapters::kit::untrusted::Untrusted;
use std::collections::HashMap;
use std::path::Path;
use std::sync::{Mutex, MutexGuard};
use std::thread::{self, ThreadId};
use std::time::Duration;

/// Time for one answer.
const TIME: Duration = Duration::from_secs(10);

/// The word after an exercise's name that asks for a verdict: `lens_power.judge`.
const JUDGE: &str = ".judge";

/// A program that knows the answers. It is the instructor's own, and runs with all their rights.
pub(super) struct Reference {
    asker: Mutex<Asker<'static>>,
    /// Why there was no verdict, for each thread: a thread grades one hand-in at a time.
    troubles: Mutex<HashMap<ThreadId, String>>,
    /// Its command, to be shown.
    command: String,
}

impl Reference {
    /// The program of a command, which is run in a folder, once it is asked something. A first word that names a file of the folder
    /// is that file.
    ///
    /// # Errors
    /// If there is no word, or the folder is not known.
    pub fn new(folder: &Path, command: &[&str]) -> Result<Self, String> {
        let Some((first, rest)) = command.split_first() else {
            return Err(
                "which program answers? `program = [\"python3\", \"answers.py\"]`".to_owned(),
            );
        };
        let folder = folder
            .canonicalize()
            .map_err(|error| format!("{}: {error}", Untrusted::from(folder)))?;
        let file = folder.join(first);
        let program = Program {
            file: if file.is_file() { file } else { first.into() },
            arguments: rest.iter().map(Into::into).collect(),
            folder,
            sandbox: None,
        };
        let mut limits = Limits::of(TIME);
        limits.check = Total {
            time: Duration::from_secs(u64::from(u32::MAX)),
            bytes: usize::MAX,
        };
        let program: &'static Program = Box::leak(Box::new(program));
        Ok(Self {
            asker: Mutex::new(Asker::new(program, limits)),
            troubles: Mutex::default(),
            command: command.join(" "),
        })
    }

    /// The right answer to a question of an exercise, as its words.
    ///
    /// # Errors
    /// Why there is none.
    pub fn answer(&self, exercise: &str, question: &str) -> Result<String, String> {
        self.ask(&format!("{exercise} {question}"))
    }

    /// Its verdict on the answer `got`, where `golden` is right: `right`, or anything else, which says why not.
    ///
    /// # Errors
    /// Why the answer is wrong, or that there is no verdict.
    pub fn judge(&self, exercise: &str, [question, golden, got]: [&str; 3]) -> Verdict {
        // What fails once is not tried with all other answers of the hand-in: they are asked again anyway.
        if let Some(why) = self.troubles().get(&thread::current().id()) {
            return Err(why.clone());
        }
        let line = format!("{exercise}{JUDGE} {question}  {golden}  {got}");
        let said = self.ask(&line).inspect_err(|why| {
            self.troubles().insert(thread::current().id(), why.clone());
        })?;
        let said = said.trim();
        if said == "right" {
            return Ok(());
        }
        let why = said.strip_prefix("wrong").unwrap_or(said);
        let why = why.trim_start_matches(':').trim();
        Err(if why.is_empty() { "it is wrong" } else { why }.to_owned())
    }

    /// Why an answer that this thread graded has no verdict, if so; told once.
    pub fn trouble(&self) -> Option<String> {
        self.troubles().remove(&thread::current().id())
    }

    fn troubles(&self) -> MutexGuard<'_, HashMap<ThreadId, String>> {
        lock(&self.troubles)
    }

    fn ask(&self, line: &str) -> Result<String, String> {
        let mut asker = lock(&self.asker);
        asker.next_exercise();
        let replies = asker.ask(&[line.to_owned()]);
        let command = Untrusted::from(self.command.as_str());
        let replies = replies.map_err(|error| format!("`{command}` cannot be run: {error}"))?;
        let Some(reply) = replies.first() else {
            return Err(format!("`{command}` was not asked"));
        };
        match &reply.said {
            Said::Answer(answer) => Ok(answer.unescaped().to_owned()),
            other => Err(format!(
                "`{command}` has no answer to `{}`: {}\n{}",
                Untrusted::from(line),
                other.why_none().unwrap_or_default(),
                reply.printed.stderr
            )),
        }
    }
}

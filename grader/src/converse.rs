//! A process of an answer program: questions in, answers and prints out, within limits.

use crate::contain::{self, Held};
use std::ffi::OsString;
use std::io::{self, BufRead, BufReader, PipeReader, Read, Write};
use std::path::PathBuf;
use std::process::{Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel, sync_channel};
use std::thread;
use std::time::{Duration, Instant};

/// How to start an answer program.
#[derive(Clone, Debug)]
pub struct Program {
    /// The file.
    pub file: PathBuf,
    /// Its arguments.
    pub arguments: Vec<OsString>,
    /// The folder it runs in; the present one if empty.
    pub folder: PathBuf,
}

/// What a program may use for one answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Time until the next answer.
    pub time: Duration,
    /// Bytes printed until the next answer.
    pub output: usize,
}

impl Default for Limits {
    /// Two seconds, a thousand times what an answer takes in any language; and a megabyte, more than anyone reads.
    fn default() -> Self {
        Self {
            time: Duration::from_secs(2),
            output: 1 << 20,
        }
    }
}

/// What a process said to some questions.
#[derive(Clone, Debug)]
pub struct Conversation {
    /// Each answer line without its `= `, and what was printed before it.
    pub answers: Vec<(String, String)>,
    /// How it ended; `None` if everything is answered, and more can be asked.
    pub end: Option<End>,
    /// What was printed after the last answer.
    pub leftover: String,
}

/// How a process ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// By itself; with its exit code or signal, where the system tells.
    Exited(Option<ExitStatus>),
    /// Stopped, because no answer came in this time.
    TimedOut(Duration),
    /// Stopped, because it printed so many bytes without an answer.
    Flooded(usize),
    /// Stopped, because it gave more answers than it was asked questions.
    TooMany,
}

impl End {
    /// Whether the program ended by itself and as if everything was done.
    pub fn is_quiet(&self) -> bool {
        matches!(self, Self::Exited(Some(status)) if status.success())
    }
}

/// A line longer than this is cut. The longest answers that are asked for are 4096 points, 100 kB.
const LONGEST_LINE: u64 = 1 << 18;

/// So many lines wait at the most until they are read.
const WAITING: usize = 64;

/// So much of what was printed for a question is kept.
const KEPT: usize = 1 << 12;

/// A program that gives a second answer to a question mostly does so within this time.
const BREATH: Duration = Duration::from_millis(1);

/// A running answer program. Nothing of it is left when it is dropped.
pub struct Process {
    held: Option<Held>,
    /// To the thread that writes the questions; none when no more will be asked.
    questions: Option<Sender<String>>,
    lines: Receiver<(String, bool)>,
}

impl Process {
    /// Starts the program.
    ///
    /// # Errors
    /// If it cannot be started.
    pub fn start(program: &Program) -> io::Result<Self> {
        let (output, input) = io::pipe()?;
        let mut command = Command::new(&program.file);
        // Prints to both outputs come in the order in which they were made.
        command
            .args(&program.arguments)
            .env("PYTHONUNBUFFERED", "1") // else Python holds its answers back until the questions end
            .stdin(Stdio::piped())
            .stdout(input.try_clone()?)
            .stderr(input);
        if !program.folder.as_os_str().is_empty() {
            command.current_dir(&program.folder);
        }
        let mut held =
            contain::start(&mut command).map_err(|error| cannot_start(program, &error))?;
        drop(command); // it holds the pipe's other end
        let (questions, to_write) = channel::<String>();
        if let Some(mut stdin) = held.child.stdin.take() {
            // A program that ends early does not read it all, and that is its business.
            thread::spawn(move || {
                to_write
                    .iter()
                    .try_for_each(|text| stdin.write_all(text.as_bytes()))
            });
        }
        Ok(Self {
            held: Some(held),
            questions: Some(questions),
            lines: read_lines(output),
        })
    }

    /// Sends the questions, all at once, and listens until they are answered, or the program ends or breaks a limit.
    ///
    /// If no answer comes for the time of `patience`, the program is told that there are no more questions: then one that
    /// holds its answers back gives them, and one that ignored a question ends. Without `patience` it is told so at once.
    pub fn converse(
        &mut self,
        questions: &[String],
        limits: Limits,
        patience: Option<Duration>,
    ) -> Conversation {
        let text: String = questions
            .iter()
            .flat_map(|question| [question, "\n"])
            .collect();
        if let Some(writer) = &self.questions {
            // The writer has gone where the program has ended, which is heard below.
            let _ = writer.send(text);
        }
        let mut conversation = self.listen(questions.len(), limits, patience);
        if let Some(end) = &mut conversation.end
            && let Some(held) = self.held.take()
        {
            self.questions = None;
            let status = held.end(matches!(end, End::Exited(_)), limits.time);
            if let End::Exited(how) = end {
                *how = status;
            }
        }
        conversation
    }

    /// Says that there are no more questions, and waits for the end: whether there came an answer that nobody asked for.
    pub fn says_more(mut self, limits: Limits) -> bool {
        let heard = self.converse(&[], limits, None);
        !heard.answers.is_empty()
    }

    fn listen(
        &mut self,
        wanted: usize,
        limits: Limits,
        patience: Option<Duration>,
    ) -> Conversation {
        let (mut answers, mut printed, mut bytes) = (Vec::new(), String::new(), 0);
        let mut heard = Instant::now();
        let end = loop {
            let hurry = patience.filter(|_| self.questions.is_some());
            if hurry.is_none() {
                self.questions = None;
            }
            let complete = answers.len() == wanted;
            let wait = match hurry {
                Some(_) if complete => BREATH,
                Some(patience) => patience.min(limits.time),
                None => limits.time,
            };
            let deadline = heard + wait;
            match self
                .lines
                .recv_timeout(deadline.saturating_duration_since(Instant::now()))
            {
                Ok((line, true)) if line.starts_with("= ") => {
                    answers.push((line[2..].trim().to_owned(), std::mem::take(&mut printed)));
                    if answers.len() > wanted {
                        break Some(End::TooMany);
                    }
                    bytes = 0;
                    heard = Instant::now();
                }
                Ok((line, whole)) => {
                    bytes += line.len() + 1;
                    if printed.len() < KEPT {
                        printed.push_str(&line);
                        printed.push_str(if whole { "\n" } else { "" });
                    }
                    if bytes > limits.output {
                        break Some(End::Flooded(bytes));
                    }
                }
                Err(RecvTimeoutError::Timeout) if hurry.is_some() && complete => break None,
                Err(RecvTimeoutError::Timeout) if hurry.is_some() => self.questions = None,
                Err(RecvTimeoutError::Timeout) => break Some(End::TimedOut(limits.time)),
                Err(RecvTimeoutError::Disconnected) => break Some(End::Exited(None)),
            }
        };
        Conversation {
            answers,
            end,
            leftover: printed,
        }
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        if let Some(held) = self.held.take() {
            held.end(false, Duration::ZERO);
        }
    }
}

/// Starts the program, sends it all the questions, and listens until it ends or breaks a limit; nothing of it is left.
///
/// # Errors
/// If the program cannot be started.
pub fn converse(
    program: &Program,
    questions: &[String],
    limits: Limits,
) -> io::Result<Conversation> {
    Ok(Process::start(program)?.converse(questions, limits, None))
}

/// Why a program does not start, and what to do about it.
fn cannot_start(program: &Program, error: &io::Error) -> io::Error {
    let file = program.file.display();
    let advice = match error.kind() {
        io::ErrorKind::PermissionDenied => format!("; is it executable? chmod +x {file}"),
        io::ErrorKind::NotFound if program.file.exists() => {
            "; the file is there: is the program that its first line names after `#!`?".to_owned()
        }
        _ => String::new(),
    };
    io::Error::new(
        error.kind(),
        format!("{file}: cannot be run: {error}{advice}"),
    )
}

/// Lines of output as they come, with whether each was whole.
fn read_lines(output: PipeReader) -> Receiver<(String, bool)> {
    let (sender, receiver) = sync_channel(WAITING);
    thread::spawn(move || {
        let mut reader = BufReader::new(output);
        loop {
            let mut bytes = Vec::new();
            let read = (&mut reader)
                .take(LONGEST_LINE)
                .read_until(b'\n', &mut bytes);
            let whole = bytes.last() == Some(&b'\n');
            let line = String::from_utf8_lossy(&bytes)
                .trim_end_matches(['\n', '\r'])
                .to_owned();
            if !matches!(read, Ok(n) if n > 0) || sender.send((line, whole)).is_err() {
                return;
            }
        }
    });
    receiver
}

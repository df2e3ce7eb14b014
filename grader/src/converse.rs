//! One process of an answer program: questions in, answers and prints out, within limits.

use crate::contain;
use std::ffi::OsString;
use std::io::{self, BufRead, BufReader, PipeReader, Read, Write};
use std::path::PathBuf;
use std::process::{Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, sync_channel};
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

/// What one process did.
#[derive(Clone, Debug)]
pub struct Conversation {
    /// Each answer line without its `= `, and what was printed before it.
    pub answers: Vec<(String, String)>,
    /// How it ended.
    pub end: End,
    /// What was printed after the last answer.
    pub leftover: String,
}

/// How a process ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum End {
    /// By itself; with its exit code or signal in words.
    Exited(String),
    /// Stopped, because no answer came in this time.
    TimedOut(Duration),
    /// Stopped, because it printed so many bytes without an answer.
    Flooded(usize),
    /// Stopped, because it gave more answers than it was asked questions.
    TooMany,
}

/// A line longer than this is cut. The longest answers that are asked for are 4096 points, 100 kB.
const LONGEST_LINE: u64 = 1 << 18;

/// So many lines wait at the most until they are read.
const WAITING: usize = 64;

/// So much of what was printed for a question is kept.
const KEPT: usize = 1 << 12;

/// Starts the program, sends it all the questions, and listens until it ends or breaks a limit; nothing of it is left.
///
/// # Errors
/// If the program cannot be started.
pub fn converse(
    program: &Program,
    questions: &[String],
    limits: Limits,
) -> io::Result<Conversation> {
    let (output, input) = io::pipe()?;
    let mut command = Command::new(&program.file);
    // Prints to both outputs come in the order in which they were made.
    command
        .args(&program.arguments)
        .stdin(Stdio::piped())
        .stdout(input.try_clone()?)
        .stderr(input);
    if !program.folder.as_os_str().is_empty() {
        command.current_dir(&program.folder);
    }
    let mut held = contain::start(&mut command).map_err(|error| cannot_start(program, &error))?;
    drop(command); // it holds the pipe's other end
    if let Some(mut stdin) = held.child.stdin.take() {
        let text: String = questions
            .iter()
            .flat_map(|question| [question, "\n"])
            .collect();
        // A program that ends early does not read it all, and that is its business.
        thread::spawn(move || stdin.write_all(text.as_bytes()));
    }
    let lines = read_lines(output);
    let mut conversation = listen(&lines, questions.len(), limits);
    let by_itself = matches!(conversation.end, End::Exited(_));
    let status = held.end(by_itself, limits.time);
    if let (End::Exited(how), Some(status)) = (&mut conversation.end, status) {
        *how = describe(status);
    }
    Ok(conversation)
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

fn listen(lines: &Receiver<(String, bool)>, wanted: usize, limits: Limits) -> Conversation {
    let (mut answers, mut printed, mut bytes) = (Vec::new(), String::new(), 0);
    let mut deadline = Instant::now() + limits.time;
    let end = loop {
        match lines.recv_timeout(deadline.saturating_duration_since(Instant::now())) {
            Ok((line, true)) if line.starts_with("= ") => {
                answers.push((line[2..].trim().to_owned(), std::mem::take(&mut printed)));
                if answers.len() > wanted {
                    break End::TooMany;
                }
                bytes = 0;
                deadline = Instant::now() + limits.time;
            }
            Ok((line, whole)) => {
                bytes += line.len() + 1;
                if printed.len() < KEPT {
                    printed.push_str(&line);
                    printed.push_str(if whole { "\n" } else { "" });
                }
                if bytes > limits.output {
                    break End::Flooded(bytes);
                }
            }
            Err(RecvTimeoutError::Timeout) => break End::TimedOut(limits.time),
            Err(RecvTimeoutError::Disconnected) => break End::Exited(String::new()),
        }
    };
    Conversation {
        answers,
        end,
        leftover: printed,
    }
}

/// An exit status in words.
fn describe(status: ExitStatus) -> String {
    status.code().map_or_else(
        || contain::signal_name(status),
        |code| format!("exit code {code}"),
    )
}

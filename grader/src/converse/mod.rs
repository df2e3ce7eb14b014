//! A process of an answer program: questions in, answers and prints out, within limits.

mod limits;
mod listening;
mod prints;
mod program;

use crate::budget::{Budget, Over};
use crate::clock::Clock;
use crate::contain::{self, Held};
use crate::listen::{Event, listen};
use crate::suspend::now;
use listening::Listening;
use prints::Printed;
use program::cannot_start;
use raybook_chapters::kit::untrusted::Untrusted;
use std::collections::VecDeque;
use std::io::{self, Write};
use std::process::{ChildStdin, Command, ExitStatus, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::{Duration, Instant};

pub use limits::Limits;
pub use prints::Prints;
pub use program::Program;

/// What a process said to some questions.
#[derive(Clone, Debug)]
pub(crate) struct Conversation {
    /// Each answer line without its `= `, and what was printed before it.
    pub(crate) answers: Vec<(Untrusted, Prints)>,
    /// How it ended; `None` if everything is answered, and more can be asked.
    pub(crate) end: Option<End>,
    /// What was printed after the last answer.
    pub(crate) leftover: Prints,
}

/// How a process ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum End {
    /// By itself; with its exit code or signal, where the system tells.
    Exited(Option<ExitStatus>),
    /// Stopped, because no answer came in this time.
    TimedOut(Duration),
    /// Stopped, because it printed this number of bytes without an answer.
    Flooded(usize),
    /// Stopped, because it gave more answers than it was asked questions.
    TooMany,
    /// Stopped, because a total limit is used up.
    Over(Over),
}

impl End {
    /// Whether the program ended by itself and as if everything was done.
    pub(crate) fn is_quiet(&self) -> bool {
        matches!(self, Self::Exited(Some(status)) if status.success())
    }
}

/// A program that gives a second answer to a question mostly does so within this time.
pub(crate) const BREATH: Duration = Duration::from_millis(1);

/// Processor time in which a program tells where it is.
const WHERE: Duration = Duration::from_secs(1);

/// What a program has written to standard error arrives within this time from the end of its standard output.
const LAST_WORDS: Duration = Duration::from_millis(50);

/// Bytes for which any empty pipe has room (`PIPE_BUF`).
const AT_ONCE: usize = 4096;

/// How long to wait, besides the limits.
#[derive(Clone, Copy)]
pub(crate) struct Waits {
    /// Until a program that is not at work is told that there are no more questions; without it, that is so at once.
    pub(crate) patience: Option<Duration>,
    /// For the program's start, beside the time for the first answer.
    pub(crate) start: Duration,
    /// For more answers than were asked for.
    pub(crate) breath: Duration,
}

/// A running answer program. Nothing of it is left when it is dropped.
pub(crate) struct Process {
    held: Option<Held>,
    /// None when no more will be asked.
    questions: Option<Questions>,
    events: Receiver<Vec<Event>>,
    /// What has come and is not heard yet.
    come: VecDeque<Event>,
    /// Since the last answer, or the start.
    clock: Clock,
    /// Whether its start is over: it has read a question.
    has_started: bool,
    /// Whether it has answered anything yet.
    pub(crate) has_answered: bool,
}

/// The way of the questions to a process, which ends where this is dropped.
struct Questions {
    /// To the thread that writes them.
    to_write: Sender<String>,
    /// How many texts are still to be written.
    unwritten: Arc<AtomicUsize>,
    pipe: Arc<ChildStdin>,
}

impl Questions {
    fn new(pipe: ChildStdin) -> Self {
        let pipe = Arc::new(pipe);
        let unwritten = Arc::new(AtomicUsize::new(0));
        let (to_write, questions) = channel::<String>();
        let (into, left) = (Arc::clone(&pipe), Arc::clone(&unwritten));
        // A program that ends early does not read it all, and that is its business.
        thread::spawn(move || {
            questions.iter().try_for_each(|text| {
                (&*into).write_all(text.as_bytes())?;
                left.fetch_sub(1, Ordering::SeqCst);
                io::Result::Ok(())
            })
        });
        Self {
            to_write,
            unwritten,
            pipe,
        }
    }

    fn write(&self, text: String) {
        // Who has read everything has room for so little, and a thread need not be woken for it.
        if text.len() <= AT_ONCE && self.are_read() {
            let _ = (&*self.pipe).write_all(text.as_bytes());
            return;
        }
        self.unwritten.fetch_add(1, Ordering::SeqCst);
        // The writer has gone where the program has ended, which is heard elsewhere.
        let _ = self.to_write.send(text);
    }

    /// Whether the process has read all questions, where the system tells. On a busy machine the writer may still be waiting to write them,
    /// and the pipe is empty.
    fn are_read(&self) -> bool {
        self.unwritten.load(Ordering::SeqCst) == 0 && are_read(&self.pipe)
    }
}

/// Whether a pipe is empty.
#[cfg(target_os = "linux")]
fn are_read(pipe: &ChildStdin) -> bool {
    rustix::io::ioctl_fionread(pipe).is_ok_and(|unread| unread == 0)
}

/// The same elsewhere: nothing is known.
#[cfg(not(target_os = "linux"))]
fn are_read(_pipe: &ChildStdin) -> bool {
    false
}

impl Process {
    /// Starts the program.
    ///
    /// # Errors
    /// If it cannot be started.
    pub(crate) fn start(program: &Program) -> io::Result<Self> {
        let mut command = Command::new(&program.file);
        command
            .args(&program.arguments)
            .env("PYTHONUNBUFFERED", "1") // else Python holds its answers back until the questions end
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        if !program.folder.as_os_str().is_empty() {
            command.current_dir(&program.folder);
        }
        let sandbox = program.sandbox.as_ref();
        if let Some(sandbox) = sandbox {
            sandbox.enclose(&mut command)?;
        }
        let mut held =
            contain::start(&mut command, sandbox).map_err(|error| cannot_start(program, &error))?;
        let questions = held.child.stdin.take().map(Questions::new);
        let outputs = held.child.stdout.take().zip(held.child.stderr.take());
        let (stdout, stderr) = outputs.ok_or(io::ErrorKind::BrokenPipe)?;
        Ok(Self {
            clock: Clock::new(Some(held.child.id())),
            held: Some(held),
            questions,
            events: listen(stdout, stderr),
            come: VecDeque::new(),
            has_started: false,
            has_answered: false,
        })
    }

    /// Sends the questions, all at once, and listens until they are answered, or the program ends or breaks a limit.
    ///
    /// If no answer comes for the time of `waits.patience` and the program is not at work, it is told that there are no more
    /// questions: then one that holds its answers back gives them, and one that ignored a question ends. Without it, it is told so
    /// at once.
    pub(crate) fn converse(
        &mut self,
        questions: &[String],
        limits: &Limits,
        waits: Waits,
        budget: &mut Budget,
    ) -> Conversation {
        let text: String = questions
            .iter()
            .flat_map(|question| [question, "\n"])
            .collect();
        if let Some(questions) = &self.questions {
            questions.write(text);
        }
        let listening = Listening::new(self, questions.len(), limits, waits, budget);
        let mut conversation = listening.conversation();
        if let Some(end) = &mut conversation.end
            && let Some(held) = self.held.take()
        {
            self.questions = None;
            let start = now();
            let status = held.end(matches!(end, End::Exited(_)), limits.time);
            budget.spend(now().saturating_duration_since(start), 0);
            if let End::Exited(how) = end {
                *how = status;
            }
        }
        conversation
    }

    /// The next event, if one comes until then.
    fn next_until(&mut self, deadline: Instant) -> Result<Event, RecvTimeoutError> {
        loop {
            if let Some(event) = self.come.pop_front() {
                return Ok(event);
            }
            let wait = deadline.saturating_duration_since(now());
            self.come.extend(self.events.recv_timeout(wait)?);
        }
    }

    /// Asks a program that takes too long where it is, and listens until it has ended, or has had the time for that: on a busy machine
    /// it has to wait for the processor; or until it has printed more than `most` bytes. The answer programs in Python tell it on standard
    /// error; others just end.
    fn hear_where(&mut self, printed: &mut Printed, most: usize) {
        if let Some(held) = &self.held {
            held.interrupt();
        }
        self.clock.restart();
        let mut bytes = 0;
        while bytes <= most {
            match self.next_until(self.clock.next_look(WHERE)) {
                Ok(Event::Error(text)) => {
                    bytes += text.len();
                    printed.complain(&text);
                }
                Ok(Event::Answer(text) | Event::Print(text, _)) => bytes += text.len() + 1,
                Ok(Event::End) => {}
                Err(RecvTimeoutError::Timeout) if !self.clock.is_over(WHERE, Duration::ZERO) => {}
                Err(_) => break,
            }
        }
    }
}

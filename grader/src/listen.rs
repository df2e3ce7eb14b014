//! Listening to both outputs of a process: what comes, in an order that can be relied on.

use std::io::Read;
use std::process::{ChildStderr, ChildStdout};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread;

/// What comes from a process.
pub(crate) enum Event {
    /// A line that is an answer, without its `= `.
    Answer(String),
    /// Another line of standard output, or a part of a long one: its text, and whether a line ends here.
    Print(String, bool),
    /// Bytes of standard error.
    Error(Vec<u8>),
    /// Standard output is closed.
    End,
}

/// A line longer than this is cut, and no answer. The longest answers that are asked for are 4096 points, 100 kB.
const LONGEST_LINE: usize = 1 << 18;

/// How many bytes are read at a time: what a pipe holds.
const BLOCK: usize = 1 << 16;

/// How many blocks wait at the most until they are heard.
const WAITING: usize = 16;

/// The events of two outputs, all of a block at once. On Unix, what is written to standard error before an answer comes before it.
pub(crate) fn listen(stdout: ChildStdout, stderr: ChildStderr) -> Receiver<Vec<Event>> {
    let (sender, receiver) = sync_channel(WAITING);
    thread::spawn(move || both(stdout, stderr, &sender));
    receiver
}

/// Sends what comes until both outputs are closed, or nobody listens any more.
#[cfg(unix)]
fn both(mut stdout: ChildStdout, mut stderr: ChildStderr, sender: &SyncSender<Vec<Event>>) {
    use rustix::event::{PollFd, PollFlags, Timespec, poll};
    const AT_ONCE: Timespec = Timespec {
        tv_sec: 0,
        tv_nsec: 0,
    };
    let (mut lines, mut block) = (Lines::default(), vec![0; BLOCK]);
    let (mut talks, mut complains) = (true, true);
    while talks || complains {
        let out = PollFd::new(&stdout, PollFlags::IN);
        let err = PollFd::new(&stderr, PollFlags::IN);
        let mut open: Vec<_> = [(talks, out), (complains, err)]
            .into_iter()
            .filter_map(|(open, fd)| open.then_some(fd))
            .collect();
        match poll(&mut open, None) {
            Ok(_) => {}
            Err(rustix::io::Errno::INTR) => continue,
            Err(_) => return,
        }
        let said = talks && !open[0].revents().is_empty();
        // Now that there is an answer, there is what was complained of before it.
        let mut err = [PollFd::new(&stderr, PollFlags::IN)];
        if complains && poll(&mut err, Some(&AT_ONCE)).is_ok_and(|ready| ready > 0) {
            complains = pass_on_errors(&mut stderr, &mut block, sender);
        }
        if said {
            talks = pass_on_lines(&mut stdout, &mut block, &mut lines, sender);
        }
    }
}

/// The same without `poll`: the two outputs come in any order.
#[cfg(not(unix))]
fn both(mut stdout: ChildStdout, mut stderr: ChildStderr, sender: &SyncSender<Vec<Event>>) {
    let errors = sender.clone();
    thread::spawn(move || {
        let mut block = vec![0; BLOCK];
        while pass_on_errors(&mut stderr, &mut block, &errors) {}
    });
    let (mut lines, mut block) = (Lines::default(), vec![0; BLOCK]);
    while pass_on_lines(&mut stdout, &mut block, &mut lines, sender) {}
}

/// Sends the next bytes of standard error; whether more can come.
fn pass_on_errors(
    stderr: &mut impl Read,
    block: &mut [u8],
    sender: &SyncSender<Vec<Event>>,
) -> bool {
    match stderr.read(block) {
        Ok(n) if n > 0 => sender.send(vec![Event::Error(block[..n].to_vec())]).is_ok(),
        _ => false,
    }
}

/// Sends the lines in the next bytes of standard output, or its end; whether more can come.
fn pass_on_lines(
    stdout: &mut impl Read,
    block: &mut [u8],
    lines: &mut Lines,
    sender: &SyncSender<Vec<Event>>,
) -> bool {
    let (events, more) = match stdout.read(block) {
        Ok(n) if n > 0 => (lines.take(&block[..n]), true),
        _ => (lines.end(), false),
    };
    sender.send(events).is_ok() && more
}

/// The lines of standard output.
#[derive(Default)]
struct Lines {
    /// What has come of the present line and is not sent.
    begun: Vec<u8>,
    /// Whether a part of it is sent.
    continues: bool,
}

impl Lines {
    /// What can be sent with these further bytes.
    fn take(&mut self, bytes: &[u8]) -> Vec<Event> {
        let mut events = Vec::new();
        for part in bytes.split_inclusive(|&byte| byte == b'\n') {
            self.begun.extend(part);
            if part.ends_with(b"\n") || self.begun.len() >= LONGEST_LINE {
                events.push(self.cut());
            }
        }
        events
    }

    /// What is left at the end.
    fn end(&mut self) -> Vec<Event> {
        let rest = (!self.begun.is_empty()).then(|| self.cut());
        rest.into_iter().chain([Event::End]).collect()
    }

    fn cut(&mut self) -> Event {
        let bytes = std::mem::take(&mut self.begun);
        let whole = bytes.ends_with(b"\n");
        let starts = !std::mem::replace(&mut self.continues, !whole);
        let text = String::from_utf8_lossy(&bytes);
        let text = text.trim_end_matches(['\n', '\r']);
        // Windows programs begin their output with a byte-order mark.
        match text.trim_start_matches('\u{feff}').strip_prefix("= ") {
            Some(answer) if starts && whole => Event::Answer(answer.trim().to_owned()),
            _ => Event::Print(text.to_owned(), whole),
        }
    }
}

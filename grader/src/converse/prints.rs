//! What an answer program prints beside its answers, and what is kept of it.

use raybook_chapters::kit::untrusted::Untrusted;

/// What a program printed that is no answer.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Prints {
    /// On standard output.
    pub stdout: Untrusted,
    /// On standard error, while the question was open: before its answer, or after the answer before. Where several questions
    /// are open, because the program holds its answers back, it may stand with any of them.
    pub stderr: Untrusted,
}

/// Bytes that are kept of what was printed for a question, of each output.
const KEPT: usize = 1 << 12;

/// What is kept of the prints before an answer.
#[derive(Default)]
pub(super) struct Printed {
    stdout: String,
    stderr: Vec<u8>,
}

impl Printed {
    /// A line, or a part of one. Empty lines are not kept: an answer program may end what the student left open.
    pub(super) fn print(&mut self, text: &str, whole: bool) {
        let room = KEPT.saturating_sub(self.stdout.len());
        let fits = text.char_indices().map(|(i, c)| i + c.len_utf8());
        let end = fits.take_while(|&end| end <= room).last().unwrap_or(0);
        self.stdout.push_str(&text[..end]);
        let open = !self.stdout.is_empty() && !self.stdout.ends_with('\n');
        if whole && open {
            self.stdout.push('\n');
        }
    }

    pub(super) fn complain(&mut self, text: &[u8]) {
        let room = KEPT.saturating_sub(self.stderr.len());
        self.stderr.extend(&text[..room.min(text.len())]);
    }

    pub(super) fn told(self) -> Prints {
        Prints {
            stdout: self.stdout.into(),
            stderr: String::from_utf8_lossy(&self.stderr).into_owned().into(),
        }
    }
}

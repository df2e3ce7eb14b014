//! Printing for people, who may have stopped reading.

use std::fmt::Display;
use std::io::{self, ErrorKind, Write};
use std::sync::OnceLock;

/// Why something that was said did not arrive: the first reason.
static LOST: OnceLock<io::Error> = OnceLock::new();

/// Prints a text and a line end. That nobody reads any more (`raybook exercise | head`) is no error; what else goes wrong is
/// kept for [`lost`], so that the work goes on and only its end says so.
pub fn say(text: impl Display) {
    let mut stdout = io::stdout().lock();
    keep(writeln!(stdout, "{text}").and_then(|()| stdout.flush()));
}

/// Prints a text and a line end to standard error. If that is closed or full, there is nowhere left to complain.
pub fn complain(text: impl Display) {
    let _ = writeln!(io::stderr(), "{text}");
}

/// Why something that was said did not arrive, if so: a full disk, say. The program's exit code must tell it.
pub fn lost() -> Option<&'static io::Error> {
    LOST.get()
}

fn keep(said: io::Result<()>) {
    if let Err(error) = said
        && error.kind() != ErrorKind::BrokenPipe
    {
        // The first reason is as good as the next ones.
        let _ = LOST.set(error);
    }
}

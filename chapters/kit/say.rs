//! Printing for people, who may have stopped reading.

use std::fmt::Display;
use std::io::{self, ErrorKind, Write};
use std::sync::OnceLock;

/// The first reason why some output could not be written.
static LOST: OnceLock<io::Error> = OnceLock::new();

/// Prints a text and a line end. If nobody reads the output any more (`raybook exercise | head`), this is no error. Any other
/// error is kept for [`lost`], so that the work goes on and the error is reported at its end.
pub fn say(text: impl Display) {
    let mut stdout = io::stdout().lock();
    keep(writeln!(stdout, "{text}").and_then(|()| stdout.flush()));
}

/// Prints a text and a line end to standard error. If that is closed or full, there is nowhere left to complain.
pub fn complain(text: impl Display) {
    let _ = writeln!(io::stderr(), "{text}");
}

/// Why some output could not be written, if any: for example a full disk. The program's exit code must report it.
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

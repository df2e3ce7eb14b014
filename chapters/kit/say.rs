//! Printing for people, who may have stopped reading.

use crate::kit::untrusted::Untrusted;
use std::error::Error;
use std::fmt::Display;
use std::io::{self, ErrorKind, Write};
use std::iter::successors;
use std::process::ExitCode;
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

/// Prints an error and its causes. They may contain text from outside: line ends stay, and every other hidden character is shown.
pub fn report(error: &dyn Error) {
    complain(format_args!("error: {}", error_text(error)));
}

/// An error and its causes, in lines that can be shown.
pub fn error_text(error: &dyn Error) -> String {
    let causes = successors(error.source(), |cause| (*cause).source());
    let causes = causes.map(|cause| format!("\n  because: {}", lines(cause)));
    lines(error) + &causes.collect::<String>()
}

/// The exit code of finished work: 2, with the reason, if not all output could be written.
pub fn said_all(done: ExitCode) -> ExitCode {
    match lost() {
        None => done,
        Some(error) => {
            complain(format_args!(
                "error: standard output cannot be written: {error}"
            ));
            ExitCode::from(2)
        }
    }
}

fn lines(error: &dyn Error) -> String {
    let text = error.to_string();
    let lines: Vec<_> = text
        .lines()
        .map(|line| Untrusted::from(line).to_string())
        .collect();
    lines.join("\n")
}

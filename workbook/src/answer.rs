//! The answer program: a question per line in, an answer per line out.
//!
//! `sphere_hit 0 0 -3  0 0 1  0 inf  0 0 0 1` is answered by `= 2`. Whatever else is printed is for people.
//! `= todo NAME` says that the function NAME is not written yet, `= panic MESSAGE` that it panicked,
//! `= error MESSAGE` that the question could not be read.

use crate::exercises;
use std::io::{self, BufRead, Write};
use std::panic::{self, AssertUnwindSafe};

/// What `todo!` says before the name it is given.
const TODO: &str = "not yet implemented: ";

/// Answers every line of standard input, until it ends.
///
/// # Errors
/// If standard input or output breaks.
pub fn run() -> io::Result<()> {
    // The message of a panic is the answer; the place is for the student.
    panic::set_hook(Box::new(|info| {
        if let (None, Some(place)) = (unwritten(info.payload()), info.location()) {
            // A panic here would be one within a panic, which ends the program.
            let _ = writeln!(
                io::stdout(),
                "panicked at {}:{}:{}",
                place.file(),
                place.line(),
                place.column()
            );
        }
    }));
    for line in io::stdin().lock().lines() {
        let answer = answer(&line?);
        // What the function printed may have left the line open, and an answer begins one.
        writeln!(io::stdout(), "\n= {answer}")?;
        io::stdout().flush()?;
    }
    Ok(())
}

/// The answer to one line, without the `= `.
pub fn answer(line: &str) -> String {
    let (name, question) = line
        .trim()
        .split_once(char::is_whitespace)
        .unwrap_or((line.trim(), ""));
    let Some(exercise) = exercises::find(name) else {
        return format!("error there is no exercise `{name}`");
    };
    match panic::catch_unwind(AssertUnwindSafe(|| exercise.answer_line(question))) {
        Ok(Ok(answer)) => answer,
        Ok(Err(error)) => format!("error {error}"),
        Err(panic) => unwritten(&*panic).map_or_else(
            || {
                format!(
                    "panic {}",
                    message(&*panic).lines().collect::<Vec<_>>().join(" ")
                )
            },
            |name| format!("todo {name}"),
        ),
    }
}

/// The function that is not written yet, if that is what a panic says.
pub fn unwritten(payload: &(dyn std::any::Any + Send)) -> Option<String> {
    message(payload).strip_prefix(TODO).map(str::to_owned)
}

/// What a panic said.
fn message(payload: &(dyn std::any::Any + Send)) -> String {
    let text = payload.downcast_ref::<&str>().map(ToString::to_string);
    text.or_else(|| payload.downcast_ref::<String>().cloned())
        .unwrap_or_else(|| "without a message".to_owned())
}

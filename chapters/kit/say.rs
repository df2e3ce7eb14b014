//! Printing for people, who may have stopped reading.

use std::fmt::Display;
use std::io::{self, Write};

/// Prints a text and a line end. That nobody reads any more (`raybook exercise | head`) is no error.
pub fn say(text: impl Display) {
    let _ = writeln!(io::stdout(), "{text}");
}

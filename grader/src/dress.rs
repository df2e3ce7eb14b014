//! Colours and symbols, which only ever repeat what a word says.

use crate::check::State;

/// How text is dressed. A symbol or colour only ever repeats what a word says.
#[derive(Clone, Copy, Debug, Default)]
pub struct Dress {
    /// ANSI colours.
    pub colour: bool,
    /// Symbols beyond ASCII in front of words.
    pub symbols: bool,
}

impl Dress {
    /// The text in a colour: the number of an ANSI code.
    pub fn paint(self, code: &str, text: &str) -> String {
        if self.colour {
            format!("\u{1b}[{code}m{text}\u{1b}[0m")
        } else {
            text.to_owned()
        }
    }

    /// The state as a symbol and a word.
    pub fn state(self, state: &State) -> String {
        let (symbol, colour, word) = match state {
            State::Right => ("✓", "32", "right"),
            State::Wrong => ("✗", "31", "wrong"),
            State::NotStarted => ("·", "2", "not started"),
            State::WaitsFor(_) => ("…", "2", "waits"),
        };
        let word = format!("{word:<11}");
        self.paint(
            colour,
            &if self.symbols {
                format!("{symbol} {word}")
            } else {
                word
            },
        )
    }
}

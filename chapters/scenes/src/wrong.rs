//! What can be wrong with a file that people write in TOML, and where.
//!
//! ```
//! use raybook_scenes::wrong::Source;
//!
//! let source = Source { path: "ball.toml".as_ref(), text: "[camera]\nup = [0, 0, 0]" };
//! let error = source.wrong(14, "this is no direction"); // the byte of the bracket after `up`
//! assert_eq!(error.to_string(), "ball.toml:2:6: this is no direction");
//! ```

use raybook::store::StoreError;
use std::path::{Path, PathBuf};
use toml::Spanned;
use toml::de::DeTable;

/// Why a file is not what it should be.
#[derive(Debug, thiserror::Error)]
pub enum TextError {
    /// The file could not be read, or it is not a file.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// Something in the text is wrong.
    #[error("{}:{line}:{column}: {message}", visible(&path.to_string_lossy()))]
    Wrong {
        /// The file.
        path: PathBuf,
        /// The line, from 1.
        line: usize,
        /// The column, in characters from 1.
        column: usize,
        /// What is wrong there, and what is expected.
        message: String,
    },
}

/// A text in TOML.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// The file.
    pub path: &'a Path,
    /// What is in it.
    pub text: &'a str,
}

impl Source<'_> {
    /// The tables of the text.
    ///
    /// # Errors
    /// If it is not TOML.
    pub fn parse(&self) -> Result<Spanned<DeTable<'_>>, TextError> {
        DeTable::parse(self.text).map_err(|error| {
            let at = error.span().map_or(0, |span| span.start);
            let message = visible(&error.message().trim_end().replace('\n', "; "));
            self.wrong(at, format!("this is not valid TOML: {message}"))
        })
    }

    /// What is wrong at a byte of the text.
    pub fn wrong(&self, at: usize, message: impl Into<String>) -> TextError {
        let before = self.text.get(..at).unwrap_or(self.text);
        let line = before.rsplit('\n').next().unwrap_or_default();
        TextError::Wrong {
            path: self.path.into(),
            line: before.matches('\n').count() + 1,
            column: line.chars().count() + 1,
            message: message.into(),
        }
    }

    /// A file that the text names; its place is relative to the file of the text.
    pub fn beside(&self, name: &str) -> PathBuf {
        self.path.parent().unwrap_or(Path::new("")).join(name)
    }
}

/// The words, each between back-ticks, separated by commas.
pub fn listed<'a>(words: impl IntoIterator<Item = &'a str>) -> String {
    let words: Vec<_> = words.into_iter().map(shown).collect();
    words.join(", ")
}

/// A word of the text between back-ticks; hidden characters are escaped.
pub fn shown(word: &str) -> String {
    format!("`{}`", visible(word))
}

/// A text in which hidden characters are escaped.
fn visible(text: &str) -> String {
    let plain = |c: char| matches!(c, '"' | '\'' | '\\');
    let shown = |c: char| -> String {
        if plain(c) {
            c.into()
        } else {
            c.escape_debug().collect()
        }
    };
    text.chars().map(shown).collect()
}

/// That there is nothing of this name, and the name that was probably meant, or all that there are.
pub fn no_such<'a>(
    what: &str,
    name: &str,
    known: impl IntoIterator<Item = &'a str> + Clone,
) -> String {
    let hint = did_you_mean(name, known.clone());
    let hint = if hint.is_empty() {
        format!("; there are {}", listed(known))
    } else {
        hint
    };
    format!("there is no {what} {}{hint}", shown(name))
}

/// "; did you mean `x`?" for the word that is most alike, if one is.
pub fn did_you_mean<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    /// Maximum number of characters that are compared: no known word is longer.
    const LONGEST: usize = 64;
    let word: String = word.chars().take(LONGEST).collect();
    let distance = |known: &str| strsim::damerau_levenshtein(&word, known);
    let nearest = known.into_iter().min_by_key(|known| distance(known));
    nearest
        .filter(|known| distance(known) <= 1 + known.len() / 3)
        .map_or_else(String::new, |known| {
            format!("; did you mean {}?", shown(known))
        })
}

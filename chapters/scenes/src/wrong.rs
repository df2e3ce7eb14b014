//! What can be wrong with a scene file, and where.

use raybook::store::StoreError;
use std::path::{Path, PathBuf};

/// Why a file is not a scene.
#[derive(Debug, thiserror::Error)]
pub enum SceneError {
    /// The file could not be read, or it is not a file.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// Something in the text is wrong.
    #[error("{}:{line}:{column}: {message}", path.display())]
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

/// A scene file's text.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// The file.
    pub path: &'a Path,
    /// What is in it.
    pub text: &'a str,
}

impl Source<'_> {
    /// What is wrong at a byte of the text.
    pub fn wrong(&self, at: usize, message: impl Into<String>) -> SceneError {
        let before = self.text.get(..at).unwrap_or(self.text);
        let line = before.rsplit('\n').next().unwrap_or_default();
        SceneError::Wrong {
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
    format!("`{}`", word.escape_debug())
}

/// "; did you mean `x`?" for the word that is most alike, if one is.
pub fn did_you_mean<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    let nearest = known.into_iter().min_by_key(|known| distance(word, known));
    nearest
        .filter(|known| distance(word, known) <= 1 + known.len() / 3)
        .map_or_else(String::new, |known| {
            format!("; did you mean {}?", shown(known))
        })
}

/// The number of characters that must be inserted, removed or replaced to make one word from the other (Levenshtein 1966).
fn distance(a: &str, b: &str) -> usize {
    /// Maximum number of characters that are compared: no known word is longer.
    const LONGEST: usize = 64;
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().take(LONGEST).enumerate() {
        let mut corner = i;
        row[0] = i + 1;
        for (j, &y) in b.iter().enumerate() {
            let replaced = corner + usize::from(x != y);
            corner = row[j + 1];
            row[j + 1] = replaced.min(corner + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

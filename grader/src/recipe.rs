//! `raybook.toml`: how a workbook's program is built and run, in whatever language.
//!
//! ```toml
//! language = "perl"            # a name for people; "rust" alone is built by cargo
//! build = "make -s"            # only if it is to be built: a command, run in the folder
//! run = "perl answer.pl"       # the command that answers a line per line
//! ```

use crate::starter::MARKER;
use raybook::store::{self, StoreError};
use raybook_chapters::kit::untrusted::Untrusted;
use std::path::{Path, PathBuf};
use toml::Table;

/// How a workbook's program is made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Recipe {
    /// A copy of the library: cargo builds the program.
    Rust,
    /// Any other program, by its commands.
    Commands(Commands),
}

/// The commands of a workbook; each is a program and its arguments.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Commands {
    /// The language, for people.
    pub language: String,
    /// What builds the program; none if nothing is to be built.
    pub build: Option<Vec<String>>,
    /// What runs it.
    pub run: Vec<String>,
}

/// Why a workbook's `raybook.toml` is no recipe.
#[derive(Debug, thiserror::Error)]
pub enum RecipeError {
    /// It cannot be read.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// It is not TOML; the message has line and column.
    #[error("{}: {message}", Untrusted::from(path.as_path()))]
    NoToml {
        /// The file.
        path: PathBuf,
        /// What is wrong, and where.
        message: Untrusted,
    },
    /// A key is missing, unknown or wrong.
    #[error(
        "{}: {what}; such a file has three lines: language = \"perl\", build = \"make -s\" (if it is to be built) and run = \"perl answer.pl\"",
        Untrusted::from(path.as_path())
    )]
    Wrong {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        what: Untrusted,
    },
}

impl Recipe {
    /// The recipe of a workbook's folder.
    ///
    /// # Errors
    /// If the file cannot be read, is not TOML, or says something else.
    pub fn read(folder: &Path) -> Result<Self, RecipeError> {
        let path = folder.join(MARKER);
        let text = store::read_text(&path)?;
        let table: Table = match text.parse() {
            Ok(table) => table,
            Err(error) => {
                let message = error.to_string().trim_end().to_owned().into();
                return Err(RecipeError::NoToml { path, message });
            }
        };
        Self::of(&table).map_err(|what| RecipeError::Wrong {
            path,
            what: what.into(),
        })
    }

    fn of(table: &Table) -> Result<Self, String> {
        const KEYS: [&str; 3] = ["language", "build", "run"];
        if let Some(key) = table.keys().find(|key| !KEYS.contains(&key.as_str())) {
            return Err(format!("`{key}` is none of language, build and run"));
        }
        let text = |key: &str| match table.get(key) {
            None => Ok(None),
            Some(toml::Value::String(text)) => Ok(Some(text.as_str())),
            Some(_) => Err(format!("`{key}` should be text in quotes")),
        };
        let words = |key: &str| {
            text(key)?
                .map(|line| split(line).ok_or_else(|| format!("`{key}` is no command: {line}")))
                .transpose()
        };
        let language = text("language")?.unwrap_or("rust");
        match (words("build")?, words("run")?) {
            (None, None) if language == "rust" => Ok(Self::Rust),
            (_, None) => Err("`run` is missing".to_owned()),
            (build, Some(run)) => Ok(Self::Commands(Commands {
                language: language.to_owned(),
                build,
                run,
            })),
        }
    }

    /// The language, for people and for finding its starter.
    pub fn language(&self) -> &str {
        match self {
            Self::Rust => "rust",
            Self::Commands(commands) => &commands.language,
        }
    }
}

/// The words of a command line, as a shell splits them; `None` if a quote is open, or there is no word.
pub fn split(line: &str) -> Option<Vec<String>> {
    shlex::split(line).filter(|words| !words.is_empty())
}

//! `raybook.toml`: how a workbook's program is built and run, in whatever language.
//!
//! ```toml
//! language = "perl"            # a name for people; "rust" alone is built by cargo
//! build = "make -s"            # only if it is to be built: a command, run in the folder
//! run = "perl answer.pl"       # the command that answers a line per line
//! ```

use crate::starter::MARKER;
use raybook::store;
use raybook_scenes::fields::Fields;
use raybook_scenes::wrong::{Source, TextError};
use std::path::Path;

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

impl Recipe {
    /// The recipe of a workbook's folder.
    ///
    /// # Errors
    /// If the file cannot be read; what is wrong in it, with its line and column.
    pub fn read(folder: &Path) -> Result<Self, TextError> {
        let path = folder.join(MARKER);
        let text = store::read_text(&path)?;
        let source = Source {
            path: &path,
            text: &text,
        };
        let parsed = source.parse()?;
        let fields = Fields::new(source, "a workbook", 0, parsed.get_ref());
        let recipe = Self::of(&fields)?;
        fields.finish()?;
        Ok(recipe)
    }

    fn of(fields: &Fields<'_>) -> Result<Self, TextError> {
        let language = fields.text("language")?.unwrap_or("rust");
        let command = |fields: &Fields<'_>, key| {
            let expected = "a command in quotes, such as \"perl answer.pl\"";
            fields.get(key, expected, |value| split(value.as_str()?))
        };
        let build = command(fields, "build")?;
        if language == "rust" && build.is_none() && fields.value("run").is_none() {
            return Ok(Self::Rust);
        }
        Ok(Self::Commands(Commands {
            language: language.to_owned(),
            build,
            run: fields.need("run", command)?,
        }))
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

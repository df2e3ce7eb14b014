//! The languages for which the course has starters.

/// A language with a starter for all chapters, and a reader for every exercise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// C++17
    Cpp,
    /// Python 3.9 or newer
    Python,
    /// Rust
    Rust,
}

impl Language {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Python, Self::Cpp, Self::Rust];

    /// Its name on the command line and in `raybook.toml`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Cpp => "cpp",
            Self::Python => "python",
            Self::Rust => "rust",
        }
    }

    /// The language of this name; `None` for any other, which has no starter.
    pub fn find(name: &str) -> Option<Self> {
        Self::ALL
            .into_iter()
            .find(|language| language.name() == name)
    }

    /// The language that somebody means on the command line: `C++` is `cpp`.
    ///
    /// # Errors
    /// What others can do, if it is another.
    pub fn named(text: &str) -> Result<Self, String> {
        let name = text.to_lowercase().replace("c++", "cpp");
        Self::find(&name).ok_or_else(|| {
            "python, cpp or rust; in any other language write a program that answers a line per line, as `raybook exercise ray_at` shows, and have it asked by `raybook check --program FILE`".to_owned()
        })
    }

    /// The endings of its source files.
    pub const fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Python => &["py"],
            Self::Cpp => &["cpp", "cc", "cxx", "h", "hh", "hpp"],
            Self::Rust => &["rs"],
        }
    }
}

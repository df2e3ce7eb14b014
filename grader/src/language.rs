//! The languages for which the course has starters.

/// A language with a starter for all chapters, and a reader for every exercise.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
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

    /// The endings of its source files.
    pub const fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Python => &["py"],
            Self::Cpp => &["cpp", "cc", "cxx", "h", "hh", "hpp"],
            Self::Rust => &["rs"],
        }
    }
}

//! The languages of hand-ins.

/// A language that hand-ins are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Language {
    /// Python 3, its standard library only.
    Python,
    /// C++17, compiled by g++ or clang++.
    Cpp,
    /// A workbook in Rust.
    Rust,
}

impl Language {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Python, Self::Cpp, Self::Rust];

    /// Its name in `course.toml` and in journals.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Python => "python",
            Self::Cpp => "cpp",
            Self::Rust => "rust",
        }
    }

    /// The language of this name.
    pub fn of(name: &str) -> Option<Self> {
        Self::ALL
            .into_iter()
            .find(|language| language.name() == name)
    }

    /// The endings of its source files. All others are left out of a hand-in.
    pub const fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Python => &["py"],
            Self::Cpp => &["cpp", "cc", "cxx", "h", "hh", "hpp"],
            Self::Rust => &["rs"],
        }
    }
}

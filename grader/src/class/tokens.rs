//! The tokens of a source text in any of the languages: names, numbers, texts and signs, without comments and white space.

use crate::language::Language;
use std::hash::{DefaultHasher, Hash, Hasher};

/// A token.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Token {
    /// A number for its text.
    pub exact: u64,
    /// A number for what kind of token it is: all names that are no keywords are alike, all numbers, all texts.
    pub kind: u64,
}

/// Words that are part of a language's structure: they stay when names are changed.
const KEYWORDS: &[&str] = &[
    "as", "auto", "bool", "break", "class", "const", "continue", "def", "elif", "else", "enum",
    "float", "double", "fn", "for", "if", "impl", "import", "in", "int", "lambda", "let", "loop",
    "match", "mut", "None", "not", "or", "and", "pub", "return", "Self", "self", "struct",
    "template", "use", "using", "while", "yield", "Some", "Option", "Vec", "vector", "f32", "f64",
    "u32", "usize", "void",
];

/// What a token is.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Kind {
    Name,
    Number,
    Text,
    /// A sign, or a keyword: no other word is like it.
    Itself,
}

/// The tokens of a text in this language.
pub fn tokens(language: Language, text: &str) -> Vec<Token> {
    let mut tokens = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let (length, kind) = next(language, rest, first);
        let word = &rest[..length];
        if let Some(kind) = kind {
            let itself = kind == Kind::Itself || KEYWORDS.contains(&word);
            tokens.push(Token {
                exact: number(word),
                kind: if itself { number(word) } else { number(kind) },
            });
        }
        rest = &rest[length..];
    }
    tokens
}

/// The length of what comes next, and its kind; no kind for white space and comments.
fn next(language: Language, rest: &str, first: char) -> (usize, Option<Kind>) {
    let while_ = |test: fn(char) -> bool| rest.find(|c| !test(c)).unwrap_or(rest.len());
    // A line that begins with `#` is a directive in C++, or an attribute in Rust, which says as little as a comment.
    let comments: &[_] = match language {
        Language::Python => &[("#", "\n"), ("\"\"\"", "\"\"\""), ("\'\'\'", "\'\'\'")],
        Language::Cpp if rest.starts_with("#include") => &[],
        Language::Cpp | Language::Rust => &[("#", "\n"), ("//", "\n"), ("/*", "*/")],
    };
    let comment = |(begin, end): &(&str, &str)| {
        let inside = rest.strip_prefix(begin)?;
        let length = inside.find(end).map(|at| begin.len() + at + end.len());
        Some(length.unwrap_or(rest.len()))
    };
    if let Some(length) = comments.iter().find_map(comment) {
        (length, None)
    } else if first.is_whitespace() {
        (while_(char::is_whitespace), None)
    } else if first == '"' {
        (quoted(rest, '"'), Some(Kind::Text))
    } else if first == '\'' {
        // A character, a text in Python, or a lifetime, which has no end.
        let line = rest.find('\n').unwrap_or(rest.len());
        let end = rest[1..line].find('\'').map(|at| at + 2);
        end.map_or((1, Some(Kind::Itself)), |end| (end, Some(Kind::Text)))
    } else if first.is_alphabetic() || first == '_' {
        (
            while_(|c| c.is_alphanumeric() || c == '_'),
            Some(Kind::Name),
        )
    } else if first.is_ascii_digit() {
        (
            while_(|c| c.is_alphanumeric() || c == '.' || c == '_'),
            Some(Kind::Number),
        )
    } else {
        (first.len_utf8(), Some(Kind::Itself))
    }
}

/// The length of a text in quotes, with its escapes.
fn quoted(text: &str, quote: char) -> usize {
    let mut escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            c if c == quote => return at + 1,
            _ => {}
        }
    }
    text.len()
}

fn number(what: impl Hash) -> u64 {
    // The same in every run of a version: the journal never holds it.
    let mut hasher = DefaultHasher::new();
    what.hash(&mut hasher);
    hasher.finish()
}

//! The tokens of a source text in any of the languages: names, numbers, texts and signs, without comments and white space.

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

/// The tokens of a text.
pub fn tokens(text: &str) -> Vec<Token> {
    let mut tokens = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let (length, kind) = next(rest, first);
        if let Some(kind) = kind {
            let word = &rest[..length];
            let kind = if kind == "name" && KEYWORDS.contains(&word) {
                word
            } else {
                kind
            };
            tokens.push(Token {
                exact: number(word),
                kind: number(if kind == "sign" { word } else { kind }),
            });
        }
        rest = &rest[length..];
    }
    tokens
}

/// The length of what comes next, and its kind; no kind for white space and comments.
fn next(rest: &str, first: char) -> (usize, Option<&'static str>) {
    let while_ = |test: fn(char) -> bool| rest.find(|c| !test(c)).unwrap_or(rest.len());
    let until = |end: &str| rest.find(end).map_or(rest.len(), |at| at + end.len());
    if first.is_whitespace() {
        (while_(char::is_whitespace), None)
    } else if rest.starts_with("//") || (first == '#' && !rest.starts_with("#include")) {
        // In C++ and Rust a line that begins with `#` is a directive or an attribute, which says as little as a comment.
        (until("\n"), None)
    } else if rest.starts_with("/*") {
        (until("*/"), None)
    } else if let Some(inside) = rest.strip_prefix("\"\"\"") {
        let end = inside.find("\"\"\"");
        (end.map_or(rest.len(), |at| at + 6), None)
    } else if first == '"' {
        (quoted(rest, '"'), Some("text"))
    } else if first == '\'' {
        // A character, a text in Python, or a lifetime, which has no end.
        let line = rest.find('\n').unwrap_or(rest.len());
        let end = rest[1..line].find('\'').map(|at| at + 2);
        end.map_or((1, Some("sign")), |end| (end, Some("text")))
    } else if first.is_alphabetic() || first == '_' {
        (while_(|c| c.is_alphanumeric() || c == '_'), Some("name"))
    } else if first.is_ascii_digit() {
        (
            while_(|c| c.is_alphanumeric() || c == '.' || c == '_'),
            Some("number"),
        )
    } else {
        (first.len_utf8(), Some("sign"))
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

fn number(word: &str) -> u64 {
    // The same in every run of a version: the journal never holds it.
    let mut hasher = DefaultHasher::new();
    word.hash(&mut hasher);
    hasher.finish()
}

#[cfg(test)]
mod tests {
    use super::{Token, tokens};

    #[test]
    fn comments_spaces_and_names_do_not_count() {
        let kinds = |text: &str| {
            tokens(text)
                .iter()
                .map(|token: &Token| token.kind)
                .collect::<Vec<_>>()
        };
        let one = "let t = a.dot(b); // the distance\nreturn \"a \\\" b\";";
        let two = "let distance=origin.dot( direction ) ;/* */ return \"c\";";
        assert_eq!(kinds(one), kinds(two));
        assert_ne!(kinds(one), kinds("let t = a.dot(b) + 1;"));
        assert_eq!(
            kinds("x = 1 # a comment\n\"\"\"a\nlong one\"\"\""),
            kinds("y = 22.5")
        );
        assert_eq!(
            tokens("a\u{e9} ' \" open").len(),
            3,
            "nothing makes it panic"
        );
    }
}

//! Text from outside: a student's program, another's file, the name of a folder. It may hold what commands a terminal, turns
//! the reading direction round, hides, or means something to a shell or a browser.

use maud::{PreEscaped, Render};
use std::fmt::{self, Debug, Display, Formatter, Write};
use std::path::Path;

/// Text from outside. It can be read by a parser, but shown only with everything in it visible.
///
/// ```
/// use raybook_chapters::kit::untrusted::Untrusted;
///
/// let answer = Untrusted::from("1 \u{1b}[2J 2");
/// assert_eq!(answer.to_string(), "1 \\u{1b}[2J 2");
/// assert_eq!(Untrusted::from("$(touch x)").shell(), "'$(touch x)'");
/// assert_eq!(maud::html! { (Untrusted::from("<b>")) }.into_string(), "&lt;b&gt;");
/// ```
#[derive(Clone, Default, PartialEq, Eq)]
pub struct Untrusted(String);

impl Untrusted {
    /// The text as it came, to read numbers and names from it or to compare it. Never to be shown.
    pub fn unescaped(&self) -> &str {
        &self.0
    }

    /// Its lines.
    pub fn lines(&self) -> impl Iterator<Item = Self> {
        self.0.lines().map(Self::from)
    }

    /// The text as one word of a command for a POSIX shell, where it means nothing but itself. What is not shown is written in
    /// bash's and zsh's `$'…'`.
    pub fn shell(&self) -> String {
        let plain = |c: char| c.is_ascii_alphanumeric() || "_@+:,./-".contains(c);
        if !self.0.is_empty() && self.0.chars().all(plain) {
            return self.0.clone();
        }
        if !self.0.chars().any(is_hidden) {
            return format!("'{}'", self.0.replace('\'', r"'\''"));
        }
        let mut word = "$'".to_owned();
        for c in self.0.chars() {
            // A shell that does not know `$'…'` takes it for a quoted word, which therefore must not end before its end.
            if is_hidden(c) || matches!(c, '\'' | '\\' | '!') {
                for byte in c.encode_utf8(&mut [0; 4]).bytes() {
                    // Three digits always, so that a digit that follows is not taken for one of them.
                    let _ = write!(word, "\\{byte:03o}");
                }
            } else {
                word.push(c);
            }
        }
        word + "'"
    }
}

/// For people: everything that a terminal would not show as a character is written as its number, a line end too.
impl Display for Untrusted {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.0.chars().try_for_each(|c| match c {
            '\n' => f.write_str("\\n"),
            '\r' => f.write_str("\\r"),
            c if is_hidden(c) => write!(f, "{}", c.escape_unicode()),
            c => f.write_char(c),
        })
    }
}

impl Debug for Untrusted {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "\"{self}\"")
    }
}

/// For a page: what is shown to people, without a tag in it.
impl Render for Untrusted {
    fn render_to(&self, page: &mut String) {
        self.to_string().render_to(page);
    }

    fn render(&self) -> PreEscaped<String> {
        self.to_string().render()
    }
}

impl From<&str> for Untrusted {
    fn from(text: &str) -> Self {
        Self(text.to_owned())
    }
}

impl From<String> for Untrusted {
    fn from(text: String) -> Self {
        Self(text)
    }
}

impl From<&Path> for Untrusted {
    fn from(path: &Path) -> Self {
        Self(path.to_string_lossy().into_owned())
    }
}

/// Characters without ink, although Unicode counts them among letters and accents.
const INKLESS: [char; 7] = [
    '\u{34f}', '\u{115f}', '\u{1160}', '\u{17b4}', '\u{17b5}', '\u{3164}', '\u{ffa0}',
];

/// Whether a terminal does not show a character as one: control characters but for the tab, the marks that turn the reading
/// direction round, what has no width, and what is no character at all. Spaces and accents are none of these.
pub fn is_hidden(c: char) -> bool {
    if c.is_ascii() {
        return c.is_ascii_control() && c != '\t';
    }
    // The standard library knows what is printable. It escapes an accent only where there is nothing below it: hence the letter.
    let escaped = |c: char| !format!("x{c}").escape_debug().eq(['x', c]);
    let space = c.is_whitespace() && !matches!(c, '\u{85}' | '\u{2028}' | '\u{2029}');
    INKLESS.contains(&c) || (!space && escaped(c))
}

//! The terms of the glossary in the built book: each is a heading below its letter, because the book's search finds headings.

/// The terms of a page: a line with the name, and below it a line that begins with a colon.
#[derive(Default)]
pub(super) struct Terms {
    /// The letter of the term before.
    letter: Option<char>,
}

impl Terms {
    /// What a line with a term becomes, and what the line below becomes; none if the two lines are no term.
    pub(super) fn heading<'a>(&mut self, line: &str, below: &'a str) -> Option<(String, &'a str)> {
        let definition = below.strip_prefix(": ")?;
        let letter = line.chars().next()?.to_ascii_uppercase();
        let begins = self.letter.replace(letter) != Some(letter);
        let above = if begins {
            format!("## {letter}\n\n")
        } else {
            String::new()
        };
        Some((format!("{above}### {line}\n"), definition))
    }
}

//! Citations: `Kajiya 1986` and `Walter and others (2007)` in a text become links to the work in the bibliography.

use super::{Page, text};

/// The page of the works.
pub(super) const BIBLIOGRAPHY: &str = "bibliography.md";

/// A work of the bibliography: its line begins with its authors, its year and its title, `- James T. Kajiya, 1986: "The rendering equation"`.
struct Work {
    /// The authors' whole names, each of which ends with the family name.
    authors: Vec<String>,
    year: String,
    title: String,
}

impl Work {
    /// The work of a line of the bibliography.
    fn read(line: &str) -> Option<Self> {
        let (made, title) = line.strip_prefix("- ")?.split_once(": ")?;
        let (authors, year) = made.rsplit_once(", ")?;
        let title = title.split(['"', '*']).nth(1)?;
        let names = authors.split(", ").flat_map(|names| names.split(" and "));
        is_year(year).then(|| Self {
            authors: names.map(str::to_owned).collect(),
            year: year.to_owned(),
            title: title.to_owned(),
        })
    }

    /// Where the names of its authors with which a text ends begin; none if it does not end with one. A name may be the family name alone, or
    /// more of the name.
    fn names(&self, text: &str) -> Option<usize> {
        let starts = self.authors.iter().filter_map(|author| ends(text, author));
        let start = starts.min()?;
        let before = &text[..start];
        let before = before.strip_suffix(" and ").or(before.strip_suffix(", "));
        before.and_then(|before| self.names(before)).or(Some(start))
    }

    /// Its place on the page of the bibliography.
    fn place(&self) -> String {
        text::place(&self.title)
    }
}

/// The line of the bibliography with a place to which citations lead; other lines as they are.
pub(super) fn with_place(line: &str) -> String {
    match (Work::read(line), line.strip_prefix("- ")) {
        (Some(work), Some(rest)) => format!("- <a id=\"{}\"></a>{rest}", work.place()),
        _ => line.to_owned(),
    }
}

/// All works of the book that can be cited.
pub(super) struct Works(Vec<Work>);

impl Works {
    /// The works of the book's bibliography.
    pub(super) fn of(pages: &[Page]) -> Self {
        let page = pages.iter().find(|page| page.name == BIBLIOGRAPHY);
        let lines = page.into_iter().flat_map(|page| page.text.lines());
        Self(lines.filter_map(Work::read).collect())
    }

    /// A part of a text, with a link for each citation.
    pub(super) fn linked(&self, text: &str) -> String {
        let (mut linked, mut rest) = (String::with_capacity(text.len()), text);
        while let Some((start, end, work)) = self.first(rest) {
            linked.push_str(&rest[..start]);
            let cited = &rest[start..end];
            linked.extend(["[", cited, "](", BIBLIOGRAPHY, "#", &work.place(), ")"]);
            rest = &rest[end..];
        }
        linked + rest
    }

    /// The first citation of a text: from where to where, and what is cited.
    fn first(&self, text: &str) -> Option<(usize, usize, &Work)> {
        let digits = text.match_indices(|c: char| c.is_ascii_digit());
        digits.into_iter().find_map(|(at, _)| {
            let year = text.get(at..at + 4).filter(|year| is_year(year))?;
            let before = text[..at]
                .strip_suffix(" (")
                .or(text[..at].strip_suffix(' '))?;
            let name = before.strip_suffix(" and others").unwrap_or(before);
            let of_year = self.0.iter().filter(|work| work.year == year);
            let cited = of_year.filter_map(|work| Some((work.names(name)?, work)));
            // Of two works, the one of which more names stand here, and fewer are missing.
            let (start, work) = cited.min_by_key(|(start, work)| (*start, work.authors.len()))?;
            let closed = text[before.len()..at].contains('(') && text[at + 4..].starts_with(')');
            Some((start, at + 4 + usize::from(closed), work))
        })
    }
}

/// Where the name of an author with which a text ends begins: the family name, with as much of the name before it as stands there.
fn ends(text: &str, author: &str) -> Option<usize> {
    let words = author.match_indices(' ').map(|(space, _)| space + 1);
    let names = [0].into_iter().chain(words).map(|start| &author[start..]);
    let starts = names.filter_map(|name| text.strip_suffix(name));
    let mut starts = starts.filter(|before| before.is_empty() || before.ends_with([' ', '(']));
    starts.next().map(str::len)
}

/// Whether a word is the number of a year.
fn is_year(word: &str) -> bool {
    word.len() == 4 && word.bytes().all(|byte| byte.is_ascii_digit())
}

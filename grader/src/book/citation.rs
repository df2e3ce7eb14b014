//! Citations: `Kajiya 1986` and `Walter and others (2007)` in a text become links to the work in the bibliography.

use super::Page;

/// The page of the works.
pub(super) const BIBLIOGRAPHY: &str = "bibliography.md";

/// A work of the bibliography: its line begins with its authors and its year, `- James T. Kajiya, 1986: …`.
struct Work {
    /// The authors' family names.
    authors: Vec<String>,
    year: String,
}

impl Work {
    /// The work of a line of the bibliography.
    fn read(line: &str) -> Option<Self> {
        let (authors, year) = line
            .strip_prefix("- ")?
            .split_once(':')?
            .0
            .rsplit_once(", ")?;
        let names = authors.split(", ").flat_map(|names| names.split(" and "));
        let families = names.filter_map(|name| name.split_whitespace().next_back());
        is_year(year).then(|| Self {
            authors: families.map(str::to_owned).collect(),
            year: year.to_owned(),
        })
    }

    /// Its place on the page of the bibliography.
    fn place(&self) -> String {
        format!("{}-{}", self.authors.join("-"), self.year).to_lowercase()
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
            let start = name.rfind([' ', '(']).map_or(0, |space| space + 1);
            let mut of_year = self.0.iter().filter(|work| work.year == year);
            let is_author =
                |work: &&Work| work.authors.iter().any(|author| *author == name[start..]);
            let work = of_year.find(is_author)?;
            let closed = text[before.len()..at].contains('(') && text[at + 4..].starts_with(')');
            Some((start, at + 4 + usize::from(closed), work))
        })
    }
}

/// Whether a word is the number of a year.
fn is_year(word: &str) -> bool {
    word.len() == 4 && word.bytes().all(|byte| byte.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::{BIBLIOGRAPHY, Page, Works, with_place};

    #[test]
    fn a_citation_leads_to_its_work() {
        let text = "- James T. Kajiya, 1986: \"The rendering equation\".\n- Eric Veach and Leonidas J. Guibas, 1995: \"Optimally\".";
        let pages = [Page {
            name: BIBLIOGRAPHY.to_owned(),
            text: text.to_owned(),
        }];
        let works = Works::of(&pages);
        for (text, linked) in [
            (
                "emits (Kajiya 1986):",
                "emits ([Kajiya 1986](bibliography.md#kajiya-1986)):",
            ),
            (
                "As Kajiya (1986) says",
                "As [Kajiya (1986)](bibliography.md#kajiya-1986) says",
            ),
            (
                "Veach and Guibas 1995",
                "Veach and [Guibas 1995](bibliography.md#veach-guibas-1995)",
            ),
            (
                "Kajiya and others 1986",
                "[Kajiya and others 1986](bibliography.md#kajiya-1986)",
            ),
            ("in 1986, Kajiya 1987", "in 1986, Kajiya 1987"),
        ] {
            assert_eq!(works.linked(text), linked);
        }
        assert_eq!(
            with_place("- James T. Kajiya, 1986: x"),
            "- <a id=\"kajiya-1986\"></a>James T. Kajiya, 1986: x"
        );
    }
}

//! `{{index glossary.md}}`: the index of the book, made from the terms of its glossary and the pages on which they occur.

use super::{Page, text};
use maud::{Markup, html};
use raybook_workbook::curriculum;

/// Maximum number of pages that the index lists for a term: one on more pages is used throughout the book, and a list would help nobody.
const THROUGHOUT: usize = 16;

/// A term of the glossary.
struct Term<'a> {
    name: &'a str,
    /// The page, and the place on it, that explains the term.
    explained: &'a str,
}

/// The terms of the page `glossary` in the order of its letters: first the page that explains the term, then the others.
///
/// # Errors
/// If there is no such page, or no term on it.
pub(super) fn expand(glossary: &str, pages: &[Page]) -> Result<String, String> {
    let terms = pages.iter().find(|page| page.name == glossary);
    let terms = terms.map(|page| terms_of(&page.text)).unwrap_or_default();
    if terms.is_empty() {
        return Err(format!("the book has no page {glossary} with terms"));
    }
    // What comes after the glossary is looked up, not read.
    let texts: Vec<_> = pages
        .iter()
        .take_while(|page| page.name != glossary)
        .map(|page| (page, words(&page.text)))
        .collect();
    let list = html! {
        ul class="index" {
            @for term in terms {
                li {
                    a href={ (html_file(glossary)) "#" (text::place(term.name)) } { (term.name) } " "
                    (occurrences(&term, &texts))
                }
            }
        }
    };
    Ok(list.into_string())
}

/// The pages on which a term is found.
fn occurrences(term: &Term, texts: &[(&Page, String)]) -> Markup {
    let explained = term.explained.split('#').next().unwrap_or_default();
    let page = texts.iter().find(|(page, _)| page.name == explained);
    let others: Vec<_> = texts
        .iter()
        .filter(|(page, text)| page.name != explained && mentions(text, term.name))
        .collect();
    html! {
        @if let Some((page, _)) = page { b { a href=(html_file(term.explained)) { (short(page)) } } }
        @if others.len() > THROUGHOUT { ", throughout" } @else {
            @for (page, _) in others { ", " a href=(html_file(&page.name)) { (short(page)) } }
        }
    }
}

/// The terms of a glossary: a line with the name, and below it a line that begins with a colon and ends with a link.
fn terms_of(text: &str) -> Vec<Term<'_>> {
    let lines: Vec<_> = text.lines().collect();
    let pairs = lines.windows(2);
    let terms = pairs.filter_map(|pair| {
        let definition = pair[1].strip_prefix(": ")?;
        let (_, link) = definition.rsplit_once("](")?;
        Some(Term {
            name: pair[0],
            explained: link.split(')').next()?,
        })
    });
    terms.collect()
}

/// The words of a page in small letters, each behind a space, without its listings, directives and drawings.
fn words(text: &str) -> String {
    let (mut words, mut fenced) = (String::from(" "), false);
    for line in text.lines() {
        fenced ^= line.starts_with("```");
        if fenced || line.starts_with(['<', '{', '`']) {
            continue;
        }
        let letters = line
            .chars()
            .map(|c| if c.is_alphanumeric() { c } else { ' ' });
        for word in letters.collect::<String>().split_whitespace() {
            words.push_str(&word.to_lowercase());
            words.push(' ');
        }
    }
    words
}

/// Whether a page's words have a term among them, also in the plural. What stands in parentheses is another name of the term.
fn mentions(text: &str, term: &str) -> bool {
    let term = words(term.split(" (").next().unwrap_or(term));
    let plural = format!("{}s ", term.trim_end());
    text.contains(&term) || text.contains(&plural)
}

/// A lesson is called by its number, another page by its title, without what follows a colon.
fn short(page: &Page) -> String {
    let chapter = page.name.strip_suffix(".md").and_then(curriculum::find);
    let title = page.text.lines().find_map(|line| line.strip_prefix("# "));
    let title = title.and_then(|title| title.split(':').next());
    chapter.map_or_else(
        || title.unwrap_or(&page.name).to_owned(),
        |chapter| chapter.number().to_string(),
    )
}

/// A page, and a place on it, as the built book names them.
fn html_file(link: &str) -> String {
    link.replacen(".md", ".html", 1)
}

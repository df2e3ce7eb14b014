//! What is done to the text of a page: links to chapters, how long it takes to read, and what it needs.

use super::citation::Works;
use super::names::Names;
use super::{Page, order};
use clap::Command;
use maud::html;
use raybook_workbook::curriculum::{self, CHAPTERS};

/// Words a minute, of a text with formulas in a language that is not the reader's own.
const WORDS_A_MINUTE: usize = 120;

/// The heading by which a lesson is known.
const YOUR_TURN: &str = "\n## Your turn\n";

/// All that a text can name by a word of its own.
pub(super) struct Links {
    works: Works,
    pub(super) names: Names,
}

impl Links {
    /// The works, exercises, commands, files and items of a book with these pages.
    pub(super) fn of(pages: &[Page], command: &Command) -> Self {
        Self {
            works: Works::of(pages),
            names: Names::of(pages, command),
        }
    }
}

/// The line with a link for each chapter that it names by its number, each work that it cites, and each name in back quotes, but for those in
/// links, in headings and in HTML.
pub(super) fn linked(page: &str, line: &str, links: &Links) -> String {
    if line.starts_with("<figcaption>") {
        return linked_html(page, line);
    }
    if line.starts_with(['<', '#']) {
        return line.to_owned();
    }
    let mut text = String::with_capacity(2 * line.len());
    let mut parts = line.split('`').enumerate().peekable();
    while let Some((i, part)) = parts.next() {
        let is_code = i % 2 == 1;
        let in_a_link = text.rfind('[') > text.rfind(']');
        let place = links.names.place(part).filter(|_| !in_a_link);
        match place {
            _ if !is_code => {
                let cited = links.works.linked(part);
                text.push_str(&chapters_linked(page, &cited, markdown));
            }
            _ if parts.peek().is_none() => text.extend(["`", part]), // it is not closed on this line
            Some(place) => text.extend(["[`", part, "`](", place, ")"]),
            None => text.extend(["`", part, "`"]),
        }
    }
    text
}

/// A caption in HTML with a link for each chapter that it names.
pub(super) fn linked_html(page: &str, caption: &str) -> String {
    chapters_linked(page, caption, |words, to| {
        let file = to.replacen(".md", ".html", 1);
        html! { a href=(file) { (words) } }.into_string()
    })
}

/// A link in Markdown.
fn markdown(words: &str, to: &str) -> String {
    format!("[{words}]({to})")
}

/// A text without code, where `link` makes a link of each chapter that it names: of the words, and of the chapter's page.
fn chapters_linked(page: &str, part: &str, link: impl Fn(&str, &str) -> String) -> String {
    let (mut text, mut rest) = (String::with_capacity(2 * part.len()), part);
    while let Some(at) = rest.find("hapter ") {
        let number = at + "hapter ".len();
        let digits = rest[number..].bytes().take_while(u8::is_ascii_digit);
        let end = number + digits.count();
        let start = at.saturating_sub(1);
        let chapter = CHAPTERS
            .iter()
            .find(|chapter| rest[number..end] == chapter.number().to_string());
        let in_a_link = rest[..start].ends_with('[') || rest[end..].starts_with(']');
        let to = chapter.map(|chapter| format!("{}.md", chapter.name));
        match to {
            Some(to) if !in_a_link && to != page && rest[start..].starts_with(['c', 'C']) => {
                text.push_str(&rest[..start]);
                text.push_str(&link(&rest[start..end], &to));
            }
            _ => text.push_str(&rest[..end]),
        }
        rest = &rest[end..];
    }
    text + rest
}

/// The place of a heading or a term on its page, as mdBook calls it.
pub(super) fn place(heading: &str) -> String {
    let letters = heading.chars().filter_map(|c| match c {
        c if c.is_alphanumeric() || c == '_' || c == '-' => Some(c.to_ascii_lowercase()),
        c if c.is_whitespace() => Some('-'),
        _ => None,
    });
    letters.collect()
}

/// A lesson with its reading time and the lessons that it needs below its title; other pages as they are.
pub(super) fn with_head(page: &str, expanded: &str, source: &str) -> String {
    if !source.contains(YOUR_TURN) {
        return expanded.to_owned();
    }
    let (mut fenced, mut words) = (false, 0);
    for line in source.lines() {
        fenced ^= line.starts_with("```");
        if !fenced && !line.starts_with('<') {
            words += line.split_whitespace().count();
        }
    }
    let minutes = 5 * words.div_ceil(5 * WORDS_A_MINUTE);
    let chapter = curriculum::find(page.trim_end_matches(".md"));
    let exercises = match chapter.map_or(0, |chapter| chapter.exercises().len()) {
        1 => "one exercise".to_owned(),
        n => format!("{n} exercises"),
    };
    let head = html! {
        p class="time" {
            "About " (minutes) " minutes to read, and " (exercises) " to write."
            @for (i, needed) in order::needs(page).into_iter().enumerate() {
                @if i == 0 { " Read before it: " } @else { ", " }
                (order::link(needed))
            }
        }
    };
    match expanded.split_once('\n') {
        Some((title, rest)) => format!("{title}\n\n{}\n{rest}", head.into_string()),
        None => expanded.to_owned(),
    }
}

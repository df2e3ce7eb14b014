//! What is done to the text of a page: links to chapters, how long it takes to read, and what it needs.

use super::citation::Works;
use super::order;
use maud::html;
use raybook_workbook::curriculum::CHAPTERS;

/// Words a minute, of a text with formulas in a language that is not the reader's own.
const WORDS_A_MINUTE: usize = 120;

/// The heading by which a lesson is known.
const YOUR_TURN: &str = "\n## Your turn\n";

/// The line with a link for each chapter that it names by its number, and for each work that it cites, but for those in code, in links,
/// in headings and in HTML.
pub(super) fn linked(page: &str, line: &str, works: &Works) -> String {
    if line.starts_with(['<', '#', '|']) {
        return line.to_owned();
    }
    let mut text = String::with_capacity(2 * line.len());
    for (i, part) in line.split('`').enumerate() {
        if i > 0 {
            text.push('`');
        }
        if i % 2 == 0 {
            link_part(page, &works.linked(part), &mut text);
        } else {
            text.push_str(part);
        }
    }
    text
}

/// Appends a part of a line without code.
fn link_part(page: &str, part: &str, text: &mut String) {
    let mut rest = part;
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
                let (before, chapter) = (&rest[..start], &rest[start..end]);
                text.push_str(before);
                text.extend(["[", chapter, "](", &to, ")"]);
            }
            _ => text.push_str(&rest[..end]),
        }
        rest = &rest[end..];
    }
    text.push_str(rest);
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
    let exercises = source
        .lines()
        .filter(|line| line.starts_with("{{turn "))
        .count();
    let minutes = 5 * words.div_ceil(5 * WORDS_A_MINUTE);
    let exercises = match exercises {
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

#[cfg(test)]
mod tests {
    use super::{Works, linked};

    #[test]
    fn chapters_are_linked_but_for_this_one_and_those_in_code_and_links() {
        for (line, expected) in [
            ("as in chapter 3.", "as in [chapter 3](ch03_sphere.md)."),
            (
                "Chapter 17, chapter 4",
                "[Chapter 17](ch17_rendering_equation.md), chapter 4",
            ),
            (
                "`chapter 3` and [chapter 3](x.md)",
                "`chapter 3` and [chapter 3](x.md)",
            ),
            ("chapter 99, chapter one", "chapter 99, chapter one"),
            ("## chapter 3", "## chapter 3"),
        ] {
            assert_eq!(linked("ch04_plane.md", line, &Works::of(&[])), expected);
        }
    }
}

//! `{{path 1 2 3 12 15}}`: an order in which lessons can be read. The build stops at a lesson that comes before one that it needs.

use maud::html;
use raybook_workbook::curriculum::{self, CHAPTERS, Chapter};

/// The chapters that the lesson of this page needs; none for a page that is no lesson.
pub(super) fn needs(page: &str) -> Vec<&'static Chapter> {
    let chapter = page.strip_suffix(".md").and_then(curriculum::find);
    let numbers = chapter.map_or(&[][..], |chapter| chapter.needs);
    numbers.iter().filter_map(|&number| find(number)).collect()
}

/// A numbered list of the lessons with these numbers.
///
/// # Errors
/// If a number is none of a chapter's, or a lesson comes twice or before one that it needs.
pub(super) fn expand(numbers: &str) -> Result<String, String> {
    let mut path: Vec<&Chapter> = Vec::new();
    for word in numbers.split_whitespace() {
        let chapter = word.parse().ok().and_then(find);
        let chapter = chapter.ok_or_else(|| format!("`{word}` is the number of no chapter"))?;
        let is_behind = |number: u32| path.iter().any(|before| before.number() == number);
        if is_behind(chapter.number()) {
            return Err(format!("chapter {word} is in the path already"));
        }
        for needed in needs(&format!("{}.md", chapter.name)) {
            if !is_behind(needed.number()) {
                return Err(format!(
                    "chapter {word} ({}) needs chapter {} ({}), which does not come before it",
                    chapter.title,
                    needed.number(),
                    needed.title
                ));
            }
        }
        path.push(chapter);
    }
    let list = html! {
        ol class="path" { @for chapter in path { li value=(chapter.number()) { (link(chapter)) } } }
    };
    Ok(list.into_string())
}

/// A chapter's title, with a link to its lesson.
pub(super) fn link(chapter: &Chapter) -> maud::Markup {
    html! { a href={ (chapter.name) ".html" } { (chapter.title) } }
}

/// The chapter of this number.
fn find(number: u32) -> Option<&'static Chapter> {
    CHAPTERS.iter().find(|chapter| chapter.number() == number)
}

//! A directive on its line: `{{word name | rest}}`; `{{turn}}`, without a name, is of all exercises of the page's chapter.

use raybook_workbook::curriculum::{self, Chapter};
use raybook_workbook::exercise::Asked;

/// The words that need no name.
const OF_EVERY_EXERCISE: [&str; 3] = ["turn", "reference", "mistakes"];

/// A directive.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Directive<'a> {
    /// What to do.
    pub(crate) word: &'a str,
    /// Of what; empty where it is of every exercise.
    pub(crate) name: &'a str,
    /// What stands after the bar; empty without one.
    pub(crate) rest: &'a str,
}

/// The directive of a line, if it is one. mdBook's own begin with `{{#` and are left to it.
///
/// # Errors
/// If there are double braces, and no directive alone on the line.
pub(crate) fn read(line: &str) -> Result<Option<Directive<'_>>, String> {
    let Some((before, after)) = line.split_once("{{") else {
        return Ok(None);
    };
    if after.starts_with('#') {
        return Ok(None);
    }
    let inside = after.trim_end().strip_suffix("}}");
    let Some(inside) = inside.filter(|_| before.trim().is_empty()) else {
        return Err("a directive stands alone on its line: {{word name}}".to_owned());
    };
    let (what, rest) = inside.split_once('|').unwrap_or((inside, ""));
    let (word, name) = match what.trim().split_once(' ') {
        Some(both) => both,
        None if OF_EVERY_EXERCISE.contains(&what.trim()) => (what.trim(), ""),
        None => {
            return Err(format!(
                "`{inside}` is no directive: expected a word and a name, such as {{{{turn sphere_hit}}}}; only {} can stand alone",
                OF_EVERY_EXERCISE.join(", ")
            ));
        }
    };
    Ok(Some(Directive {
        word,
        name: name.trim(),
        rest: rest.trim(),
    }))
}

impl Directive<'_> {
    /// The exercises that a directive without a name is of: those of the page's chapter, in their order.
    ///
    /// # Errors
    /// If the page is no lesson.
    pub(crate) fn exercises(&self, page: &str) -> Result<&'static [Asked], String> {
        let chapter = curriculum::find(page.trim_end_matches(".md"));
        let exercises = chapter.map(Chapter::exercises);
        exercises.ok_or_else(|| {
            format!(
                "{page} is no lesson: `{}` needs an exercise's name here",
                self.word
            )
        })
    }
}

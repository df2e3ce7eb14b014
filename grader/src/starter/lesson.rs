//! The lessons as text: what a student's folder carries of the book, so that the derivations can be read beside the stubs.
//!
//! The text is the book's own, up to "Your turn", where the stubs go on, and "In practice": the care that a formula needs. Directives are expanded as the book does; figures
//! become their alternative texts, and formulas stay as they are typed.

use super::StarterFile;
use crate::book::directive::{self, Directive};
use crate::book::{self, BookError};
use crate::cases;
use raybook_workbook::curriculum::{CHAPTERS, Chapter};
use raybook_workbook::for_each_chapter;
use raybook_workbook::row;
use std::borrow::Cow;
use std::path::PathBuf;

macro_rules! pages {
    ($($name:ident $title:literal $needs:tt),+ $(,)?) => {
        /// The book's pages of the chapters, in their order.
        const PAGES: &[&str] = &[$(
            include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../book/src/", stringify!($name), ".md"))
        ),+];
    };
}

for_each_chapter!(pages);

/// The names that formulas use, a line each: `\name:{what it stands for}`.
const MACROS: &str = include_str!("../../../book/macros.txt");

/// The heading where the stubs go on.
const YOUR_TURN: &str = "## Your turn";

/// The heading behind it of what is told all the same.
const PRACTICE: &str = "## In practice";

/// The lessons of all chapters, in a folder of their own.
///
/// # Errors
/// If a page is wrong; a test sees to it that none is.
pub fn files() -> Result<Vec<StarterFile>, BookError> {
    let file = |(chapter, page): (&Chapter, &&str)| {
        let path = PathBuf::from("lessons").join(format!("{}.md", chapter.name));
        Ok((path, text(chapter, page)?.into_bytes()))
    };
    CHAPTERS.iter().zip(PAGES).map(file).collect()
}

/// A page as text.
fn text(chapter: &Chapter, page: &str) -> Result<String, BookError> {
    let names: Vec<_> = chapter.exercises().iter().map(|e| e.name).collect();
    let mut text = String::new();
    let mut fenced = false;
    let (mut turned, mut left_out) = (false, false);
    for (line, number) in page.lines().zip(1..) {
        if line.starts_with("## ") {
            turned |= line == YOUR_TURN;
            left_out = turned && line != PRACTICE;
        }
        if left_out {
            continue;
        }
        fenced ^= line.starts_with("```");
        let wrong = |what| BookError {
            page: format!("{}.md", chapter.name),
            line: number,
            what,
        };
        let part = if let (false, Some(directive)) = (fenced, directive::read(line).map_err(wrong)?)
        {
            text_of(directive, chapter).map_err(wrong)?
        } else if fenced && line.starts_with("cargo ") {
            match command(line) {
                Some(command) => command,
                None => continue,
            }
        } else if fenced {
            line.to_owned()
        } else {
            plain(&unfolded(line))
        };
        // Where something is left out, one empty line is enough.
        if !part.is_empty() || !text.ends_with("\n\n") {
            text.push_str(&part);
            text.push('\n');
        }
    }
    Ok(format!(
        "{}\n\n---\n\nNow write {}. The book's page `{}.html` goes on with mistakes, and questions with their answers.\n",
        text.trim_end(),
        names.join(", "),
        chapter.name
    ))
}

/// A command of the book for a folder that has no chapters, and maybe no Rust: the tour draws what a chapter draws, but has not its knobs.
fn command(line: &str) -> Option<String> {
    let (command, comment) = line.split_once('#').unwrap_or((line, ""));
    let words = command.strip_prefix("cargo run --release --bin ")?;
    let (chapter, options) = words.split_once(" -- ").unwrap_or((words, ""));
    let mut names = options.split_whitespace().step_by(2);
    if names.any(|name| !["--width", "--samples"].contains(&name)) {
        return None;
    }
    let number = chapter.split('_').next()?;
    let command = format!("raybook tour --only {number} {}", options.trim_end());
    let comment = Some(comment.trim()).filter(|comment| !comment.is_empty());
    let comment = comment.map_or_else(String::new, |comment| format!("   # {comment}"));
    Some(format!("{}{comment}", command.trim_end()))
}

/// What stands in the text for a directive of the book.
fn text_of(directive: Directive<'_>, chapter: &Chapter) -> Result<String, String> {
    match directive.word {
        "figure" => Ok(format!(
            "> Picture `{}`: {} (`raybook tour --only ch{:02}` draws it.)",
            directive.name,
            directive.rest,
            chapter.number()
        )),
        "example" => example(directive.name, directive.rest),
        // A reference would be the answer to an exercise.
        "listing" => {
            let code = book::listing(directive.name)?;
            let file = directive.name.split(':').next().unwrap_or_default();
            Ok(format!("From `{file}`:\n\n```rust\n{code}```"))
        }
        _ => Ok(String::new()),
    }
}

/// A named case of an exercise, or its first: what goes in and what comes out, a line each.
fn example(exercise: &str, name: &str) -> Result<String, String> {
    let unknown = || format!("{exercise} has no case `{name}`");
    let examiner = cases::find(exercise).ok_or_else(unknown)?;
    let cases = examiner.named().map_err(|error| error.to_string())?;
    let case = cases
        .iter()
        .find(|case| name.is_empty() || case.name == name);
    let case = case.ok_or_else(unknown)?;
    let question = row::format(examiner.asked().question, &case.question);
    let answer = examiner
        .answer_line(&question)
        .map_err(|error| error.to_string())?;
    let asked = examiner.question_parts(&question).into_iter();
    let asked = asked.map(|(name, value)| format!("    {name:<14} {value}\n"));
    let answered = examiner.answer_parts(&answer).into_iter();
    let answered = answered.map(|(name, value)| format!("    → {name:<12} {value}\n"));
    let lines: String = asked.chain(answered).collect();
    Ok(format!(
        "The case \"{}\" of `{exercise}`:\n\n{}",
        case.name,
        lines.trim_end()
    ))
}

/// The title of what the book folds, in bold; another line as it is.
fn unfolded(line: &str) -> Cow<'_, str> {
    let folds = line.starts_with("<details") || line.starts_with("</details>");
    let title = line
        .split_once("<summary>")
        .and_then(|(_, title)| title.strip_suffix("</summary>"));
    match title {
        Some(title) => {
            let title = title.replace("<code>", "`").replace("</code>", "`");
            format!("**{title}**").into()
        }
        None if folds => "".into(),
        None => line.into(),
    }
}

/// A line without links to other pages than lessons, and with the names of formulas spelt out.
pub(crate) fn plain(line: &str) -> String {
    let mut text = String::new();
    let mut rest = line;
    while let Some((before, after)) = rest.split_once("](") {
        let Some((target, behind)) = after.split_once(')') else {
            break;
        };
        let is_lesson = target.starts_with("ch") && !target.contains('#');
        match before.rfind('[').filter(|_| !is_lesson) {
            Some(open) => text.extend([&before[..open], &before[open + 1..]]),
            None => text.extend([before, "](", target, ")"]),
        }
        rest = behind;
    }
    text.push_str(rest);
    let names = MACROS.lines().filter(|line| line.starts_with('\\'));
    for (name, meaning) in names.filter_map(|line| line.split_once(':')) {
        text = text.replace(name, meaning);
    }
    text
}

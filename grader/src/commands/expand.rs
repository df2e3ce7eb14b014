//! `raybook expand`: the preprocessor of the course book, which mdBook starts when it builds it.
//!
//! mdBook asks `expand supports html` first, and looks at the exit code. Then it writes a JSON list of a context and the book to
//! standard input, and reads the book from standard output.

use super::Done;
use clap::{Args, Command};
use raybook_chapters::kit::say::say;
use raybook_grader::book::{self, Page};
use serde_json::Value;
use std::path::PathBuf;

/// Expands the directives of the course book (mdBook calls this).
#[derive(Args)]
pub struct Expand {
    /// `supports`, and a renderer's name: whether the pages can be made for it
    question: Vec<String>,
}

impl Expand {
    /// Reads the book, expands it, and writes it; `command` is the whole of `raybook`.
    pub fn run(&self, command: Command) -> Done {
        if !self.question.is_empty() {
            return Ok(self.question == ["supports", "html"]);
        }
        let input: Value = serde_json::from_reader(std::io::stdin().lock())
            .map_err(|error| format!("expected mdBook's JSON on standard input: {error}"))?;
        let Value::Array(parts) = input else {
            return Err("expected a JSON list of a context and a book on standard input".into());
        };
        let [context, mut book] = <[Value; 2]>::try_from(parts)
            .map_err(|parts| format!("expected a context and a book, got {} parts", parts.len()))?;
        let root = context["root"].as_str().unwrap_or(".");
        let mut pages = Vec::new();
        for item in items(&mut book) {
            collect(item, &mut pages);
        }
        let whole = book::Book {
            pictures: PathBuf::from(root).join("src/pictures"),
            pages,
            command,
        };
        for item in items(&mut book) {
            expand_item(item, &whole)?;
        }
        say(book);
        Ok(true)
    }
}

/// The list of a book's or a chapter's parts; mdBook has called a book's `items` since 0.5, and `sections` before.
fn items(of: &mut Value) -> impl Iterator<Item = &mut Value> {
    let key = ["items", "sections", "sub_items"]
        .into_iter()
        .find(|key| of[*key].is_array());
    let list = key.and_then(|key| of[key].as_array_mut());
    list.into_iter().flatten()
}

/// A chapter's page; none for a line between chapters, or the title of a part.
fn page(chapter: &Value) -> Option<Page> {
    Some(Page {
        name: chapter["source_path"].as_str()?.to_owned(),
        text: chapter["content"].as_str()?.to_owned(),
    })
}

/// Adds a chapter's page, and those below it.
fn collect(item: &mut Value, pages: &mut Vec<Page>) {
    let Some(chapter) = item.get_mut("Chapter") else {
        return;
    };
    pages.extend(page(chapter));
    for item in items(chapter) {
        collect(item, pages);
    }
}

/// Expands a chapter and those below it.
fn expand_item(item: &mut Value, book: &book::Book) -> Result<(), book::BookError> {
    let Some(chapter) = item.get_mut("Chapter") else {
        return Ok(());
    };
    if let Some(Page { name, text }) = page(chapter) {
        chapter["content"] = book.expand(&name, &text)?.into();
    }
    for item in items(chapter) {
        expand_item(item, book)?;
    }
    Ok(())
}

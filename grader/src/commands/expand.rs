//! `raybook expand`: the preprocessor of the course book, which mdBook starts when it builds it.
//!
//! mdBook asks `expand supports html` first, and looks at the exit code. Then it writes a JSON list of a context and the book to
//! standard input, and reads the book from standard output.

use super::Done;
use clap::Args;
use raybook_chapters::kit::say::say;
use raybook_grader::book::expand;
use serde_json::Value;
use std::path::{Path, PathBuf};

/// Expands the directives of the course book (mdBook calls this).
#[derive(Args)]
pub struct Expand {
    /// `supports`, and a renderer's name: whether the pages can be made for it
    question: Vec<String>,
}

impl Expand {
    /// Reads the book, expands it, and writes it.
    pub fn run(&self) -> Done {
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
        let pictures = PathBuf::from(root).join("src/pictures");
        for item in items(&mut book) {
            expand_item(item, &pictures)?;
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

/// Expands a chapter and those below it.
fn expand_item(item: &mut Value, pictures: &Path) -> Result<(), Box<dyn std::error::Error>> {
    let Some(chapter) = item.get_mut("Chapter") else {
        return Ok(()); // a line between chapters, or the title of a part
    };
    if let (Some(page), Some(text)) = (chapter["source_path"].as_str(), chapter["content"].as_str())
    {
        chapter["content"] = expand(page, text, pictures)?.into();
    }
    for item in items(chapter) {
        expand_item(item, pictures)?;
    }
    Ok(())
}

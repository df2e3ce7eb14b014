//! The book's pages as they are built, part by part: what directives, links, listings and terms become.

mod citation;
mod code;
mod figure;
mod fit;
mod index;
mod items;
mod kept;
mod order;
mod scene;
mod terms;
mod text;

use clap::Command;
use raybook_grader::book::{Book, Page};
use std::path::Path;

/// A book of these pages: of each, its file and its text.
fn book(pictures: &Path, pages: &[(&str, &str)]) -> Book {
    let page = |(name, text): &(&str, &str)| Page {
        name: (*name).to_owned(),
        text: (*text).to_owned(),
    };
    Book {
        pictures: pictures.to_owned(),
        pages: pages.iter().map(page).collect(),
        command: Command::new("raybook").subcommand(Command::new("check")),
    }
}

/// What a text of a page becomes, without the line end behind it; or what is wrong with it.
fn expanded(book: &Book, page: &str, text: &str) -> Result<String, String> {
    let expanded = book.expand(page, text).map_err(|error| error.what)?;
    Ok(expanded.trim_end_matches('\n').to_owned())
}

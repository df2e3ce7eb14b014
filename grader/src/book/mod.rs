//! The course book's pages, when they are built: each directive becomes what it names, so that no page can drift from the course.
//!
//! A directive stands alone on its line:
//!
//! | directive | what it becomes |
//! |---|---|
//! | `{{figure roots \| alternative text}}` | a figure of this chapter, with the caption that the run which drew it gave it |
//! | `{{example sphere_hit}}`, `{{example sphere_hit \| head on}}` | an exercise's first named case, or the one of this name |
//! | `{{turn}}` | of every exercise of the chapter the task, the signature in four languages, parameters, command, limits |
//! | `{{reference}}`, `{{reference src/render/path.rs:path}}` | of every exercise the reference, folded; another anchor |
//! | `{{listing src/shape/mod.rs:shape}}` | an anchor of the library, open |
//! | `{{mistakes}}` | of every exercise the mistakes: name, message, answer, picture |
//! | `{{scene ch12_phong \| alternative text}}` | the scene that grows, as the functions up to this chapter draw it |
//! | `{{path 1 2 3 12}}` | an order in which these lessons can be read, by what each of them needs |
//! | `{{index glossary.md}}` | the terms of the glossary, with the pages on which each occurs |
//! | `{{library src}}` | the library's files, with their public items |
//! | `{{commands raybook}}` | the commands, with their parameters |
//! | `{{measured proof}}` | what a test measured and wrote down in `golden/measured`: a table, or a sentence of a paragraph |
//!
//! `{{turn sphere_hit}}`, `{{reference sphere_hit}}` and `{{mistakes sphere_hit}}` are of one exercise. A lesson names none, so that an exercise
//! that is added stands in it.
//!
//! Besides, `chapter 7` and `Kajiya 1986` in a text become links, and so do names in back quotes: exercises, commands, files and items of the
//! library. In a listing, the library's names are links. Above a lesson stands how long it takes to read, and which lessons it needs. The
//! terms of the glossary become headings.

mod citation;
pub(crate) mod code;
mod commands;
pub(crate) mod directive;
mod example;
mod figure;
pub(crate) mod fit;
mod index;
pub(crate) mod items;
pub(crate) mod kept;
mod listing;
mod measured;
mod mistakes;
pub(crate) mod names;
mod order;
mod scene;
mod terms;
mod text;
mod turn;

use crate::cases;
use crate::examine::Examiner;
use clap::Command;
use directive::Directive;
use std::path::PathBuf;
use terms::Terms;
use text::Links;

pub use fit::WIDEST;
pub use listing::listing;

/// What is wrong with a page, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("book/src/{page}:{line}: {what}")]
pub struct BookError {
    /// The page's file.
    pub page: String,
    /// The line, from 1.
    pub line: usize,
    /// What is wrong, and what to do.
    pub what: String,
}

/// A page of the book, as it is written.
#[derive(Clone, Debug)]
pub struct Page {
    /// Its file in `book/src`.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// The book whose pages are expanded.
#[derive(Clone, Debug)]
pub struct Book {
    /// The folder of the book's pictures: the captions are read from there, and the mistakes' pictures are written into it.
    pub pictures: PathBuf,
    /// All pages, for the index and the links.
    pub pages: Vec<Page>,
    /// The command `raybook`, with its parameters.
    pub command: Command,
}

impl Book {
    /// The text of a page with its directives expanded.
    ///
    /// # Errors
    /// If a directive is wrong, or a picture cannot be written.
    pub fn expand(&self, page: &str, source: &str) -> Result<String, BookError> {
        let links = Links::of(&self.pages, &self.command);
        let mut expanded = String::with_capacity(2 * source.len());
        let mut fenced = false;
        let mut terms = Terms::default();
        let mut lines = source.lines().zip(1..).peekable();
        while let Some((line, number)) = lines.next() {
            let at = |what| BookError {
                page: page.to_owned(),
                line: number,
                what,
            };
            fenced ^= line.starts_with("```");
            let below = lines.peek().map_or("", |(below, _)| below);
            if let Some((heading, definition)) = terms.heading(line, below) {
                expanded.extend([
                    &heading,
                    "\n",
                    &text::linked(page, definition, &links),
                    "\n",
                ]);
                lines.next();
                continue;
            }
            match directive::read(line).map_err(at)? {
                Some(directive) => {
                    expanded.push_str(&self.become_text(page, &directive, &links).map_err(at)?);
                }
                None if fenced => expanded.push_str(line),
                None if page == citation::BIBLIOGRAPHY => {
                    expanded.push_str(&citation::with_place(line));
                }
                None => expanded.push_str(&text::linked(page, line, &links)),
            }
            expanded.push('\n');
        }
        Ok(text::with_head(page, &expanded, source))
    }

    /// What a directive becomes; without a name, the same of one exercise after the other.
    fn become_text(
        &self,
        page: &str,
        directive: &Directive<'_>,
        links: &Links,
    ) -> Result<String, String> {
        let Directive { word, name, rest } = *directive;
        if name.is_empty() {
            let exercises = directive.exercises(page)?.iter();
            let of_one = exercises.map(|asked| Directive {
                name: asked.name,
                ..*directive
            });
            let parts: Result<Vec<_>, _> = of_one
                .map(|one| self.become_text(page, &one, links))
                .collect();
            return Ok(parts?.join("\n\n"));
        }
        match word {
            "figure" => figure::expand(page, name, rest, &self.pictures),
            "example" => example::expand(exercise(name)?, rest),
            "turn" => turn::expand(page, exercise(name)?, links),
            "reference" => listing::reference(name, links),
            "listing" => listing::open(name, links),
            "mistakes" => mistakes::expand(exercise(name)?, &self.pictures),
            "scene" => scene::expand(name, rest, &self.pictures),
            "path" => order::expand(name),
            "index" => index::expand(name, &self.pages),
            "library" => items::expand(page, name, links),
            "commands" => commands::expand(name, &self.command),
            "measured" => measured::expand(name),
            _ => Err(format!(
                "there is no directive `{word}`; there are figure, example, turn, reference, listing, mistakes, scene, path, index, library, commands and measured"
            )),
        }
    }
}

/// The exercise of this name.
fn exercise(name: &str) -> Result<&'static dyn Examiner, String> {
    cases::find(name).ok_or_else(|| {
        format!("there is no exercise `{name}`; `raybook exercise` lists all that there are")
    })
}

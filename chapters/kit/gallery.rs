//! `index.html`: every chapter's pictures, what they show, what is new, and the command that draws them.

use crate::kit::address;
use crate::kit::html::page;
use crate::kit::stage::Output;
use crate::lesson::Lesson;
use maud::{Markup, html};
use raybook::store::{self, StoreError};
use std::env;
use std::path::{Component, Path, PathBuf};
use std::time::Duration;

/// A chapter that was drawn.
#[derive(Debug)]
pub struct Drawing {
    /// The chapter.
    pub lesson: &'static Lesson,
    /// Its pictures.
    pub outputs: Vec<Output>,
    /// How long it took.
    pub time: Duration,
}

/// The gallery's file in the folder that holds the chapters' folders.
pub fn page_in(folder: &Path) -> PathBuf {
    folder.join("index.html")
}

/// Writes the gallery of these chapters.
///
/// # Errors
/// If the file cannot be written.
pub fn write(folder: &Path, drawings: &[Drawing]) -> Result<(), StoreError> {
    let body = html! {
        h1 { "raybook" }
        p { "A ray-tracing course that you can run. Every picture here was drawn on this machine; click one to see it whole." }
        nav { @for drawing in drawings { a href={ "#" (drawing.lesson.name) } { (drawing.lesson.chapter().number()) " " (drawing.lesson.chapter().title) } } }
        @for drawing in drawings { (section(folder, drawing)) }
    };
    let page = page("raybook: the pictures", &body);
    store::write(&page_in(folder), page.as_bytes())
}

fn section(folder: &Path, drawing: &Drawing) -> Markup {
    let Drawing {
        lesson,
        outputs,
        time,
    } = drawing;
    let chapter = lesson.chapter();
    html! {
        section id=(chapter.name) {
            h2 { "Chapter " (chapter.number()) ": " (chapter.title) }
            p { (lesson.teaches()) }
            p {
                "Run it: " code { "cargo run --release --bin " (chapter.name) }
                " (" (format!("{:.1}", time.as_secs_f32())) " s here" (rays(outputs)) "). New in " code { "src/" } ": "
                @for (i, file) in lesson.new_files().iter().enumerate() { @if i > 0 { ", " } code { (file) } }
                ". The " a href=(lesson_page(folder, chapter.name)) { "lesson" } " explains it, where " code { "book/build" } " has built the book."
            }
            div class="figures" { @for output in outputs { (picture(folder, lesson, output)) } }
        }
    }
}

/// A picture that is also a link to the picture alone, and its caption. The page states the size of the picture, so that the page
/// does not grow while its pictures are loaded.
fn picture(folder: &Path, lesson: &Lesson, output: &Output) -> Markup {
    let file = link(folder, output.svg.as_ref().unwrap_or(&output.png));
    let (width, height) = output.size;
    let name = output.png.file_stem().unwrap_or_default();
    let is_unscaled = lesson.unscaled().iter().any(|one| name == *one);
    html! { figure class=[is_unscaled.then_some("unscaled")] {
        a href=(file) { img src=(file) alt=(output.caption) width=(width) height=(height) loading="lazy"; }
        figcaption {
            (output.caption)
            @if let Some(exr) = &output.exr { " (" a href=(link(folder, exr)) { "EXR" } ")" }
        }
    } }
}

/// The chapter's page of the book, from the gallery's folder: the book is built in the folder in which the course's commands run.
fn lesson_page(folder: &Path, chapter: &str) -> String {
    let page = format!("book/book/{chapter}.html");
    let is_down = |part: &Component| matches!(part, Component::Normal(_) | Component::CurDir);
    if folder.components().all(|part| is_down(&part)) {
        let down = folder
            .components()
            .filter(|part| matches!(part, Component::Normal(_)));
        return "../".repeat(down.count()) + &page;
    }
    let here = env::current_dir().unwrap_or_default();
    address::of_file(&here.join(page))
}

/// ", 1.2 million rays a second": of the main picture, which is the first; nothing where no rays are counted.
pub fn rays(outputs: &[Output]) -> String {
    let rays = outputs.first().and_then(|output| output.rays);
    rays.map_or_else(String::new, |rays| {
        format!(", {:.1} million rays a second", 1e-6 * rays)
    })
}

/// The file as a page in the folder names it, with forward slashes.
fn link(folder: &Path, file: &Path) -> String {
    let relative = file.strip_prefix(folder).unwrap_or(file);
    relative
        .components()
        .map(|c| c.as_os_str().to_string_lossy())
        .collect::<Vec<_>>()
        .join("/")
}

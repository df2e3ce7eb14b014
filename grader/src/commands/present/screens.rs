//! What the page must know: the chapters with their knobs, and a chapter's pictures with their captions.

use raybook::store;
use raybook_chapters::LESSONS;
use raybook_chapters::kit::captions;
use raybook_chapters::kit::knobs::{self, Kind, Knob};
use raybook_chapters::kit::stage::Output;
use raybook_chapters::lesson::Lesson;
use serde_json::{Value, json};
use std::env;
use std::path::Path;

/// Every chapter: its name, number, title, what it teaches, and its knobs.
pub(super) fn course() -> Value {
    LESSONS.iter().map(chapter).collect()
}

fn chapter(lesson: &Lesson) -> Value {
    let chapter = lesson.chapter();
    // A page must not choose files to be read; who wants that has the chapter's command.
    let knobs = knobs::of(&lesson.knobs())
        .into_iter()
        .filter(|knob| knob.kind != Kind::File);
    json!({
        "name": lesson.name,
        "number": chapter.number(),
        "title": chapter.title,
        "teaches": lesson.teaches(),
        "command": command(lesson),
        "unscaled": lesson.unscaled(),
        "knobs": knobs.map(|knob| of_knob(&knob)).collect::<Value>(),
    })
}

/// What stands before the knobs on a command line that draws the chapter: this command, or cargo, if cargo has started it.
fn command(lesson: &Lesson) -> String {
    match env::var_os("CARGO") {
        Some(_) => format!("cargo run --release --bin {} --", lesson.name),
        None => format!("raybook chapter {}", lesson.name),
    }
}

fn of_knob(knob: &Knob) -> Value {
    let (kind, least, most, unit, words) = match &knob.kind {
        Kind::Number(range, unit) => (
            "number",
            Some(*range.start()),
            Some(*range.end()),
            unit.as_str(),
            &[][..],
        ),
        Kind::Choice(words) => ("choice", None, None, "", words.as_slice()),
        Kind::File => ("file", None, None, "", &[][..]),
    };
    json!({
        "name": knob.name, "help": knob.help, "picture": knob.picture, "default": knob.default, "kind": kind,
        "least": least, "most": most, "unit": unit, "words": words,
        "instead": knob.instead_of,
    })
}

/// The pictures of a chapter that the tour drew into this folder, in the order in which it drew them; none if it did not.
pub(super) fn drawn(folder: &Path) -> Option<Value> {
    let text = store::read_text(&captions::file_in(folder)).ok()?;
    let mut pictures: Vec<_> = captions::all(&text).collect();
    if !pictures
        .iter()
        .all(|(name, _)| folder.join(name).with_extension("png").is_file())
    {
        return None; // a picture is missing: all are drawn again
    }
    pictures.sort_by_key(|(name, _)| *name != "picture");
    let screens = pictures
        .into_iter()
        .map(|(name, caption)| json!({ "name": name, "caption": caption }));
    Some(screens.collect())
}

/// Pictures that were just drawn.
pub(super) fn of_outputs(outputs: &[Output]) -> Value {
    let screen = |output: &Output| {
        let name = output.png.file_stem()?.to_str()?;
        Some(json!({ "name": name, "caption": output.caption }))
    };
    outputs.iter().filter_map(screen).collect()
}

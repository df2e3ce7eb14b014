//! `raybook draw` in a workbook that is no copy of the library: the program is asked for every pixel of the chapter's exercises.

use super::Done;
use raybook::image::file;
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::sheet::sheet;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::ask::Asker;
use raybook_grader::cases;
use raybook_grader::converse::{Limits, Program};
use raybook_grader::examine::Examiner;
use raybook_grader::picture::progressive::{Drawn, Stage, draw};
use raybook_grader::student;
use raybook_workbook::curriculum::Chapter;
use std::io;
use std::path::Path;

/// Draws the pictures of a chapter's exercises into `out/`, each beside the reference's; false if one is not written yet, or has pixels
/// without an answer.
pub fn run(workbook: &Path, chapter: &Chapter) -> Done {
    let names = chapter.exercises().iter().map(|exercise| exercise.name);
    let pictured = names.filter_map(cases::find);
    let pictured: Vec<_> = pictured.filter(|e| !e.pictures().is_empty()).collect();
    if pictured.is_empty() {
        let explained = chapter.exercises().last().map_or("", |last| last.name);
        say(format!(
            "No function of chapter {} is asked per pixel, so there is no picture of their answers; `raybook explain {explained}` goes through one, step by step.",
            chapter.number()
        ));
        return Ok(true);
    }
    let program = student::build(workbook)?;
    let folder = workbook.join("out").join(chapter.name);
    let mut all = true;
    for examiner in pictured {
        all &= one(&program, examiner, workbook, &folder)?;
    }
    Ok(all)
}

/// Draws the pictures of an exercise; false if it is not written yet, or a pixel has no answer.
fn one(program: &Program, examiner: &dyn Examiner, workbook: &Path, folder: &Path) -> Done {
    let name = examiner.name();
    let mut asker = Asker::new(program, Limits::default());
    let several = examiner.pictures().len() > 1;
    let mut all = true;
    for picture in 0..examiner.pictures().len() {
        let mut path = folder.join(name).with_extension("png");
        let drawn = draw(&mut asker, examiner, picture, &mut |stage| {
            if several {
                path = folder.join(format!("{name}_{}.png", stage.name));
            }
            keep(stage, &path)
        })?;
        match drawn {
            Drawn::Whole => say(format!("{name}: {}", Untrusted::from(path.as_path()))),
            Drawn::Holes(missing, why) => {
                let path = Untrusted::from(path.as_path());
                say(format!(
                    "{name}: {path}\n  {missing} pixels are magenta, since they have no answer; the first: {why}"
                ));
                all = false;
            }
            Drawn::Nothing(why) => {
                say(format!("{name} is not drawn: {why}."));
                return Ok(false);
            }
            Drawn::NotWritten(missing) => {
                let place = student::place(workbook, &missing);
                let place = place.map_or_else(String::new, |file| format!(" in {file}"));
                let missing = Untrusted::from(missing);
                say(format!(
                    "{name} is not drawn: write {missing} first{place}."
                ));
                return Ok(false);
            }
        }
    }
    Ok(all)
}

/// Writes the picture of the present `stage` beside the picture of the reference.
fn keep(stage: &Stage, path: &Path) -> io::Result<()> {
    let yours = match stage.block {
        1 => "yours".to_owned(),
        block => format!("yours, every {block}th pixel"),
    };
    let tiles = [
        (yours.as_str(), stage.yours.enlarged(6)),
        ("the reference's", stage.golden.enlarged(6)),
    ];
    let sheet = sheet(2, &tiles).map_err(|error| io::Error::other(error.to_string()))?;
    file::save(path, &sheet).map_err(io::Error::other)
}

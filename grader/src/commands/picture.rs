//! `raybook picture`: the picture that grows with the workbook.

use super::Done;
use indicatif::ProgressBar;
use raybook::image::file;
use raybook_chapters::kit::say::{complain, say};
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::capstone::{Functions, PARTS, draw};
use raybook_grader::converse::Limits;
use raybook_grader::student;
use std::io;
use std::path::PathBuf;

/// Draws a scene with the functions that you have written, whatever the language: from chapter 3 on, each new one adds something.
#[derive(clap::Args)]
pub struct Picture {
    /// The workbook's folder
    #[arg(default_value = ".")]
    folder: PathBuf,
    /// The picture's width in pixels; its height is 9/16 of that
    #[arg(long, default_value = "128", value_parser = clap::value_parser!(u32).range(16..=960))]
    width: u32,
}

impl Picture {
    /// Draws it into the workbook's `out/picture.png`; false if there is nothing to be seen yet.
    pub fn run(&self) -> Done {
        let workbook = student::workbook(&self.folder)?;
        let program = student::build(&workbook)?;
        let mut functions = Functions::of(&program, Limits::default())?;
        if !functions.are_there("sphere_hit") {
            let place = student::place(&workbook, "sphere_hit");
            let place = place.map_or_else(String::new, |file| format!(" in {file}"));
            say(functions.why_silent("sphere_hit").map_or_else(
                || format!("Nothing is to be seen yet: write sphere_hit first{place}."),
                |why| format!("Nothing is to be seen yet: of sphere_hit{place}, {why}."),
            ));
            return Ok(false);
        }
        let path = workbook.join("out").join("picture.png");
        let size = [self.width, self.width * 9 / 16];
        // A small picture's pixels are enlarged, so that there is something to look at.
        let times = (768 / self.width).max(1) as usize;
        let bar = ProgressBar::new(4);
        draw(&mut functions, size, &mut |picture, _| {
            bar.inc(1);
            file::save(&path, &picture.enlarged(times)).map_err(io::Error::other)
        })?;
        bar.finish_and_clear();
        say(format!("Your picture: {}", Untrusted::from(path.as_path())));
        for part in &PARTS {
            let silent = functions.why_silent(part.exercise);
            let state = match (functions.are_there(part.exercise), silent) {
                (true, _) if functions.is_wrong(part.exercise) => "wrong  ",
                (true, _) => "written",
                (_, Some(_)) => "failing",
                _ => "not yet",
            };
            say(format!("  {state}  {:<18} {}", part.exercise, part.adds));
        }
        if functions.unanswered > 0 {
            complain(format!(
                "note: {} questions had no answer that can be read; `raybook check` says why",
                functions.unanswered
            ));
        }
        let wrong: Vec<_> = PARTS
            .iter()
            .map(|part| part.exercise)
            .filter(|name| functions.is_wrong(name))
            .collect();
        if !wrong.is_empty() {
            complain(format!(
                "note: pixels are wrong where these functions are asked: `raybook check {}` says why",
                wrong.join(" ")
            ));
        }
        let next = PARTS
            .iter()
            .find(|part| !functions.are_there(part.exercise));
        say(next.map_or_else(
            || "Nothing is missing: every function that it takes is written.".to_owned(),
            |part| {
                let place = student::place(&workbook, part.exercise);
                let place = place.map_or_else(String::new, |file| format!(" in {file}"));
                let function = format!("{}{place}", part.exercise);
                functions.why_silent(part.exercise).map_or_else(
                    || format!("Next: {function} adds {}.", part.adds),
                    |why| format!("Next: mend {function}: {why}."),
                )
            },
        ));
        Ok(true)
    }
}

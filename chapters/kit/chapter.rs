//! The `main` of every chapter binary.

use crate::kit::options::Options;
use crate::kit::say::{complain, lost, say};
use crate::kit::stage::{Drawn, Stage, progress_bar};
use crate::kit::terminal::colourless;
use crate::kit::untrusted::Untrusted;
use crate::lesson::{self, Lesson};
use clap::{Args, CommandFactory, FromArgMatches, Parser};
use raybook_workbook::answer::unwritten;
use std::error::Error;
use std::panic;
use std::process::ExitCode;
use std::sync::Mutex;

/// No options beyond the shared ones.
#[derive(Args, Debug)]
pub struct NoOptions {}

#[derive(Parser)]
struct Command<E: Args> {
    #[command(flatten)]
    options: Options,
    /// Draw the pictures in the terminal too, if standard output is one that has colours
    #[arg(long)]
    show: bool,
    #[command(flatten)]
    extra: E,
}

/// The `main` of a chapter binary: parses the options, draws, and says what was written.
pub fn run(chapter: &'static str, draw: fn(&Stage) -> Drawn) -> ExitCode {
    run_with(chapter, |stage, _: NoOptions| draw(stage))
}

/// As [`run`], for a chapter with options of its own.
pub fn run_with<E: Args>(chapter: &'static str, draw: impl FnOnce(&Stage, E) -> Drawn) -> ExitCode {
    end_at_what_is_unwritten();
    let about = lesson::find(chapter).map_or_else(String::new, Lesson::teaches);
    let matches = Command::<E>::command()
        .name(chapter)
        .about(about)
        .get_matches();
    let command = Command::<E>::from_arg_matches(&matches).unwrap_or_else(|e| e.exit());
    let show = command.show && can_show();
    let stage = Stage::new(chapter, command.options, show, progress_bar());
    match draw(&stage, command.extra) {
        Ok(()) => {
            for output in stage.into_outputs() {
                say(format!(
                    "wrote {}{}",
                    output.png.display(),
                    if output.exr.is_some() {
                        " and .exr"
                    } else {
                        ""
                    }
                ));
            }
            said_all(ExitCode::SUCCESS)
        }
        Err(error) => {
            report(&*error);
            ExitCode::from(2)
        }
    }
}

/// Whether there is a terminal that shows pictures; says why if not.
fn can_show() -> bool {
    let why = colourless();
    if let Some(why) = why {
        complain(format_args!(
            "note: --show shows nothing, because {why}; the pictures are written into files all the same"
        ));
    }
    why.is_none()
}

/// In a student's workbook, a function that is not written yet ends the program with a sentence.
fn end_at_what_is_unwritten() {
    /// Something is missing, as `raybook check` counts it.
    const MISSING: i32 = 1;
    /// Several threads come here at the same time: the first one speaks.
    static SPEAKS: Mutex<()> = Mutex::new(());
    let panics = panic::take_hook();
    panic::set_hook(Box::new(move |info| {
        let Some(name) = unwritten(info.payload()) else {
            return panics(info);
        };
        let _speaks = SPEAKS.lock();
        let place = info.location().map_or_else(String::new, |place| {
            format!(" in {}:{}", place.file(), place.line())
        });
        let name = Untrusted::from(name);
        complain(format_args!(
            "error: this chapter's pictures need {name}, which is not written yet: write it{place}; `raybook exercise {name}` says what it is asked"
        ));
        std::process::exit(MISSING);
    }));
}

/// Prints an error and what caused it. There may be text from outside in them: their lines are lines, and all else is shown.
pub fn report(error: &dyn Error) {
    complain(format_args!("error: {}", lines(error)));
    let mut cause = error.source();
    while let Some(error) = cause {
        complain(format_args!("  because: {}", lines(error)));
        cause = error.source();
    }
}

/// The exit code of work that is done: 2, with the reason, if not all that was said arrived.
pub fn said_all(done: ExitCode) -> ExitCode {
    match lost() {
        None => done,
        Some(error) => {
            complain(format_args!(
                "error: standard output cannot be written: {error}"
            ));
            ExitCode::from(2)
        }
    }
}

fn lines(error: &dyn Error) -> String {
    let text = error.to_string();
    let lines: Vec<_> = text
        .lines()
        .map(|line| Untrusted::from(line).to_string())
        .collect();
    lines.join("\n")
}

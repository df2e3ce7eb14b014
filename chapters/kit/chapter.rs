//! The `main` of every chapter binary.

use crate::kit::stage::{Drawn, Stage, progress_bar};
use crate::kit::{options::Options, say::say};
use crate::lesson::{self, Lesson};
use clap::{Args, CommandFactory, FromArgMatches, Parser};
use raybook_workbook::answer::unwritten;
use std::error::Error;
use std::panic;
use std::process::ExitCode;
use std::sync::Mutex;

/// No options beyond the shared ones.
#[derive(Args)]
pub struct NoOptions {}

#[derive(Parser)]
struct Command<E: Args> {
    #[command(flatten)]
    options: Options,
    /// Draw the pictures in the terminal too
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
    let stage = Stage::new(chapter, command.options, command.show, progress_bar());
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
            ExitCode::SUCCESS
        }
        Err(error) => {
            report(&*error);
            ExitCode::from(2)
        }
    }
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
        eprintln!(
            "error: this chapter's pictures need {name}, which is not written yet: write it{place}; `raybook exercise {name}` says what it is asked"
        );
        std::process::exit(MISSING);
    }));
}

/// Prints an error and what caused it.
pub fn report(error: &dyn Error) {
    eprintln!("error: {error}");
    let mut cause = error.source();
    while let Some(error) = cause {
        eprintln!("  because: {error}");
        cause = error.source();
    }
}

//! The `main` of every chapter binary.

use crate::kit::stage::{Drawn, Stage, progress_bar};
use crate::kit::{options::Options, say::say};
use crate::lesson::{self, Lesson};
use clap::{Args, CommandFactory, FromArgMatches, Parser};
use std::error::Error;
use std::process::ExitCode;

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

/// Prints an error and what caused it.
pub fn report(error: &dyn Error) {
    eprintln!("error: {error}");
    let mut cause = error.source();
    while let Some(error) = cause {
        eprintln!("  because: {error}");
        cause = error.source();
    }
}

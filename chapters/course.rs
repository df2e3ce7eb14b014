//! `cargo run --release -- …`: what a newcomer runs first.
//!
//! The tour needs the chapters only, and nothing else is compiled for it. All other words are passed to the command `raybook`,
//! which also has the grader and is compiled when it is needed.

use clap::Parser;
use raybook_chapters::kit::say::{report, said_all};
use raybook_chapters::tour::Tour;
use std::env;
use std::error::Error;
use std::ffi::OsString;
use std::process::{Command, ExitCode};

/// A ray-tracing course that you can run.
#[derive(Parser)]
#[command(name = "raybook", version)]
enum First {
    /// Draw every chapter's pictures, and a gallery of them
    Tour(Tour),
}

fn main() -> ExitCode {
    let words: Vec<_> = env::args_os().skip(1).collect();
    let done = if words.first().is_some_and(|word| word == "tour") {
        let First::Tour(tour) = First::parse();
        tour.run().map(|()| ExitCode::SUCCESS)
    } else {
        raybook(&words)
    };
    match done {
        Ok(code) => said_all(code),
        Err(error) => {
            report(&*error);
            ExitCode::from(2)
        }
    }
}

/// Has cargo run the command `raybook` with these words, in the profile in which this program was compiled.
fn raybook(words: &[OsString]) -> Result<ExitCode, Box<dyn Error>> {
    let cargo = env::var_os("CARGO").ok_or(
        "this program draws the tour, and has cargo run `raybook` for all else: start it by `cargo run --release --`, or start `raybook`",
    )?;
    let program = env::current_exe()?;
    let folder = program.parent().and_then(|folder| folder.file_name());
    let profile = folder.filter(|&folder| folder != "debug"); // the folder of the profile `dev`
    let mut command = Command::new(cargo);
    command
        .args(["run", "--package", "raybook-grader", "--profile"])
        .arg(profile.unwrap_or("dev".as_ref()))
        .arg("--")
        .args(words);
    run(command)
}

/// Becomes the command, so that keys and signals reach it.
#[cfg(unix)]
fn run(mut command: Command) -> Result<ExitCode, Box<dyn Error>> {
    use std::os::unix::process::CommandExt;
    Err(command.exec().into())
}

/// Runs the command and ends as it does.
#[cfg(not(unix))]
fn run(mut command: Command) -> Result<ExitCode, Box<dyn Error>> {
    let code = command.status()?.code();
    let code = code.and_then(|code| u8::try_from(code).ok());
    Ok(code.map_or(ExitCode::FAILURE, ExitCode::from))
}

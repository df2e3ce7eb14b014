//! A whole picture: raybook's path tracer against that of the crate `rpt`, at the same scene, size, samples and depth, on one thread.
//!
//! The scene is the Cornell box, all matte. Neither is asked about the lamp itself, which `rpt` does not show.

mod race;
mod racers;
mod room;

use clap::Parser;
use race::race;
use raybook::store;
use raybook_common::machine::processor;
use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

/// Races raybook's path tracer against that of the crate rpt
#[derive(Parser)]
struct Options {
    /// Few rounds, and fewer samples in the converged pictures
    #[arg(long)]
    quick: bool,
    /// Rounds; the median of them counts
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    rounds: Option<u16>,
    /// Where pictures.csv goes
    #[arg(long, value_name = "FOLDER", default_value = "target/peers")]
    out: PathBuf,
}

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    let (rounds, reference) = if options.quick { (5, 1024) } else { (21, 4096) };
    let rounds = options.rounds.map_or(rounds, usize::from);
    let race = race(rounds, reference)?;
    let how = [
        format!("{}, one thread", processor()),
        format!(
            "{rounds} rounds; {reference} samples per pixel in the converged pictures; processor time"
        ),
    ];
    let text = race.csv(&how);
    print!("{text}");
    let file = options.out.join("pictures.csv");
    store::write(&file, text.as_bytes())?;
    println!("wrote {}", file.display());
    Ok(())
}

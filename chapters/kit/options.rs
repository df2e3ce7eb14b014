//! The options that every chapter and the tour share.

use clap::builder::Resettable;
use clap::{Args, Command, Error, FromArgMatches};
use raybook::image::rgb::Rgb;
use raybook::memory::{BUDGET, gigabytes};
use std::path::PathBuf;
use std::thread;

/// Width of the widest picture, in pixels: even a square picture of this width can be read again, which takes at most [`BUDGET`].
pub const WIDEST: u32 = 8192;

/// The options that every chapter and the tour share.
#[derive(Args, Clone, Debug)]
pub struct Options {
    /// Width of the pictures in pixels, 8 to 8192; a square picture of 8192 takes 0.8 GB of memory, and about as much again while
    /// it is written [default: 960, or what the chapter can draw in a few seconds]
    #[arg(long, value_parser = width)]
    pub width: Option<u32>,
    /// Samples per pixel [default: 16, or what the chapter can draw in a few seconds]
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub samples: Option<u32>,
    /// Seed of all random numbers: the same seed draws the same pictures, except the few that show measured times
    #[arg(long, default_value = "1", value_parser = seed, allow_negative_numbers = true)]
    pub seed: u64,
    /// Number of threads that draw; the pictures do not depend on this number [default: one per core]
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=1024))]
    pub threads: Option<u32>,
    /// The folder for the pictures; each chapter has a folder of its own in it
    #[arg(long, default_value = "out")]
    pub out: PathBuf,
}

impl Options {
    /// Sets one of the options, and leaves the others: `--samples=4`.
    ///
    /// # Errors
    /// If there is no such option, or its value is out of range.
    pub fn turn(&mut self, argument: &str) -> Result<(), Error> {
        // A default would count as if it were asked for.
        let command = Self::augment_args(Command::new("options").no_binary_name(true))
            .mut_args(|arg| arg.default_value(Resettable::Reset));
        self.update_from_arg_matches(&command.try_get_matches_from([argument])?)
    }

    /// Number of threads that draw: the option, or one per core.
    pub fn threads(&self) -> usize {
        let cores = || thread::available_parallelism().map_or(1, std::num::NonZeroUsize::get);
        self.threads.map_or_else(cores, |threads| threads as usize)
    }
}

/// A seed of random numbers.
///
/// # Errors
/// If it is none.
pub fn seed(text: &str) -> Result<u64, String> {
    text.parse()
        .map_err(|_| format!("a whole number from 0 to {}", u64::MAX))
}

/// A width of pictures.
fn width(text: &str) -> Result<u32, String> {
    let width: u64 = text
        .parse()
        .map_err(|_| format!("a number of pixels, from 8 to {WIDEST}"))?;
    let memory = |width: u64| {
        let pixels = width.saturating_mul(width);
        gigabytes(pixels.saturating_mul(size_of::<Rgb>() as u64))
    };
    match u32::try_from(width) {
        Ok(width @ 8..=WIDEST) => Ok(width),
        Ok(0..8) => Err("a picture is at least 8 pixels wide".to_owned()),
        _ => Err(format!(
            "a square picture of this width takes {} of memory, and a picture may take {}: at most {WIDEST} pixels, {}",
            memory(width),
            gigabytes(BUDGET),
            memory(WIDEST.into()),
        )),
    }
}

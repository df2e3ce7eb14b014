//! The options that every chapter and the tour share.

use clap::Args;
use std::path::PathBuf;
use std::thread;

/// The options that every chapter and the tour share.
#[derive(Args, Clone, Debug)]
pub struct Options {
    /// Width of the pictures in pixels [default: 960, or what the chapter can draw in a few seconds]
    #[arg(long, value_parser = clap::value_parser!(u32).range(8..=16384))]
    pub width: Option<u32>,
    /// Samples per pixel [default: 16, or what the chapter can draw in a few seconds]
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub samples: Option<u32>,
    /// What every random number follows from
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// How many threads draw; the pictures do not depend on it [default: one per core]
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=1024))]
    pub threads: Option<u32>,
    /// The folder for the pictures; each chapter has a folder of its own in it
    #[arg(long, default_value = "out")]
    pub out: PathBuf,
}

impl Options {
    /// How many threads draw: what was asked for, or one per core.
    pub fn threads(&self) -> usize {
        let cores = || thread::available_parallelism().map_or(1, std::num::NonZeroUsize::get);
        self.threads.map_or_else(cores, |threads| threads as usize)
    }
}

//! `raybook samplers`: the sampling lab.

use super::Done;
use raybook::lab::sampling::run::{self, Settings};
use raybook::lab::say::say;
use raybook::sample::pattern::{PATTERNS, Pattern, find};
use std::path::PathBuf;
use std::time::Instant;

/// The patterns that are compared if none are named: as many as there are colours.
const USUAL: &str =
    "regular-grid,rotated-grid,random,jittered,multi-jittered,poisson-disk,sobol-owen";

/// The options of `raybook samplers`.
#[derive(clap::Args)]
pub struct Samplers {
    /// The patterns to compare, or `all`
    #[arg(long, value_delimiter = ',', default_value = USUAL)]
    patterns: Vec<String>,
    /// Points in the point sets, the spectra and the table
    #[arg(long, default_value_t = 256, value_parser = clap::value_parser!(u32).range(1..=4096))]
    points: u32,
    /// Samples per pixel of the pictures and of the polar plots
    #[arg(long, value_delimiter = ',', default_value = "1,4,16", value_parser = clap::value_parser!(u32).range(1..=1024))]
    samples: Vec<u32>,
    /// How often each random pattern is drawn
    #[arg(long, default_value_t = 100, value_parser = clap::value_parser!(u64).range(2..=100_000))]
    realisations: u64,
    /// Width of each of the pictures in pixels
    #[arg(long, default_value_t = 240, value_parser = clap::value_parser!(u32).range(8..=2048))]
    width: u32,
    /// The folder for the page and its figures
    #[arg(long, default_value = "out/samplers")]
    out: PathBuf,
}

impl Samplers {
    /// Measures, draws, and writes the page.
    pub fn run(&self) -> Done {
        let start = Instant::now();
        let whole = |n: &u32| *n as usize;
        let page = run::run(&Settings {
            patterns: self.chosen()?,
            points: whole(&self.points),
            samples: self.samples.iter().map(whole).collect(),
            realisations: self.realisations,
            width: whole(&self.width),
            folder: self.out.clone(),
        })?;
        say(format!(
            "the sampling lab in {:.1} s; look at {}",
            start.elapsed().as_secs_f32(),
            page.display()
        ));
        Ok(true)
    }

    fn chosen(&self) -> Result<Vec<Pattern>, String> {
        if self.patterns.iter().any(|name| name == "all") {
            return Ok(PATTERNS.to_vec());
        }
        let known = || {
            PATTERNS
                .iter()
                .map(|p| p.name)
                .collect::<Vec<_>>()
                .join(", ")
        };
        let pattern = |name: &String| {
            find(name).copied().ok_or_else(|| {
                format!(
                    "--patterns {name}: there is no such pattern; there are all, {}",
                    known()
                )
            })
        };
        self.patterns.iter().map(pattern).collect()
    }
}

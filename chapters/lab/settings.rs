//! What the lab is asked for.

use crate::lab::subject::Subject;
use std::path::PathBuf;

/// What is to be measured, and where the page goes.
#[derive(Debug)]
pub struct Settings {
    /// What is compared.
    pub subjects: Vec<Subject>,
    /// Remarks on the subjects, in sentences.
    pub remarks: Vec<String>,
    /// Points in the point sets, the spectra and the table.
    pub points: usize,
    /// Samples per pixel of the pictures and of the polar plots.
    pub samples: Vec<usize>,
    /// The numbers of points for which the error is measured.
    pub counts: Vec<usize>,
    /// How often each random pattern is drawn.
    pub realisations: u64,
    /// Width of each of the pictures in pixels.
    pub width: usize,
    /// The seed of the functions whose means are taken.
    pub seed: u64,
    /// The seeds of the patterns, as text.
    pub seeds: String,
    /// The command that makes the page.
    pub command: String,
    /// Whether each figure has a screen of its own.
    pub slides: bool,
    /// The folder for the page and its figures.
    pub folder: PathBuf,
}

/// Points in the first of the point sets.
pub const FEW: usize = 16;

/// The numbers of points for which the error is measured, up to a largest one.
pub fn counts(most: usize) -> Vec<usize> {
    let powers = (1..=12).map(|power| 1 << power);
    powers.filter(|n| *n <= most).collect()
}

/// The largest number of points for which the error is measured.
pub const MOST: usize = 4096;

impl Settings {
    /// The numbers of points that every figure of a pattern needs, and the numbers that only make its error curves longer.
    pub fn sizes(&self) -> [Vec<usize>; 2] {
        let needed = [&[FEW, self.points], &self.samples[..]].concat();
        let further = self.counts.iter().copied();
        let further = further.filter(|n| !needed.contains(n)).collect();
        [needed, further]
    }
}

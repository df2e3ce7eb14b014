//! What the lab is asked for.

use crate::lab::subject::Subject;
use std::path::PathBuf;

/// What is to be measured, and where the page goes.
#[derive(Debug)]
pub struct Settings {
    /// What is compared.
    pub subjects: Vec<Subject>,
    /// What there is to say of them, sentences.
    pub remarks: Vec<String>,
    /// Points in the point sets, the spectra and the table.
    pub points: usize,
    /// Samples per pixel of the pictures and of the polar plots.
    pub samples: Vec<usize>,
    /// How often each random pattern is drawn.
    pub realisations: u64,
    /// Width of each of the pictures in pixels.
    pub width: usize,
    /// The folder for the page and its figures.
    pub folder: PathBuf,
}

/// Points in the first of the point sets.
pub const FEW: usize = 16;

/// The numbers of points for which the error is measured.
pub fn counts() -> impl Iterator<Item = usize> {
    (1..=12).map(|power| 1 << power)
}

impl Settings {
    /// The numbers of points without which there is no figure of a pattern, and those that only make its error curves longer.
    pub fn sizes(points: usize, samples: &[usize]) -> [Vec<usize>; 2] {
        let needed = [&[FEW, points], samples].concat();
        let further = counts().filter(|n| !needed.contains(n)).collect();
        [needed, further]
    }
}

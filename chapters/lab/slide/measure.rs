//! What is measured of the compared patterns, and which pattern is the best and the worst in each measure.

use super::MANY;
use crate::lab::errors::{EACH, errors};
use crate::lab::integrands::CLASSES;
use crate::lab::pixels::correlation;
use crate::lab::polar::{Curve, Polar};
use crate::lab::settings::Settings;
use crate::lab::spectrum::Spectrum;
use crate::lab::subject::Subject;
use raybook::math::pcg;

/// A measure, of which a smaller number is better: its name, and a number for each pattern.
#[derive(Clone, Debug)]
pub struct Measure {
    /// What is measured.
    pub name: String,
    /// Digits behind the point.
    pub digits: usize,
    /// The patterns' numbers, in order.
    pub numbers: Vec<f64>,
}

impl Measure {
    /// The index of the best pattern; `None` if another pattern is about as good.
    pub fn winner(&self) -> Option<usize> {
        let [first, next, ..] = self.in_order()[..] else {
            return None;
        };
        (self.numbers[first] < ALIKE * self.numbers[next]).then_some(first)
    }

    /// The index of the worst pattern; `None` if another pattern is about as bad.
    pub fn loser(&self) -> Option<usize> {
        let [.., next, last] = self.in_order()[..] else {
            return None;
        };
        (self.numbers[next] < ALIKE * self.numbers[last]).then_some(last)
    }

    /// The patterns from the best to the worst.
    fn in_order(&self) -> Vec<usize> {
        let mut order: Vec<_> = (0..self.numbers.len()).collect();
        order.sort_by(|i, j| self.numbers[*i].total_cmp(&self.numbers[*j]));
        order
    }
}

/// Two numbers are alike if the smaller is at least this share of the larger.
const ALIKE: f64 = 0.97;

/// The lines of the table.
pub fn measures(
    subjects: &[Subject],
    [four, sixteen]: &[Polar; 2],
    spectra: &[Spectrum],
    settings: &Settings,
) -> Vec<Measure> {
    let draws = settings.realisations as usize;
    let class =
        |i: usize| CLASSES[i].members(EACH * draws, &mut pcg::stream(settings.seed, i as u64));
    let [disc, edge, smooth] = [0, 1, 2].map(class);
    let medians = |n, functions: &Vec<_>| {
        let classes = std::slice::from_ref(functions);
        let median = |s: &Subject| 1e3 * errors(s, n, classes, draws)[0].median;
        subjects.iter().map(median).collect()
    };
    let polar = |polar: &Polar, of: fn(&Curve) -> f64| {
        polar.curves.iter().map(|curve| 1e3 * of(curve)).collect()
    };
    let line = |name: &str, digits, numbers| Measure {
        name: name.to_owned(),
        digits,
        numbers,
    };
    vec![
        line(
            "edges, 4 samples, all angles: error in ‰",
            0,
            polar(four, Curve::mean),
        ),
        line(
            "edges, 4 samples, along the axes: ‰",
            0,
            polar(four, Curve::along_axes),
        ),
        line(
            "edges, 16 samples, all angles: ‰",
            1,
            polar(sixteen, Curve::mean),
        ),
        line(
            "edges, 16 samples, worst angle: ‰",
            1,
            polar(sixteen, Curve::worst),
        ),
        line(
            "discs, 256 samples: median error in ‰",
            2,
            medians(MANY, &disc),
        ),
        line(
            "smooth functions, 256 samples: ‰",
            3,
            medians(MANY, &smooth),
        ),
        line(
            "coarse noise: mean power below the Nyquist frequency",
            2,
            spectra.iter().map(coarse).collect(),
        ),
        line(
            "highest alias: power of one frequency",
            1,
            spectra.iter().map(highest).collect(),
        ),
        line(
            "same error in neighbouring pixels: |ρ|, 16 samples",
            2,
            subjects
                .iter()
                .map(|s| correlation(s, 16, &edge).abs())
                .collect(),
        ),
    ]
}

/// The mean power below √n/2, the Nyquist frequency of a regular grid.
fn coarse(spectrum: &Spectrum) -> f64 {
    let radial = spectrum.radial();
    let below = &radial[..MANY.isqrt() / 2];
    let (power, area) = below.iter().fold((0.0, 0.0), |(power, area), k| {
        (power + k.frequency * k.value, area + k.frequency)
    });
    power / area
}

/// The highest power of a spectrum, but for frequency 0.
fn highest(spectrum: &Spectrum) -> f64 {
    let limit = spectrum.limit as i32;
    let all = (-limit..=limit).flat_map(|y| (-limit..=limit).map(move |x| (x, y)));
    let powers = all.filter(|f| *f != (0, 0)).map(|(x, y)| spectrum.at(x, y));
    powers.fold(0.0, f64::max)
}

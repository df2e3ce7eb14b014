//! The race: pairs of pictures, their times and errors, and the ratio with its spread.

use crate::racers::{DEPTH, EDGE, Ours, Theirs};
use crate::room::room;
use rustix::time::{ClockId, clock_gettime};
use std::error::Error;
use std::fmt::Write;

/// Samples per pixel of a picture that races.
const SAMPLES: u32 = 16;

/// How many times as long as ours the other one takes for a picture with the same error; and what that is made of.
pub(crate) struct Race {
    /// The ratios of all rounds.
    ratios: Vec<f64>,
    /// Seconds and mean square errors of all rounds: ours, and the other's.
    runs: [Vec<(f64, f64)>; 2],
    /// The mean of the other's converged picture over that of ours: 1 if both draw the same.
    same: f64,
}

/// Races for a number of rounds; `reference` is the number of samples of the converged pictures.
pub(crate) fn race(rounds: usize, reference: u32) -> Result<Race, Box<dyn Error>> {
    let (quads, lamp) = room();
    let (ours, theirs) = (Ours::new(&quads, lamp), Theirs::new(&quads, lamp)?);
    let truths = [ours.draw(reference, 1), theirs.draw(reference)];
    // Where the lamp is seen, ours is white and the other's is not.
    let counts: Vec<_> = truths[0].iter().map(|v| *v < 0.999).collect();
    let mean = |picture: &[f32]| -> f64 {
        let seen = picture.iter().zip(&counts).filter(|(_, counts)| **counts);
        seen.map(|(v, _)| f64::from(*v)).sum()
    };
    let same = mean(&truths[1]) / mean(&truths[0]);
    let error = |picture: &[f32], truth: &[f32]| {
        let all = picture.iter().zip(truth).zip(&counts);
        let squares = all
            .filter(|(_, counts)| **counts)
            .map(|((a, e), _)| f64::from(a - e).powi(2));
        squares.sum::<f64>() / counts.iter().filter(|counts| **counts).count() as f64
    };
    let (mut ratios, mut runs) = (Vec::new(), [Vec::new(), Vec::new()]);
    for round in 0..rounds {
        let run = |other: bool| {
            let begun = seconds();
            let picture = if other {
                theirs.draw(SAMPLES)
            } else {
                ours.draw(SAMPLES, 2 + round as u64)
            };
            (
                seconds() - begun,
                error(&picture, &truths[usize::from(other)]),
            )
        };
        // Who begins, changes.
        let first = round % 2 == 1;
        let pair = [run(first), run(!first)];
        let [of_ours, of_theirs] = if first { [pair[1], pair[0]] } else { pair };
        ratios.push(of_theirs.0 * of_theirs.1 / (of_ours.0 * of_ours.1));
        runs[0].push(of_ours);
        runs[1].push(of_theirs);
    }
    Ok(Race { ratios, runs, same })
}

impl Race {
    /// The median ratio, and below which a tenth and nine tenths of the rounds are.
    fn ratio(&self) -> [f64; 3] {
        [0.5, 0.1, 0.9].map(|part| quantile(self.ratios.clone(), part))
    }

    /// The rows of `pictures.csv`; `how` says where it was measured.
    pub(crate) fn csv(&self, how: &[String]) -> String {
        let mut text = how
            .iter()
            .fold(String::new(), |text, line| text + "# " + line + "\n");
        text.push_str(
            "scene,edge,samples,depth,path_tracer,seconds,rms_error,mean,ratio,ratio_10,ratio_90\n",
        );
        for (name, runs, mean, [ratio, low, high]) in [
            ("raybook", &self.runs[0], 1.0, [1.0; 3]),
            ("rpt", &self.runs[1], self.same, self.ratio()),
        ] {
            let time = median(runs.iter().map(|run| run.0).collect());
            let error = median(runs.iter().map(|run| run.1.sqrt()).collect());
            let _ = writeln!(
                text,
                "Cornell box,{EDGE},{SAMPLES},{DEPTH},{name},{time:.4},{error:.5},{mean:.4},{ratio:.3},{low:.3},{high:.3}"
            );
        }
        text
    }
}

fn median(numbers: Vec<f64>) -> f64 {
    quantile(numbers, 0.5)
}

/// The number below which this part of all is; between two of them, on the line from one to the other.
fn quantile(mut numbers: Vec<f64>, part: f64) -> f64 {
    numbers.sort_by(f64::total_cmp);
    let at = part * (numbers.len() - 1) as f64;
    let (low, high) = (numbers[at.floor() as usize], numbers[at.ceil() as usize]);
    low + at.fract() * (high - low)
}

/// Seconds of processor time that this program has had.
fn seconds() -> f64 {
    let now = clock_gettime(ClockId::ProcessCPUTime);
    now.tv_sec as f64 + 1e-9 * now.tv_nsec as f64
}

//! What the judge, the right rule and the wrong ones are made of.

use crate::Verdict;
use raybook_workbook::exercises::ch23_adaptive::NeedsMore;

/// The largest and the least of some values.
pub fn range(values: &[f32]) -> [f32; 2] {
    let values = || values.iter().copied();
    [
        values().fold(0.0, f32::max),
        values().fold(f32::INFINITY, f32::min),
    ]
}

/// (max − min)/(max + min), 0 for black.
pub fn ratio([max, min]: [f32; 2]) -> f32 {
    if max > 0.0 {
        (max - min) / (max + min)
    } else {
        0.0
    }
}

/// Σ (Y − mean)².
pub fn squares(values: &[f32]) -> f32 {
    let mean = values.iter().sum::<f32>() / values.len() as f32;
    values.iter().map(|y| (y - mean).powi(2)).sum()
}

/// s/√n of the luminance.
pub fn standard_error(q: &NeedsMore) -> f32 {
    let n = q.samples.len() as f32;
    let luminances: Vec<_> = q.samples.iter().map(|s| s.luminance()).collect();
    (squares(&luminances) / (n - 1.0) / n).sqrt()
}

/// Whether the answer is right, and else which numbers decide.
pub fn verdict(q: &NeedsMore, golden: u32, got: u32) -> Verdict {
    if golden == got {
        return Ok(());
    }
    if got > 1 {
        return Err(format!(
            "the answer is 1 for more and 0 for enough, not {got}"
        ));
    }
    let [r, g, b] = [0, 1, 2].map(|channel| {
        let values: Vec<_> = q.samples.iter().map(|s| s.channels()[channel]).collect();
        ratio(range(&values))
    });
    let numbers = format!(
        "the contrasts are {r:.3}, {g:.3} and {b:.3}, and the standard error is {:.4}",
        if q.samples.len() < 2 {
            0.0
        } else {
            standard_error(q)
        }
    );
    if golden == 1 {
        Err(format!(
            "the pixel needs more samples: it has {}, {numbers}",
            q.samples.len()
        ))
    } else {
        Err(format!("the samples are enough: {numbers}"))
    }
}

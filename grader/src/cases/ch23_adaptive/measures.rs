//! What the right rule and the wrong ones are made of.

use crate::Verdict;
use raybook_workbook::exercises::ch23_adaptive::NeedsMore;

/// The largest and the least of a channel.
pub fn range(q: &NeedsMore, channel: usize) -> [f32; 2] {
    let values = || q.samples.iter().map(|s| s.channels()[channel]);
    [
        values().fold(0.0, f32::max),
        values().fold(f32::INFINITY, f32::min),
    ]
}

/// Whether any channel's contrast is too large, by whatever the caller calls contrast.
pub fn too_contrasty(q: &NeedsMore, contrast: impl Fn([f32; 2]) -> f32) -> bool {
    let limits = q.contrast.channels();
    (0..3).any(|channel| contrast(range(q, channel)) > limits[channel])
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
pub fn squares(q: &NeedsMore) -> f32 {
    let n = q.samples.len() as f32;
    let mean = q.samples.iter().map(|s| s.luminance()).sum::<f32>() / n;
    q.samples
        .iter()
        .map(|s| (s.luminance() - mean).powi(2))
        .sum()
}

/// The answer, from the two rules.
pub fn decide(q: &NeedsMore, contrast: bool, error: f32) -> u32 {
    u32::from(q.samples.len() < 2 || contrast || error > q.error)
}

/// s/√n of the luminance.
pub fn standard_error(q: &NeedsMore) -> f32 {
    let n = q.samples.len() as f32;
    (squares(q) / (n - 1.0) / n).sqrt()
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
    let contrast = [0, 1, 2].map(|channel| ratio(range(q, channel)));
    let [r, g, b] = contrast;
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

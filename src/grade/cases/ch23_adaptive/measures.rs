//! What the right rule and the wrong ones are made of.

use crate::workbook::exercises::ch23_adaptive::NeedsMoreQuestion;

/// The largest and the least of a channel.
pub fn range(q: &NeedsMoreQuestion, channel: usize) -> [f32; 2] {
    let values = || q.samples.iter().map(|s| s.channels()[channel]);
    [
        values().fold(0.0, f32::max),
        values().fold(f32::INFINITY, f32::min),
    ]
}

/// Whether any channel's contrast is too large, by whatever the caller calls contrast.
pub fn too_contrasty(q: &NeedsMoreQuestion, contrast: impl Fn([f32; 2]) -> f32) -> bool {
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
pub fn squares(q: &NeedsMoreQuestion) -> f32 {
    let n = q.samples.len() as f32;
    let mean = q.samples.iter().map(|s| s.luminance()).sum::<f32>() / n;
    q.samples
        .iter()
        .map(|s| (s.luminance() - mean).powi(2))
        .sum()
}

/// The answer, from the two rules.
pub fn decide(q: &NeedsMoreQuestion, contrast: bool, error: f32) -> u32 {
    u32::from(q.samples.len() < 2 || contrast || error > q.error)
}

/// s/√n of the luminance.
pub fn standard_error(q: &NeedsMoreQuestion) -> f32 {
    let n = q.samples.len() as f32;
    (squares(q) / (n - 1.0) / n).sqrt()
}

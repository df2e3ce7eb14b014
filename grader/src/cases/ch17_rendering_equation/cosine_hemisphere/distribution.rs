//! How directions are distributed over the hemisphere, and what is wrong with it: gaps, crowds, a rule in their angles, other heights.

use crate::Verdict;
use crate::together::widest_gap;
use glam::Vec3;
use raybook::math::basis::Basis;
use raybook_workbook::exercises::ch17_rendering_equation::CosineHemisphere;
use std::f32::consts::TAU;

/// By how much the mean of (d·a)² is greater than it should be, for an axis a of the world: ½ (n·a)² + ¼ (1 − (n·a)²).
pub(super) fn leans(q: &CosineHemisphere, got: &[Vec3], axis: Vec3) -> f64 {
    let squares = got.iter().map(|d| f64::from(d.dot(axis)).powi(2));
    let mean = squares.sum::<f64>() / got.len().max(1) as f64;
    let along = f64::from(q.normal.dot(axis)).powi(2);
    mean - 0.25 * (1.0 + along)
}

/// Number of directions of a further question: enough that a gap among them is none by chance.
pub(super) const MANY: u32 = 1000;

/// Whether many directions leave no gap on their way round the normal, nor between their heights.
///
/// Measured for n from 500 to 1000 and the disc by rings or by squares, with the numbers exchanged or not, no gap is wider than 13 directions'
/// share.
pub(super) fn fills(q: &CosineHemisphere, got: &[Vec3]) -> Verdict {
    const SHARE: f64 = 20.0;
    let basis = Basis::around(q.normal);
    let bound = SHARE / got.len().max(1) as f64;
    let turns = || {
        let turn = |d: &Vec3| d.dot(*basis.y).atan2(d.dot(*basis.x));
        got.iter().map(move |d| f64::from(turn(d) / TAU))
    };
    let [from, to] = widest_gap(turns().chain(turns().map(|turn| turn + 1.0)));
    if to - from > bound {
        return Err(format!(
            "none of {} directions is in a wedge of {:.1}° round the normal",
            got.len(),
            360.0 * (to - from)
        ));
    }
    let heights = got
        .iter()
        .map(|d| f64::from(d.dot(*q.normal).min(1.0).powi(2)));
    let [from, to] = widest_gap(heights.chain([0.0, 1.0]));
    if to - from > bound {
        let [from, to] = [from, to].map(|h| h.sqrt().asin().to_degrees());
        return Err(format!(
            "none of {} directions is {from:.1}° to {to:.1}° above the surface",
            got.len()
        ));
    }
    Ok(())
}

/// What is wrong if many directions, but no more than half of them, are at one height. Every point of the square has a height of its own; by Shirley
/// and Chiu's map (1997) two or four may have the same one.
pub(super) fn crowd(q: &CosineHemisphere, got: &[Vec3]) -> Option<String> {
    const MANY: usize = 5;
    /// What single precision and printing leave of the same cos²θ. That of neighbours among 1000 directions differs by a hundred times as much.
    const SAME: f64 = 1e-5;
    let square = |d: &Vec3| f64::from(d.dot(*q.normal)).powi(2);
    let mut squares: Vec<_> = got.iter().map(square).collect();
    squares.sort_by(f64::total_cmp);
    let at = |i: usize| squares[i..].partition_point(|v| *v < squares[i] + SAME);
    let most = (0..squares.len()).max_by_key(|i| at(*i))?;
    let count = at(most);
    let height = squares[most].min(1.0).sqrt().asin().to_degrees();
    (MANY..=got.len() / 2).contains(&count).then(|| {
        format!(
            "{count} of {} directions are at one height, {height:.1}° over the horizon",
            got.len()
        )
    })
}

/// Whether the angle round the normal grows from height to height by steps that are not always longer or shorter than the one before by the same amount, as
/// those of i² are. Those of the task's number are equal, and those of Shirley and Chiu's map (1997) have no rule.
pub(super) fn by_equal_steps(local: &[Vec3]) -> Verdict {
    let n = local.len() as f32;
    let mut sorted = local.to_vec();
    sorted.sort_by(|a, b| b.z.total_cmp(&a.z));
    let turns = sorted.iter().map(|d| d.y.atan2(d.x) / TAU);
    let turns: Vec<_> = turns.collect();
    let wrapped = |turn: f32| turn - turn.round();
    let more = |three: &[f32]| wrapped(three[2] - 2.0 * three[1] + three[0]);
    let mut more = turns.windows(3).map(more);
    let Some(first) = more.next() else {
        return Ok(());
    };
    // The steps of i²/n, the smallest that are likely, differ by 2/n.
    if first.abs() < 1.0 / n || more.any(|more| wrapped(more - first).abs() > 0.25 / n) {
        return Ok(());
    }
    Err(format!(
        "from height to height, each step of the angle differs by {:.3} of a turn from the step before: that is a square of i",
        first.abs()
    ))
}

/// Whether directions, in coordinates whose z is the normal, are distributed by its cosine.
pub(super) fn distributed(local: &[Vec3]) -> Verdict {
    const BOUND: f32 = 0.08;
    let expected = local.len();
    let mean = |f: fn(&Vec3) -> f32| local.iter().map(f).sum::<f32>() / expected as f32;
    // Round the normal first: who does not go evenly round has no right heights either, where the axes beside it are wrong.
    for (name, got, exact) in [
        ("the mean to one side", mean(|d| d.x), 0.0),
        ("the mean to the other side", mean(|d| d.y), 0.0),
        (
            "the mean of (x² − y²)/2",
            mean(|d| 0.5 * (d.x * d.x - d.y * d.y)),
            0.0,
        ),
        ("the mean of xy", mean(|d| d.x * d.y), 0.0),
        ("the mean of cos θ", mean(|d| d.z), 2.0 / 3.0),
        ("the mean of cos²θ", mean(|d| d.z * d.z), 0.5),
    ] {
        if (got - exact).abs() > BOUND {
            return Err(format!(
                "{name} is {got:.3} and should be {exact:.3} (x and y are perpendicular to the normal)"
            ));
        }
    }
    // cos²θ ≤ h has the probability h: the disc's area outside the radius √(1 − h).
    let mut heights: Vec<_> = local.iter().map(|d| d.z * d.z).collect();
    heights.sort_by(f32::total_cmp);
    for (i, h) in heights.iter().enumerate() {
        let (below, up_to) = (i as f32 / expected as f32, (i + 1) as f32 / expected as f32);
        if below - h > BOUND || h - up_to > BOUND {
            let degrees = h.clamp(0.0, 1.0).sqrt().asin().to_degrees();
            return Err(format!(
                "{:.0} % of the directions are less than {degrees:.0}° above the surface; {:.0} % should be",
                100.0 * below,
                100.0 * h
            ));
        }
    }
    Ok(())
}

/// What is wrong where all heights are half a step of the lattice off, and what leads to it.
pub(super) const TOO_STEEP: &str = "leaves out the halves of the lattice, or takes 1 for them, so that all directions are a little too steep";
pub(super) const TOO_FLAT: &str = "leaves out the halves of the lattice, or takes 1 for them, so that all directions are a little too flat";
pub(super) const HALVES: &str = "The first of n cells goes from 0 to 1/n: where is its middle?";

/// By which part of a lattice's step the heights of each answer are off, if it is the same for all of them: cos²θ is 1 − u there. Another density is
/// off by as much whatever n is, which is no part of a step.
pub(super) fn steps_off(answers: &[(CosineHemisphere, Vec<Vec3>)]) -> Option<f64> {
    const CLOSE: f64 = 0.05;
    let off = |(q, got): &(CosineHemisphere, Vec<Vec3>)| -> f64 {
        let square = |d: &Vec3| f64::from(q.normal.dot(*d)).powi(2);
        got.iter().map(square).sum::<f64>() - 0.5 * f64::from(q.n)
    };
    let all: Vec<_> = answers.iter().map(off).collect();
    let first = *all.first()?;
    let is_same = |off: &f64| (off - first).abs() < CLOSE;
    all.iter().all(is_same).then_some(first)
}

//! How samples are judged.
//!
//! They are judged by their distribution: any right way to spread them passes. An 8 × 8 lattice that is spread by a
//! concentric disc has a mean that is 0.016 off and a variance that is 0.010 off; other right ways are closer. A disc inside a
//! square has a variance that is 0.021 off. What is hidden by so few samples shows in a finer lattice, which is asked of who is right.

use crate::traits::{log, of_square};
use crate::{Verdict, judge};
use glam::DVec2;
use raybook_workbook::exercises::ch16_soft_shadows::Chosen;

/// So fine are the lattices.
pub(super) const N: u32 = 8;

/// So fine are those that are asked of who is right with others: 3 % of a side or of a cone show there.
pub(super) const FINE: u32 = 4 * N;

/// What is done to a question whose lattice is finer.
pub(super) const FINER: &str = "with four times as many points along each side";

/// The mean of places may be off by this, in cells of the lattice. It tells a lattice without its ½, which is 0.5 off, from one with it,
/// and from one that is moved by 0.4 of a cell and wrapped round.
pub(super) const MEAN: f64 = 0.45;

/// An angle counts from anywhere, so its lattice may begin anywhere in a cell.
pub(super) const MEAN_ANGLE: f64 = 0.64;

/// The variance of places may be off by this, in cells.
const SPREAD: f64 = 0.12;

/// A density may be off by this share: naive formulas lose a few digits.
pub(super) const DENSITY: f32 = 5e-3;

/// How many traits an answer has.
pub(super) const TRAITS: usize = 27;

/// Samples of which each is changed.
pub(super) fn changed(mut all: Vec<Chosen>, change: impl FnMut(&mut Chosen)) -> Vec<Chosen> {
    all.iter_mut().for_each(change);
    all
}

/// By what mistakes differ: where the samples are in the unit square, their densities by the right ones, and their radiance.
pub(super) fn traits(
    radiance: f32,
    got: &[Chosen],
    places: &[DVec2],
    right: impl Fn(&Chosen) -> f32,
) -> Vec<f64> {
    let n = got.len().max(1) as f64;
    let mean = |f: &dyn Fn(&Chosen) -> f32| got.iter().map(|c| log(f(c).into())).sum::<f64>() / n;
    let density = |c: &Chosen| log((c.pdf / right(c)).into());
    let average = mean(&|c| c.pdf / right(c));
    let scatter = got
        .iter()
        .map(|c| (density(c) - average).powi(2))
        .sum::<f64>()
        / n;
    let mut all = of_square(places);
    all.extend([
        average,
        scatter.sqrt(),
        mean(&|c| c.arriving * c.pdf / radiance),
    ]);
    all.extend([mean(&|c| c.toward.length()), got.len() as f64 / 64.0]);
    all
}

/// Whether the places to which a square lattice is mapped in the unit square are spread evenly, as their means, which `may_be_off` bounds in
/// cells, their variances and their counts tell.
pub(super) fn evenly(what: &str, places: &[DVec2], may_be_off: DVec2) -> Verdict {
    let n = places.len() as f64;
    let cell = n.sqrt().recip();
    let mean = places.iter().sum::<DVec2>() / n;
    let off = |p: &DVec2| *p - mean;
    let variance = places.iter().map(|p| off(p) * off(p)).sum::<DVec2>() / n;
    let covariance = places.iter().map(|p| off(p).element_product()).sum::<f64>() / n;
    if (mean - 0.5).abs().cmpgt(cell * may_be_off).any() {
        return Err(format!(
            "{what} are not uniform: their mean is {:.3} of the way across and {:.3} of the way along",
            mean.x, mean.y
        ));
    }
    let apart = (variance - 1.0 / 12.0).abs().max_element();
    if apart.max(covariance.abs()) > cell * SPREAD {
        return Err(format!(
            "{what} are not uniform: they are too close together, or too far apart, or on a line"
        ));
    }
    let mut quarters = [0; 4];
    for p in places {
        quarters[usize::from(p.x > 0.5) + 2 * usize::from(p.y > 0.5)] += 1;
    }
    let expected = places.len() / 4;
    if quarters
        .iter()
        .any(|count| !(expected / 2..=2 * expected).contains(count))
    {
        return Err(format!(
            "{what} are not uniform: of four equal parts, one has {} and another {}, and not about {expected} each",
            quarters.iter().min().unwrap_or(&0),
            quarters.iter().max().unwrap_or(&0),
        ));
    }
    Ok(())
}

/// The number of samples, and what each says of itself.
pub(super) fn each(
    n: u32,
    radiance: f32,
    got: &[Chosen],
    check: impl Fn(&Chosen) -> Verdict,
) -> Verdict {
    if got.len() != (n * n) as usize {
        return Err(format!(
            "there are {} samples, and should be {}",
            got.len(),
            n * n
        ));
    }
    for (i, chosen) in got.iter().enumerate() {
        let sample = || {
            judge::direction(
                "the direction",
                chosen.toward.normalize_or_zero(),
                chosen.toward,
            )?;
            check(chosen)?;
            let arriving = radiance / chosen.pdf;
            let tolerance = DENSITY * arriving.abs();
            judge::number_within("radiance/density", "", arriving, chosen.arriving, tolerance)
        };
        sample().map_err(|why| format!("sample {i}: {why}"))?;
    }
    Ok(())
}

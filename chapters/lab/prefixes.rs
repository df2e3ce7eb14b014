//! Progressive patterns: how good the first k of n points are.

use crate::kit::of_each::of_each;
use crate::lab::discrepancy::l2_star_squared;
use crate::lab::subject::Subject;

/// The numbers of points at which a pattern of n is cut: the powers of 2 and the middles between them, and n.
pub fn cuts(n: usize) -> Vec<usize> {
    let powers = (1..usize::BITS).map(|power| 1_usize << power);
    let both = powers.flat_map(|k| [k, k + k / 2]);
    let mut cuts: Vec<_> = both.take_while(|k| *k < n).collect();
    cuts.push(n);
    cuts
}

/// The root of the mean squared L₂ star discrepancy of the first k of n points, at every cut.
///
/// k independent points have √(5/(36k)). A pattern with a smaller discrepancy for every k is progressive: a renderer may stop
/// after any sample (Christensen, Kensler and Kilpatrick, *Progressive multi-jittered sample sequences*, 2018). A grid in rows is
/// not: its first points are all at the top.
pub fn discrepancy(subject: &Subject, n: usize, realisations: u64) -> Vec<(usize, f64)> {
    let realisations = subject.realisations(n, realisations);
    let all = of_each(realisations as usize, |number| {
        let points = subject.points(n, number as u64);
        let squared = |k: usize| l2_star_squared(&points[..k.min(points.len())]);
        cuts(n).into_iter().map(squared).collect::<Vec<_>>()
    });
    let mean = |i: usize| all.iter().map(|one| one[i]).sum::<f64>() / all.len().max(1) as f64;
    let root = |(i, k)| (k, mean(i).max(0.0).sqrt());
    cuts(n).into_iter().enumerate().map(root).collect()
}

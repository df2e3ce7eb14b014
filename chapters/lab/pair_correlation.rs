//! The pair correlation function: how often two points are at a given distance, compared with random points.

use crate::kit::of_each::of_each;
use crate::lab::subject::Subject;
use raybook::inside::Space;
use std::f64::consts::PI;

/// Bins for each mean distance 1/√n.
const BINS: usize = 16;

/// The longest distance, in mean distances 1/√n. Over the edges, a circle with a radius of more than half a side of the square
/// would overlap itself.
const REACH: f64 = 4.0;

/// g(r): the number of pairs of points at the distance r, divided by the number that independent points have.
///
/// g(r) = pairs between r₁ and r₂ / (n(n − 1)/2 · π(r₂² − r₁²)), distances measured over the edges too. Random points have g = 1
/// everywhere; where g is 0, no two points are so near; a peak is a distance that the pattern prefers
/// (Öztireli and Gross, *Analysis and synthesis of point distributions based on pair correlation*, 2012).
///
/// The points of the curve are (r·√n, g), r in the middle of a bin.
pub fn pair_correlation(subject: &Subject, n: usize, realisations: u64) -> Vec<(f64, f64)> {
    let unit = 1.0 / (n as f64).sqrt();
    let bins = ((REACH * unit).min(0.5) / unit * BINS as f64) as usize;
    let width = unit / BINS as f64;
    let realisations = subject.realisations(n, realisations);
    let counted = of_each(realisations as usize, |number| {
        let points = subject.points(n, number as u64);
        let mut counts = vec![0_u64; bins];
        for (i, p) in points.iter().enumerate() {
            for q in &points[..i] {
                let distance = Space::Torus.distance_squared(*p, *q).sqrt();
                if let Some(count) = counts.get_mut((distance / width) as usize) {
                    *count += 1;
                }
            }
        }
        counts
    });
    let counts = (0..bins).map(|bin| counted.iter().map(|counts| counts[bin]).sum());
    let counts: Vec<u64> = counts.collect();
    let pairs = 0.5 * (n as f64) * (n as f64 - 1.0) * realisations as f64;
    let of = |(i, count): (usize, &u64)| {
        let [near, far] = [i, i + 1].map(|edge| edge as f64 * width);
        let expected = pairs * PI * (far * far - near * near);
        let middle = 0.5 * (near + far) / unit;
        (middle, *count as f64 / expected.max(f64::MIN_POSITIVE))
    };
    counts.iter().enumerate().map(of).collect()
}

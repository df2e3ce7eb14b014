//! Pixel-to-pixel correlation: whether neighbouring pixels make the same error.

use crate::kit::of_each::of_each;
use crate::lab::integrands::Integrand;
use crate::lab::subject::Subject;

/// ρ = Σ e·e' / Σ ½(e² + e'²), where e and e' are the errors of two neighbouring pixels that see the same function.
///
/// 1: all pixels have the same points, and the same error; along an edge these errors become stairs. 0: the errors are not
/// correlated; they are noise, which the eye averages. Below 0: neighbours make opposite errors, as in dithering (Georgiev and
/// Fajardo, *Blue-noise dithered sampling*, 2016). Realisations 2k and 2k + 1 stand for two neighbouring pixels.
pub fn correlation(subject: &Subject, n: usize, functions: &[Integrand]) -> f64 {
    let errors = of_each(functions.len(), |k| {
        let first = 2 * k as u64;
        [first, first + 1].map(|pixel| functions[k].error(&subject.points(n, pixel)))
    });
    let (mut both, mut each) = (0.0, 0.0);
    for [e, other] in errors {
        both += e * other;
        each += 0.5 * (e * e + other * other);
    }
    if each > 0.0 { both / each } else { 0.0 }
}

//! Two numbers that sum up a radial power spectrum (Heck, Schlömer and Deussen, *Blue noise sampling with controlled aliasing*, 2013).

/// A mean power up to this share of that of random points counts as none.
const QUIET: f64 = 0.1;

/// The share at which the quiet part of the spectrum has ended.
const LOUD: f64 = 0.5;

/// The power from which on the curve counts as having reached 1.
const RISEN: f64 = 0.98;

/// The effective Nyquist frequency, in units of that of a regular grid of as many points, √n/2.
///
/// The mean power below the frequency ν is E(ν) = 1/(πν²) ∫₀^ν P(r) 2πr dr. The pattern does as well as a grid of the spacing 1/ν
/// for waves up to ν/2, where ν is the highest frequency with E(ν) ≤ 0.1 before E rises to ½. Random points have 0, a regular
/// grid has 1.
///
/// `radial` holds (frequency, mean power) in steps of 1.
pub fn effective_nyquist(radial: &[(f64, f64)], n: usize) -> f64 {
    let mut power = 0.0;
    let mut highest = 0.0;
    for (r, p) in radial {
        // The ring from r − ½ to r + ½ has the area 2πr.
        power += 2.0 * p * r;
        let end = r + 0.5;
        let mean = power / (end * end);
        if mean <= QUIET {
            highest = end;
        } else if mean > LOUD {
            break;
        }
    }
    highest / (n as f64).sqrt()
}

/// The oscillation Ω: ten times the root mean squared difference of P from 1, from the frequency at which P first reaches 1 to the end of
/// the spectrum.
///
/// Random points have 0, up to chance. A high Ω means a sharp ring in the spectrum: waves of that frequency come out as regular
/// aliases, which are seen more than noise.
pub fn oscillation(radial: &[(f64, f64)]) -> f64 {
    let risen = radial.iter().position(|(_, p)| *p >= RISEN);
    let rest = &radial[risen.unwrap_or(radial.len())..];
    let (squares, area) = rest.iter().fold((0.0, 0.0), |(squares, area), (r, p)| {
        (squares + r * (p - 1.0).powi(2), area + r)
    });
    10.0 * (squares / area.max(f64::MIN_POSITIVE)).sqrt()
}

//! The shift of light's frequencies by motion and gravity.
//!
//! ```
//! use raybook::render::curved::doppler::shift;
//!
//! let [towards, aside, away] = [2.0, 0.0, -2.0].map(|axial| shift(6.0, axial, 1e9));
//! assert!((aside - 0.75_f64.sqrt()).abs() < 1e-6); // √(1 − 3/(2r)): slow clocks only
//! assert!(towards > aside && aside > away);
//! ```

/// g = ν_observed/ν_emitted: the shift of the frequencies of light. The light is emitted by gas that circles the hole at the
/// radius r > 3/2, and observed by an observer at rest at the radius `r_eye`, both in radii of the hole.
///
/// `axial` is the light's angular momentum about the axis of the orbit, over its energy: positive if the gas moves towards the
/// observer. The gas needs the time 2π/Ω for an orbit, Ω = √(1/(2r³)), and its clock is slow by the factor √(1 − 3/(2r)):
/// g = √(1 − 3/(2r))/((1 − Ω·axial)·√(1 − 1/r_eye)) (Luminet 1979).
pub fn shift(r: f64, axial: f64, r_eye: f64) -> f64 {
    let omega = (0.5 / (r * r * r)).sqrt();
    (1.0 - 1.5 / r).sqrt() / ((1.0 - omega * axial) * (1.0 - 1.0 / r_eye).sqrt())
}

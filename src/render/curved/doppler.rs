//! What motion and gravity do to the colour of light.

/// g: by which factor an observer at rest at radius r_eye finds the frequencies of light changed that gas has emitted which
/// circles the hole at radius r > 3/2.
///
/// `axial` is the light's angular momentum about the axis of the orbit over its energy: positive if the gas moves towards the
/// observer. The gas needs 2π/Ω for an orbit, Ω = √(1/(2r³)), and its clock runs slow by √(1 − 3/(2r)):
/// g = √(1 − 3/(2r))/((1 − Ω·axial)·√(1 − 1/r_eye)) (Luminet 1979).
pub fn shift(r: f64, axial: f64, r_eye: f64) -> f64 {
    let omega = (0.5 / (r * r * r)).sqrt();
    (1.0 - 1.5 / r).sqrt() / ((1.0 - omega * axial) * (1.0 - 1.0 / r_eye).sqrt())
}

//! By how much a black hole bends a ray that comes from afar and goes away again.

use crate::render::curved::CRITICAL;
use std::f64::consts::PI;

// ANCHOR: deflection_angle
/// The angle, in radians, between the directions in which a ray comes and goes, by its impact parameter b > 0; `None` if it
/// falls in.
///
/// With u = 1/r, the ray obeys (du/dφ)² = 1/b² − u² + u³. It turns at u₀ = 1/r₀, where that is zero, and
/// r₀ = (2b/√3) cos(⅓ arccos(−b_c/b)). There and back it sweeps 2 ∫ du/√(1/b² − u² + u³) from 0 to u₀; straight on would be π.
///
/// At u₀ the integrand is infinite. u = u₀(1 − s²) takes the root out of it:
/// ∫ 2√u₀ ds/√(u₀(1 − u₀) + (1 − u₀)u − u²) from 0 to 1, which Simpson's rule is good at.
pub fn deflection_angle(b: f64) -> Option<f64> {
    /// Even. Next to b_c the integrand has a peak as narrow as the distance to b_c.
    const INTERVALS: u32 = 4000;
    if b <= CRITICAL {
        return None;
    }
    let r0 = 2.0 * b / 3.0_f64.sqrt() * ((-CRITICAL / b).acos() / 3.0).cos();
    let u0 = 1.0 / r0;
    let integrand = |s: f64| {
        let u = u0 * (1.0 - s * s);
        2.0 * (u0 / (u0 * (1.0 - u0) + (1.0 - u0) * u - u * u)).sqrt()
    };
    let width = 1.0 / f64::from(INTERVALS);
    let weighted = |i: u32| {
        let weight = match i {
            0 | INTERVALS => 1.0,
            i if i % 2 == 1 => 4.0,
            _ => 2.0,
        };
        weight * integrand(f64::from(i) * width)
    };
    let swept = (0..=INTERVALS).map(weighted).sum::<f64>() * width / 3.0;
    Some(2.0 * swept - PI)
}
// ANCHOR_END: deflection_angle

//! The angle by which a black hole bends a ray that comes from far away and escapes.
//!
//! ```
//! use raybook::render::curved::deflection::deflection_angle;
//!
//! // Far out, Einstein's 2/b, with b in radii of the hole.
//! let angle = deflection_angle(1000.0).expect("escapes");
//! assert!((angle * 1000.0 - 2.0).abs() < 0.01);
//! assert_eq!(deflection_angle(2.5), None); // falls in
//! ```

use crate::render::curved::CRITICAL;
use std::f64::consts::PI;

// ANCHOR: deflection_angle
/// The deflection angle, in radians, between the directions in which a ray comes and goes, for the impact parameter b > 0 in
/// radii of the hole; `None` if the ray falls in (Darwin 1959).
///
/// With u = 1/r, the ray obeys (du/dφ)² = 1/b² − u² + u³. It is nearest to the hole at u₀ = 1/r₀, where this is zero:
/// r₀ = (2b/√3) cos(⅓ arccos(−b_c/b)). There and back the ray sweeps the angle 2 ∫ du/√(1/b² − u² + u³) from 0 to u₀; a straight
/// line sweeps π.
///
/// At u₀ the integrand is infinite. The substitution u = u₀(1 − s²) removes the singularity:
/// ∫ 2√u₀ ds/√(u₀(1 − u₀) + (1 − u₀)u − u²) from 0 to 1 is a smooth integral for Simpson's rule.
pub fn deflection_angle(b: f64) -> Option<f64> {
    /// Number of intervals, which must be even. Near b = b_c the integrand has a peak as narrow as b − b_c.
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

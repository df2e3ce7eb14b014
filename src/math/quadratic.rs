//! The quadratic equation, solved without cancellation.
//!
//! ```
//! use raybook::math::quadratic::solve;
//!
//! assert_eq!(solve(1.0, -5.0, 6.0), Some((2.0, 3.0)));
//! // By the schoolbook formula in f32, the root near 0 would be 0: all of its digits would be lost.
//! assert_eq!(solve(1.0, -1e8, 1.0), Some((1e-8, 1e8)));
//! ```

// ANCHOR: solve_quadratic
/// The roots t₀ ≤ t₁ of a·t² + b·t + c = 0; `None` if there is no real root, or if a = 0.
///
/// For b > 0, the schoolbook formula's −b + √(b² − 4ac) subtracts nearly equal numbers if b² ≫ 4ac, and the digits are lost.
/// So the root in which both terms have the same sign is computed first, and the other root from t₀·t₁ = c/a:
/// with q = −(b + sign(b)·√(b² − 4ac))/2 the roots are q/a and c/q (Press et al., *Numerical Recipes*, §5.6).
pub fn solve(a: f32, b: f32, c: f32) -> Option<(f32, f32)> {
    // Near a double root, b² − 4ac also subtracts nearly equal numbers; in f64 both products are exact.
    let [a, b, c] = [a, b, c].map(f64::from);
    let discriminant = b * b - 4.0 * a * c;
    if a == 0.0 || discriminant < 0.0 || discriminant.is_nan() {
        return None;
    }
    let q = -0.5 * (b + discriminant.sqrt().copysign(b));
    if q == 0.0 {
        return Some((0.0, 0.0)); // b = c = 0
    }
    let (t0, t1) = ((q / a) as f32, (c / q) as f32);
    Some((t0.min(t1), t0.max(t1)))
}
// ANCHOR_END: solve_quadratic

//! Two strategies to sample the direct light, and their weights (multiple importance sampling, MIS).
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::render::mis::power;
//!
//! assert_eq!(power(3.0, 1.0), 0.9); // 9/(9 + 1)
//! // The weights of a direction by both strategies add up to 1.
//! assert!((Strategy::Both.of_light(2.0, 5.0) + Strategy::Both.of_surface(5.0, 2.0) - 1.0).abs() < 1e-6);
//! ```

/// How directions are chosen for direct light, which comes straight from a light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Strategy {
    /// By the surface: more often where its BRDF is large. A light without an extent is still sampled by the light.
    Surface,
    /// By the light: a point on the light, whatever the BRDF is in its direction.
    Light,
    /// By both, weighted by their densities: multiple importance sampling.
    Both,
}

impl Strategy {
    /// The weight of a direction that was chosen by the light with the density `light`, where the surface has the density
    /// `surface`, both per steradian.
    pub fn of_light(self, light: f32, surface: f32) -> f32 {
        match self {
            Self::Both => power(light, surface),
            Self::Surface if light.is_finite() => 0.0,
            _ => 1.0,
        }
    }

    /// The weight of a direction that was chosen by the surface with the density `surface`, where the light has the density
    /// `light`, both per steradian.
    ///
    /// Camera rays and delta lobes are not chosen by a density: for them `surface` is ∞, and the weight is 1. A `light` of 0
    /// means that the light could not have chosen the direction: then the weight is 1 too.
    pub fn of_surface(self, surface: f32, light: f32) -> f32 {
        match self {
            Self::Both => power(surface, light),
            Self::Light if surface.is_finite() && light > 0.0 => 0.0,
            _ => 1.0,
        }
    }
}

// ANCHOR: power_heuristic
/// The power heuristic p²/(p² + q²): the weight of a direction that was chosen with the density p, and could have been chosen
/// with the density q by the other strategy.
///
/// The two weights of a direction add up to 1, so no light is counted twice and none is left out. The strategy with the larger
/// density gets most of the weight, because it has less variance there (Veach and Guibas, "Optimally combining sampling
/// techniques for Monte Carlo rendering", 1995). p is positive; p = ∞, for a direction that is not chosen by a density, has the
/// weight 1.
pub fn power(p: f32, q: f32) -> f32 {
    1.0 / (1.0 + (q / p).powi(2))
}
// ANCHOR_END: power_heuristic

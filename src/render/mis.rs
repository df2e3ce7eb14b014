//! Two ways to choose a direction, and how much each counts.

/// How the directions are chosen from which light may come straight from a light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Strategy {
    /// By the surface: where it reflects much, for whatever light is there. Lights without extent are chosen themselves.
    Surface,
    /// By the light: a place on it, however little the surface makes of it.
    Light,
    /// Both, each weighted by what it is good at: multiple importance sampling.
    Both,
}

impl Strategy {
    /// How much a direction counts that was chosen by the light, with its density there and with the surface's.
    pub fn of_light(self, light: f32, surface: f32) -> f32 {
        match self {
            Self::Both => power(light, surface),
            Self::Surface if light.is_finite() => 0.0,
            _ => 1.0,
        }
    }

    /// How much a direction counts that was chosen by the surface, with its density there and with the light's.
    ///
    /// What the eye sees straight is no choice: its density is ∞. Nor can a light be chosen that has no density.
    pub fn of_surface(self, surface: f32, light: f32) -> f32 {
        match self {
            Self::Both => power(surface, light),
            Self::Light if surface.is_finite() && light > 0.0 => 0.0,
            _ => 1.0,
        }
    }
}

// ANCHOR: power_heuristic
/// p²/(p² + q²): the weight of a direction that was chosen with density p, and could have been chosen with density q.
///
/// The two weights of a direction add up to 1, so nothing is counted twice and nothing is left out; and each estimate is
/// small where the other one is good (the power heuristic: Veach and Guibas, "Optimally combining sampling techniques for
/// Monte Carlo rendering", 1995). p is positive; ∞ is no choice, and has weight 1.
pub fn power(p: f32, q: f32) -> f32 {
    1.0 / (1.0 + (q / p).powi(2))
}
// ANCHOR_END: power_heuristic

//! The sampling lab: what can be measured of a sampling pattern, and figures that show it.

pub mod adaptive_gain;
pub mod discrepancy;
pub mod edge;
pub mod error_plot;
pub mod integrands;
pub mod page;
pub mod plot;
pub mod point_sets;
pub mod polar;
pub mod run;
pub mod sheets;
pub mod spectrum;
pub mod spectrum_plot;
pub mod steps;
pub mod table;
pub mod targets;

use crate::math::pcg;
use crate::sample::pattern::Pattern;
use glam::Vec2;

/// The points of a pattern in one of many pixels.
pub fn realisation(pattern: &Pattern, n: usize, pixel: u64) -> Vec<Vec2> {
    (pattern.points)(n, &mut pcg::stream(22, pixel))
}

/// A pattern's name as people write it: "regular grid".
pub fn title(pattern: &Pattern) -> String {
    pattern.name.replace('-', " ")
}

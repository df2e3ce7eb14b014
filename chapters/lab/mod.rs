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
pub mod settings;
pub mod sheets;
pub mod spectrum;
pub mod spectrum_plot;
pub mod steps;
pub mod subject;
pub mod table;
pub mod targets;

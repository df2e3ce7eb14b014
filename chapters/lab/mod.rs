//! The sampling lab: what can be measured of a sampling pattern, and figures that show it.

pub mod adaptive_gain;
pub mod area;
pub mod blue_noise;
pub mod discrepancy;
pub mod distances;
pub mod edge;
pub mod error_plot;
pub mod errors;
pub mod integrands;
pub mod legend;
pub mod nyquist;
pub mod page;
pub mod page_style;
pub mod pair_correlation;
pub mod pens;
pub mod pixels;
pub mod plot;
pub mod point_sets;
pub mod polar;
pub mod portrait;
pub mod prefix_plot;
pub mod prefixes;
pub mod projection;
pub mod raster;
pub mod run;
pub mod settings;
pub mod sheets;

pub mod slide;
pub mod spectrum;
pub mod steps;
pub mod subject;
pub mod table;
pub mod targets;

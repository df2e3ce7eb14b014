//! What every chapter draws with.

pub mod address;
pub mod axis;
pub mod bars;
pub mod captions;
pub mod chapter;
pub mod chart;
pub mod figure;
pub mod gallery;
pub mod html;
pub mod knobs;
pub mod numbers;
pub mod of_each;
pub mod okabe_ito;
pub mod options;
pub mod palette;
pub mod paper;
pub mod pen;
pub mod plate;
pub mod rate;
pub mod say;
pub mod sheet;
pub mod sketch;
pub mod stage;
pub mod terminal;
pub mod untrusted;
pub mod vary;
mod vectors;

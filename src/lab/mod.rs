//! Floor 8: the stage on which a chapter draws, and the figures that explain its picture.

pub mod chapter;
pub mod figure;
pub mod gallery;
pub mod options;
pub mod palette;
pub mod sheet;
pub mod showroom;
pub mod stage;

//! Floor 8: the stage on which a chapter draws, and the figures that explain its picture.

pub mod bars;
pub mod barycentrics;
pub mod camera_diagram;
pub mod cancellation;
pub mod chapter;
pub mod environments;
pub mod figure;
pub mod gallery;
pub mod looks;
pub mod options;
pub mod outdoors;
pub mod palette;
pub mod platonic;
pub mod race;
pub mod say;
pub mod sheet;
pub mod showroom;
pub mod sketch;
pub mod slabs;
pub mod stage;
pub mod stops;
pub mod triangle_race;

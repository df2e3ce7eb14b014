//! Floor 4: a scene, how a file describes one, and the scenes that chapters share.

pub mod accretion_disc;
pub mod backdrop;
pub mod cornell;
pub mod description;
pub mod four_scenes;
pub mod horizon;
pub mod marbles;
#[cfg(feature = "files")]
pub mod model;
pub mod noise;
pub mod plates;
pub mod soup;
pub mod stadium;
pub mod still_life;
pub mod terrain;
pub mod world;

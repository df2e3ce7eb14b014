//! Floor 4: stock scenes that chapters share.

pub mod accretion_disc;
pub mod cornell;
pub mod description;
pub mod evening;
pub mod four_scenes;
pub mod horizon;
pub mod marbles;
pub mod noise;
pub mod plates;
pub mod soup;
pub mod stadium;
pub mod still_life;
pub mod teapots;
pub mod terrain;
pub mod window;
pub mod world;

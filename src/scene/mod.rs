//! Floor 4: stock scenes that chapters share.

pub mod evening;
pub mod noise;
pub mod skies;
pub mod soup;
pub mod terrain;
pub mod window;
pub mod world;

//! Floor 4: stock scenes that chapters share.

pub mod evening;
pub mod noise;
pub mod soup;
pub mod stadium;
pub mod teapots;
pub mod terrain;
pub mod window;

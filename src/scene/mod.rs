//! Floor 4: stock scenes that chapters share.

pub mod accretion_disc;
pub mod cornell;
pub mod description;
pub mod four_scenes;
pub mod glassware;
pub mod horizon;
pub mod kissing_balls;
pub mod marbles;
pub mod noise;
pub mod pavilion;
pub mod plates;
pub mod posts;
pub mod skies;
pub mod soup;
pub mod stadium;
pub mod starry_sky;
pub mod still_life;
pub mod summer;
pub mod tea_table;
pub mod terrain;
pub mod world;

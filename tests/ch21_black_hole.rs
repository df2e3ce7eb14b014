//! Chapter 21: light around a black hole.

#[path = "ch21_black_hole/colours.rs"]
mod colours;
#[path = "ch21_black_hole/known.rs"]
mod known;
#[path = "ch21_black_hole/rays.rs"]
mod rays;

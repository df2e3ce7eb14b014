//! Chapter 21: light around a black hole.

mod colours;
mod known;
mod rays;

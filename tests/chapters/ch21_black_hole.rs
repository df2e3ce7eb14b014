//! Chapter 21: light around a black hole.

mod colours;
mod fan;
mod known;
mod rays;

//! Chapter 14: glass, water and air.

mod absorption;
mod dispersion;
mod glass;
mod laws;
mod twigs;

//! Chapter 14: glass, water and air.

mod absorption;
mod glass;
mod laws;
mod twigs;

//! Chapter 14: glass, water and air.

#[path = "ch14_refraction/glass.rs"]
mod glass;
#[path = "ch14_refraction/laws.rs"]
mod laws;

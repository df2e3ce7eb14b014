//! Chapter 14: glass, water and air.

#[path = "ch14_refraction/absorption.rs"]
mod absorption;
#[path = "ch14_refraction/glass.rs"]
mod glass;
#[path = "ch14_refraction/laws.rs"]
mod laws;
#[path = "ch14_refraction/twigs.rs"]
mod twigs;

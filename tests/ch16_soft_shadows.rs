//! Chapter 16: lights with an extent.

#[path = "ch16_soft_shadows/lights.rs"]
mod lights;
#[path = "ch16_soft_shadows/shadows.rs"]
mod shadows;

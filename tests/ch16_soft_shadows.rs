//! Chapter 16: lights with an extent, and their shadows.

#[path = "ch16_soft_shadows/densities.rs"]
mod densities;
#[path = "ch16_soft_shadows/lights.rs"]
mod lights;
#[path = "common/noisy.rs"]
mod noisy;
#[path = "ch16_soft_shadows/seeds.rs"]
mod seeds;
#[path = "ch16_soft_shadows/shadows.rs"]
mod shadows;
#[path = "ch16_soft_shadows/support.rs"]
mod support;

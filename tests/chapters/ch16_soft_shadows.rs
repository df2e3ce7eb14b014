//! Chapter 16: lights with an extent, and their shadows.

mod densities;
mod lights;
use raybook_common::noisy;
mod seeds;
mod shadows;
mod support;

//! Laws: what must hold for every shape and every ray, asked of thousands of random ones.
//!
//! The random numbers follow from fixed seeds, so that a run can be repeated.

mod boxes;
pub(crate) mod forms;
mod hits;
mod leave;
mod motion;
pub(crate) mod wild;

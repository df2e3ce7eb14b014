//! Chapter 8: the uniform grid.

#[path = "ch08_grid/agreement.rs"]
mod agreement;

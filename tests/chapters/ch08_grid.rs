//! Chapter 8: the uniform grid.

mod agreement;
mod cells;
mod cost;
mod planes;
use raybook_common::polygon;
mod walk;

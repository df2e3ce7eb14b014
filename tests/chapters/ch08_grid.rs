//! Chapter 8: the uniform grid.

mod agreement;
mod cells;
mod cost;
mod flatland;
mod planes;
mod walk;

use raybook_common::polygon;

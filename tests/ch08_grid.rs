//! Chapter 8: the uniform grid.

#[path = "ch08_grid/agreement.rs"]
mod agreement;
#[path = "ch08_grid/cells.rs"]
mod cells;
#[path = "ch08_grid/cost.rs"]
mod cost;
#[path = "ch08_grid/planes.rs"]
mod planes;
#[path = "common/polygon.rs"]
mod polygon;
#[path = "ch08_grid/walk.rs"]
mod walk;

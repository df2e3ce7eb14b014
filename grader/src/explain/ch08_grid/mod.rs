//! Chapter 8: the resolution of a grid, the cells of a triangle, and the walk from cell to cell.

mod resolution;
mod voxels;
mod walk;

//! Chapter 24: the wide tree.

mod agreement;
mod edges;
mod scenes;
mod tree;

//! Chapter 24: the wide tree.

mod agreement;
mod edges;
mod refit;
mod scenes;
mod tree;

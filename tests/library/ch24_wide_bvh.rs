//! Chapter 24: the wide tree.

mod agreement;
mod cuts;
mod edges;
mod refit;
mod scenes;
mod tree;

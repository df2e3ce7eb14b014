//! Chapter 24: the wide tree.

#[path = "ch24_wide_bvh/agreement.rs"]
mod agreement;
#[path = "ch24_wide_bvh/edges.rs"]
mod edges;
#[path = "ch24_wide_bvh/scenes.rs"]
mod scenes;
#[path = "ch24_wide_bvh/tree.rs"]
mod tree;

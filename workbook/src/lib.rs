//! What travels with a student: the curriculum, the exercises, and the program that answers them.

#![warn(
    clippy::allow_attributes_without_reason,
    missing_debug_implementations,
    unreachable_pub
)]

pub mod anchor;
pub mod answer;
pub mod curriculum;
pub mod exercise;
pub mod exercises;
pub mod kind;
pub mod octree_rows;
mod record;
pub mod row;
mod scene_rows;
pub mod tree_rows;
mod words;

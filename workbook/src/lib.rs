//! What travels with a student: the curriculum, the exercises, and the program that answers them.

pub mod anchor;
pub mod answer;
pub mod choice;
pub mod curriculum;
pub mod exercise;
pub mod exercises;
pub mod octree_rows;
pub mod row;
pub mod row_types;
pub mod scene_rows;
pub mod tree_rows;

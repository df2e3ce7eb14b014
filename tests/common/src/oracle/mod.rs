//! What the comparison with Embree and the replay of its recorded answers share.
//!
//! `tests/embree` (which needs Embree) and `tests/library/embree_recorded.rs` (which does not) both take these files in, so that
//! both ask the same shapes, know the same meshes and demand the same closeness.

#[cfg(test)]
mod bad_lines;
pub mod judge;
pub mod meeting;
pub mod meshes;
pub mod recording;
pub mod target;

//! Chapter 10: `octree_child`, `octree_build`, `octree_walk`.

mod octree_build;
mod octree_build_cases;
mod octree_build_judge;
mod octree_child;
mod octree_walk;
mod octree_walk_cases;

use crate::examine::Examiner;
use raybook_workbook::exercises::ch10_octree::{OctreeBuild, OctreeChild, OctreeWalk};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&OctreeChild, &OctreeBuild, &OctreeWalk];

//! Chapter 10: `octree_child`, `octree_build`, `octree_walk`.

mod octree_build_cases;
mod octree_build_judge;
mod octree_walk_cases;


raybook_workbook::ch10_octree!(graded);

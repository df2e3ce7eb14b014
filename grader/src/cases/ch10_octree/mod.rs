//! Chapter 10: `octree_child`, `octree_build`, `octree_walk`.

mod octree_tree;

raybook_workbook::ch10_octree!(graded);

//! Chapter 10: `octree_child`, `octree_build`, `octree_walk`.

raybook_workbook::ch10_octree!(graded);

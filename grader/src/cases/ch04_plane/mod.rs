//! Chapter 4: `plane_hit`.

raybook_workbook::ch04_plane!(graded);

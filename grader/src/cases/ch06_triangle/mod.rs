//! Chapter 6: `triangle_hit`, `triangle_normal`.

raybook_workbook::ch06_triangle!(graded);

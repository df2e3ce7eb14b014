//! Chapter 6: `triangle_hit`, `triangle_normal`.

mod triangle_hit_cases;


raybook_workbook::ch06_triangle!(graded);

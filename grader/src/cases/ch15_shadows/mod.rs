//! Chapter 15: `shadow_ray`, `lit`.

mod way;

raybook_workbook::ch15_shadows!(graded);

//! Chapter 3: `solve_quadratic`, `sphere_hit`, `sphere_normal`.

raybook_workbook::ch03_sphere!(graded);

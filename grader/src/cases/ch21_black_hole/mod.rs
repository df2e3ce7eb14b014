//! Chapter 21: `geodesic_step`, `deflection_angle`.

raybook_workbook::ch21_black_hole!(graded);

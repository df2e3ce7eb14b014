//! Chapter 20: `panorama_ray`.

raybook_workbook::ch20_panorama!(graded);

//! Chapter 5: `box_clip`, `bounds_of`.

raybook_workbook::ch05_box!(graded);

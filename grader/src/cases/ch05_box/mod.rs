//! Chapter 5: `box_clip`, `bounds_of`.

mod box_clip_cases;


raybook_workbook::ch05_box!(graded);

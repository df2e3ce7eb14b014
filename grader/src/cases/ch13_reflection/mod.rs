//! Chapter 13: `reflect`.

raybook_workbook::ch13_reflection!(graded);

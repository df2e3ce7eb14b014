//! Chapter 23: `needs_more`, `spend_budget`.

mod measures;

raybook_workbook::ch23_adaptive!(graded);

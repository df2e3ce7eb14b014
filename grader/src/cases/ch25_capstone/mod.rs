//! Chapter 25: `trace`.

mod slip;
mod tracer;

raybook_workbook::ch25_capstone!(graded);

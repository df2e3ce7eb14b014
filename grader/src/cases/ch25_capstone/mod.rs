//! Chapter 25: `trace`.

mod random;
mod slip;
mod trace_judge;
mod trace_mistakes;
mod tracer;


raybook_workbook::ch25_capstone!(graded);

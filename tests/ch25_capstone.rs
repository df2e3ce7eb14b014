//! Chapter 25: described scenes, `trace`, the score, and a whole ray tracer in another language.

mod common;
#[path = "ch25_capstone/python.rs"]
mod python;
#[path = "ch25_capstone/rows.rs"]
mod rows;
#[path = "ch25_capstone/score.rs"]
mod score;
#[path = "ch25_capstone/trace.rs"]
mod trace;

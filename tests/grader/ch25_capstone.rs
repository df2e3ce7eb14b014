//! Chapter 25: described scenes, `trace`, the score, and a whole ray tracer in another language.

mod python;
mod rows;
mod score;
mod trace;

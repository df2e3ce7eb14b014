//! Grading a class: what the course counts, the hand-ins, a journal that loses nothing, grades, and the files that others read.

pub mod course;
pub mod language;
pub mod settings;
pub mod when;

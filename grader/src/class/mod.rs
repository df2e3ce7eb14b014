//! Grading a class: what the course counts, the hand-ins, a journal that loses nothing, grades, and the files that others read.

pub mod changes;
pub mod course;
pub mod drawn;
pub mod exam;
pub mod export;
pub mod files;
pub mod grades;
pub mod hand_in;
pub mod items;
pub mod journal;
pub mod pack;
pub(crate) mod prebuilt;
mod programs;
pub mod reaches;
pub mod record;
pub mod roll;
pub mod run;
pub mod settings;
pub mod shortage;
pub mod similar;
pub mod stage;
pub mod taken;
pub mod times;
pub mod tokens;
pub mod when;

use raybook_workbook::curriculum;

/// Whether an exercise is an instructor's own: it is of no chapter.
pub fn is_own(exercise: &str) -> bool {
    curriculum::of_exercise(exercise).is_none()
}

//! The cases, judges and mistakes: a file per chapter.

use crate::examine::Examiner;
use raybook_workbook::for_each_chapter;

/// The modules, and all their exercises in order.
macro_rules! modules {
    ($($chapter:ident $title:literal),+ $(,)?) => {
        $(pub mod $chapter;)+

        /// Every graded exercise of the course.
        pub fn all() -> Vec<&'static dyn Examiner> {
            [$($chapter::GRADED),+].concat()
        }
    };
}

for_each_chapter!(modules);

/// The graded exercise of this name.
pub fn find(exercise: &str) -> Option<&'static dyn Examiner> {
    all()
        .into_iter()
        .find(|examiner| examiner.name() == exercise)
}

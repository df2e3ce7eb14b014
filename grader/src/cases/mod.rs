//! The random questions, judges and mistakes: a folder per chapter, a file per exercise.

use crate::examine::Examiner;
use raybook_workbook::for_each_chapter;

/// The modules of a chapter's exercises, and the list of their examiners.
macro_rules! graded {
    ($chapter:ident $($name:ident: $exercise:ident),+) => {
        $(mod $name;)+

        /// The exercises of this chapter, in order.
        pub static GRADED: &[&dyn crate::examine::Examiner] = &[$(
            &crate::examine::Examination::<raybook_workbook::exercises::$chapter::$exercise>::new(
                include_str!(concat!(
                    env!("CARGO_MANIFEST_DIR"),
                    "/../golden/",
                    stringify!($chapter),
                    "/",
                    stringify!($name),
                    ".txt"
                )),
            )
        ),+];
    };
}

/// The modules, and all their exercises in order.
macro_rules! modules {
    ($($chapter:ident $title:literal $needs:tt),+ $(,)?) => {
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

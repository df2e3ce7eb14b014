//! What is asked: a file per chapter, a type per exercise. This part travels with the student.

use crate::exercise::Asked;
use crate::for_each_chapter;

/// The modules, and all their exercises in order.
macro_rules! modules {
    ($($chapter:ident $title:literal),+ $(,)?) => {
        $(pub mod $chapter;)+

        /// Every exercise of the course.
        pub fn all() -> Vec<&'static dyn Asked> {
            [$($chapter::EXERCISES),+].concat()
        }

        /// The exercises of the chapter of this name.
        pub fn of_chapter(name: &str) -> &'static [&'static dyn Asked] {
            match name {
                $(stringify!($chapter) => $chapter::EXERCISES,)+
                _ => &[],
            }
        }
    };
}

for_each_chapter!(modules);

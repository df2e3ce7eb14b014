//! What is asked: a file per chapter, in which each exercise is declared once. This part travels with the student.

use crate::exercise::Asked;
use crate::for_each_chapter;

/// The modules, and all their exercises in order.
macro_rules! modules {
    ($($chapter:ident $title:literal $needs:tt),+ $(,)?) => {
        $(pub mod $chapter;)+

        /// Every exercise of the course.
        pub fn all() -> impl Iterator<Item = &'static Asked> {
            [$($chapter::EXERCISES),+].into_iter().flatten()
        }

        /// The exercises of the chapter of this name.
        pub fn of_chapter(name: &str) -> &'static [Asked] {
            match name {
                $(stringify!($chapter) => $chapter::EXERCISES,)+
                _ => &[],
            }
        }
    };
}

for_each_chapter!(modules);

/// The exercise of this name.
pub fn find(name: &str) -> Option<&'static Asked> {
    all().find(|exercise| exercise.name == name)
}

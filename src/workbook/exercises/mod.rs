//! What is asked: a file per chapter, a type per exercise. This part travels with the student.

use crate::workbook::exercise::Asked;

/// The modules, and all their exercises in order.
macro_rules! chapters {
    ($($chapter:ident),+ $(,)?) => {
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

chapters!(
    ch01_rays,
    ch02_hdr,
    ch03_sphere,
    ch04_plane,
    ch05_box,
    ch06_triangle,
    ch07_mesh
);

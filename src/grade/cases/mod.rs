//! The cases, judges and mistakes: a file per chapter.

use crate::grade::examine::Examiner;

/// The modules, and all their exercises in order.
macro_rules! chapters {
    ($($chapter:ident),+ $(,)?) => {
        $(pub mod $chapter;)+

        /// Every graded exercise of the course.
        pub fn all() -> Vec<&'static dyn Examiner> {
            [$($chapter::GRADED),+].concat()
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

/// The graded exercise of this name.
pub fn find(exercise: &str) -> Option<&'static dyn Examiner> {
    all()
        .into_iter()
        .find(|examiner| examiner.name() == exercise)
}

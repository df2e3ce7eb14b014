//! The chapters of the course: a folder for each, with its binary and the figures that only it draws.
//!
//! | folder | what is in it |
//! |---|---|
//! | `chNN_<name>/` | a chapter: `mod.rs` draws its pictures, `main.rs` is its binary |
//! | `kit/` | what every chapter draws with: the stage, sheets, charts, colours, options |
//! | `shared/` | rooms, scenes and figures that a few chapters share |
//! | `lab/` | the sampling lab: what can be measured of a sampling pattern, and figures that show it |

pub mod kit;
pub mod lab;
pub mod lesson;
pub mod shared;

use lesson::Lesson;
use raybook_workbook::for_each_chapter;

/// The chapters' modules and the table of them, from the list of chapters.
macro_rules! lessons {
    ($($name:ident $title:literal),+ $(,)?) => {
        $(#[doc = concat!("Chapter: ", $title, ".")] pub mod $name;)+

        /// Every chapter, as it is drawn, in order.
        pub const LESSONS: &[Lesson] = &[$(Lesson {
            name: stringify!($name),
            source: include_str!(concat!(stringify!($name), "/mod.rs")),
            draw: $name::draw,
        }),+];
    };
}

for_each_chapter!(lessons);

//! The chapters of the course: a folder for each, with its binary and the figures that only it draws.
//!
//! | folder | what is in it |
//! |---|---|
//! | `chNN_<name>/` | a chapter: `mod.rs` draws its pictures, `main.rs` is its binary |
//! | `kit/` | what every chapter draws with: the stage, sheets, charts, colours, options, knobs |
//! | `shared/` | rooms, scenes and figures that a few chapters share |
//! | `scenes/` | a package of its own: scene files, and a gallery of them |
//! | `tour.rs` | every chapter's pictures in one run; `course.rs` is the binary that cargo runs first |
//! | `lab/` | the sampling lab: measurements of a sampling pattern, and figures that show them |

#![warn(
    clippy::allow_attributes_without_reason,
    missing_debug_implementations,
    unreachable_pub
)]

pub mod kit;
pub mod lab;
pub mod lesson;
pub mod shared;
pub mod tour;

use clap::FromArgMatches;
use kit::knobs;
use lesson::Lesson;
use raybook_workbook::for_each_chapter;

/// The chapters' modules and the table of them, from the list of chapters.
macro_rules! lessons {
    ($($name:ident $title:literal $needs:tt),+ $(,)?) => {
        $(#[doc = concat!("Chapter: ", $title, ".")] pub mod $name;)+

        /// Every chapter, as it is drawn, in order.
        pub const LESSONS: &[Lesson] = &[$(Lesson {
            name: stringify!($name),
            source: include_str!(concat!(stringify!($name), "/mod.rs")),
            add_knobs: knobs::add::<$name::Knobs>,
            draw: |stage, matches| $name::draw(stage, &$name::Knobs::from_arg_matches(matches)?),
        }),+];
    };
}

for_each_chapter!(lessons);

/// The figures that show measured times, and so are never the same twice; all other figures follow from the seed, bit for bit.
pub const MEASURED: [&str; 6] = [
    "ch06_triangle/cost.png",
    "ch08_grid/resolution.png",
    "ch11_bvh/builders.png",
    "ch11_bvh/speeds.png",
    "ch17_rendering_equation/error.png",
    "ch24_wide_bvh/gain.png",
];

//! The curriculum as data. What a chapter says of itself stands once, at the top of its file in `chapters/`.

use crate::workbook::exercise::Asked;
use crate::workbook::exercises;

/// One chapter of the course.
#[derive(Clone, Copy, Debug)]
pub struct Chapter {
    /// The name of its binary, its folder of pictures and golden answers, and its page: `ch03_sphere`.
    pub name: &'static str,
    /// The text of `chapters/<name>.rs`.
    pub source: &'static str,
}

/// Calls a macro with the names of all chapters that exist, in order: what has a part per chapter is made from this list.
macro_rules! for_each_chapter {
    ($then:ident) => {
        $then!(
            ch01_rays,
            ch02_hdr,
            ch03_sphere,
            ch04_plane,
            ch05_box,
            ch06_triangle,
            ch07_mesh,
            ch08_grid,
            ch09_two_level_grid,
            ch10_octree,
            ch11_bvh,
            ch12_phong,
            ch13_reflection,
            ch14_refraction,
            ch15_shadows,
            ch16_soft_shadows,
            ch17_rendering_equation,
            ch18_environment,
            ch19_depth_of_field,
            ch20_panorama,
            ch21_black_hole,
            ch22_antialiasing,
            ch23_adaptive,
            ch24_wide_bvh,
            ch25_capstone
        );
    };
}
pub(crate) use for_each_chapter;

/// The rows, from the chapters' names.
macro_rules! rows {
    ($($name:ident),+) => {
        /// All chapters that exist, in order.
        pub const CHAPTERS: &[Chapter] = &[$(Chapter {
            name: stringify!($name),
            source: include_str!(concat!("../../chapters/", stringify!($name), ".rs")),
        }),+];
    };
}

for_each_chapter!(rows);

/// The chapter whose binary has this name.
pub fn find(name: &str) -> Option<&'static Chapter> {
    CHAPTERS.iter().find(|row| row.name == name)
}

impl Chapter {
    /// The functions that a student writes; their names are grade keys.
    pub fn exercises(&self) -> &'static [&'static dyn Asked] {
        exercises::of_chapter(self.name)
    }

    /// Whether somebody who says this word means this chapter: 3, ch03, sphere or `ch03_sphere`.
    pub fn answers_to(&self, word: &str) -> bool {
        let (number, topic) = self.name.split_once('_').unwrap_or((self.name, ""));
        [self.name, number, topic].contains(&word) || word.parse() == Ok(self.number())
    }

    /// "3", from `ch03_sphere`.
    pub fn number(&self) -> u32 {
        self.name[2..4].parse().unwrap_or(0)
    }

    /// The chapter's title: its file begins with `//! # <title>`.
    pub fn title(&self) -> &'static str {
        self.header()
            .next()
            .unwrap_or_default()
            .trim_start_matches("# ")
    }

    /// What it teaches: the paragraph under the title, in one line.
    pub fn teaches(&self) -> String {
        let paragraph: Vec<_> = self
            .header()
            .skip(1)
            .skip_while(|line| line.is_empty())
            .take_while(|line| !line.is_empty())
            .collect();
        paragraph.join(" ")
    }

    /// The files of `src/` that it introduces: its `New:` lines.
    pub fn new_files(&self) -> Vec<&'static str> {
        let lists = self.header().filter_map(|line| line.strip_prefix("New: "));
        lists
            .flat_map(str::split_whitespace)
            .map(|file| file.trim_end_matches(','))
            .collect()
    }

    /// The lines of the comment at the top of the file, without their `//!`.
    fn header(&self) -> impl Iterator<Item = &'static str> + use<> {
        self.source
            .lines()
            .map_while(|line| line.strip_prefix("//!"))
            .map(str::trim)
    }
}

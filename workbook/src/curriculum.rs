//! The list of chapters. It stands here once: whatever has a part per chapter is made from it.

use crate::exercise::Asked;
use crate::exercises;

/// One chapter of the course.
#[derive(Clone, Copy, Debug)]
pub struct Chapter {
    /// The name of its binary, its folder, its pictures, its golden answers and its page: `ch03_sphere`.
    pub name: &'static str,
    /// Its title: "Sphere".
    pub title: &'static str,
    /// The numbers of the chapters whose functions or ideas its lesson uses.
    pub needs: &'static [u32],
}

/// Calls a macro with every chapter in the order of the course: its name, its title, and the numbers of the chapters that it needs.
#[macro_export]
macro_rules! for_each_chapter {
    ($then:ident) => {
        $then! {
            ch01_rays "Rays" [],
            ch02_hdr "High dynamic range" [1],
            ch03_sphere "Sphere" [1],
            ch04_plane "Plane" [3],
            ch05_box "Box" [4],
            ch06_triangle "Triangle" [4],
            ch07_mesh "Mesh" [3, 6],
            ch08_grid "Grid" [5, 7],
            ch09_two_level_grid "Two-level grid" [8],
            ch10_octree "Octree" [5, 7, 8],
            ch11_bvh "Bounding volume hierarchy" [5, 7],
            ch12_phong "Phong" [2, 3],
            ch13_reflection "Reflection" [12],
            ch14_refraction "Refraction" [13],
            ch15_shadows "Shadows" [12],
            ch16_soft_shadows "Soft shadows" [15],
            ch17_rendering_equation "Rendering equation" [13, 14, 16],
            ch18_environment "Environment" [17],
            ch19_depth_of_field "Depth of field" [1, 16],
            ch20_panorama "Panorama" [18],
            ch21_black_hole "Black hole" [18],
            ch22_antialiasing "Antialiasing" [1, 2],
            ch23_adaptive "Adaptive supersampling" [22],
            ch24_wide_bvh "Wide BVH" [11],
            ch25_capstone "Capstone" [4, 6, 12, 13, 14, 15],
        }
    };
}

/// The rows, from the list.
macro_rules! rows {
    ($($name:ident $title:literal $needs:tt),+ $(,)?) => {
        /// All chapters, in order.
        pub const CHAPTERS: &[Chapter] = &[$(Chapter { name: stringify!($name), title: $title, needs: &$needs }),+];
    };
}

for_each_chapter!(rows);

/// The chapter whose binary has this name.
pub fn find(name: &str) -> Option<&'static Chapter> {
    CHAPTERS.iter().find(|chapter| chapter.name == name)
}

/// The chapter that somebody means who says this word ([`Chapter::answers_to`]).
pub fn called(word: &str) -> Option<&'static Chapter> {
    CHAPTERS.iter().find(|chapter| chapter.answers_to(word))
}

/// The chapter of an exercise.
pub fn of_exercise(exercise: &str) -> Option<&'static Chapter> {
    let has = |chapter: &&Chapter| chapter.exercises().iter().any(|of| of.name == exercise);
    CHAPTERS.iter().find(has)
}

impl Chapter {
    /// The functions that a student writes; their names are grade keys.
    pub fn exercises(&self) -> &'static [Asked] {
        exercises::of_chapter(self.name)
    }

    /// Whether somebody who says this word means this chapter: 3, ch03, ch3, sphere or `ch03_sphere`.
    pub fn answers_to(&self, word: &str) -> bool {
        let topic = self.name.split_once('_').map_or("", |(_, topic)| topic);
        let number = word.strip_prefix("ch").unwrap_or(word);
        [self.name, topic].contains(&word) || number.parse() == Ok(self.number())
    }

    /// "3", from `ch03_sphere`.
    pub fn number(&self) -> u32 {
        let digits = self.name.get(2..4);
        digits.and_then(|digits| digits.parse().ok()).unwrap_or(0)
    }
}

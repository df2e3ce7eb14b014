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
}

/// Calls a macro with the name and the title of every chapter, in the order of the course.
#[macro_export]
macro_rules! for_each_chapter {
    ($then:ident) => {
        $then! {
            ch01_rays "Rays",
            ch02_hdr "High dynamic range",
            ch03_sphere "Sphere",
            ch04_plane "Plane",
            ch05_box "Box",
            ch06_triangle "Triangle",
            ch07_mesh "Mesh",
            ch08_grid "Grid",
            ch09_two_level_grid "Two-level grid",
            ch10_octree "Octree",
            ch11_bvh "Bounding volume hierarchy",
            ch12_phong "Phong",
            ch13_reflection "Reflection",
            ch14_refraction "Refraction",
            ch15_shadows "Shadows",
            ch16_soft_shadows "Soft shadows",
            ch17_rendering_equation "Rendering equation",
            ch18_environment "Environment",
            ch19_depth_of_field "Depth of field",
            ch20_panorama "Panorama",
            ch21_black_hole "Black hole",
            ch22_antialiasing "Antialiasing",
            ch23_adaptive "Adaptive supersampling",
            ch24_wide_bvh "Wide BVH",
            ch25_capstone "Capstone",
        }
    };
}

/// The rows, from the list.
macro_rules! rows {
    ($($name:ident $title:literal),+ $(,)?) => {
        /// All chapters, in order.
        pub const CHAPTERS: &[Chapter] = &[$(Chapter { name: stringify!($name), title: $title }),+];
    };
}

for_each_chapter!(rows);

/// The chapter whose binary has this name.
pub fn find(name: &str) -> Option<&'static Chapter> {
    CHAPTERS.iter().find(|chapter| chapter.name == name)
}

impl Chapter {
    /// The functions that a student writes; their names are grade keys.
    pub fn exercises(&self) -> &'static [Asked] {
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
}

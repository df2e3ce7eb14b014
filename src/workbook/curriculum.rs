//! The curriculum as data. What a chapter says of itself stands once, at the top of its file in `chapters/`.

/// One chapter of the course.
#[derive(Clone, Copy, Debug)]
pub struct Chapter {
    /// The name of its binary, its folder of pictures and golden answers, and its page: `ch03_sphere`.
    pub name: &'static str,
    /// The functions that a student writes; the names are grade keys.
    pub exercises: &'static [&'static str],
    /// The text of `chapters/<name>.rs`.
    pub source: &'static str,
}

/// A row, from the chapter's name and its exercises.
macro_rules! chapter {
    ($name:literal, $exercises:expr) => {
        Chapter {
            name: $name,
            exercises: &$exercises,
            source: include_str!(concat!("../../chapters/", $name, ".rs")),
        }
    };
}

/// All chapters that exist, in order.
pub const CHAPTERS: &[Chapter] = &[
    chapter!("ch01_rays", ["ray_at", "camera_ray"]),
    chapter!("ch02_hdr", ["expose", "tone_map", "encode_srgb"]),
    chapter!(
        "ch03_sphere",
        ["solve_quadratic", "sphere_hit", "sphere_normal"]
    ),
    chapter!("ch04_plane", ["plane_hit"]),
    chapter!("ch05_box", ["box_clip", "bounds_of"]),
    chapter!("ch06_triangle", ["triangle_hit", "triangle_normal"]),
    chapter!(
        "ch07_mesh",
        [
            "interpolate_normal",
            "interpolate_texture",
            "vertex_normals",
            "mesh_hit"
        ]
    ),
];

/// The chapter whose binary has this name.
pub fn find(name: &str) -> Option<&'static Chapter> {
    CHAPTERS.iter().find(|row| row.name == name)
}

impl Chapter {
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

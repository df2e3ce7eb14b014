//! The tour: every chapter's pictures in one run.

use super::Done;
use clap::Args;
use indicatif::MultiProgress;
use raybook::lab::gallery::{self, Drawing};
use raybook::lab::options::Options;
use raybook::lab::say::say;
use raybook::lab::stage::{Drawn, Stage, progress_bar};
use raybook::workbook::curriculum::{CHAPTERS, Chapter};
use std::time::Instant;

/// The chapters' files once more, as modules: their `main`s are for their own binaries.
#[expect(
    dead_code,
    reason = "a chapter's `main` is called in its own binary only"
)]
#[path = "."]
mod chapters {
    #[path = "../../chapters/ch01_rays.rs"]
    pub mod ch01_rays;
    #[path = "../../chapters/ch02_hdr.rs"]
    pub mod ch02_hdr;
    #[path = "../../chapters/ch03_sphere.rs"]
    pub mod ch03_sphere;
    #[path = "../../chapters/ch04_plane.rs"]
    pub mod ch04_plane;
    #[path = "../../chapters/ch05_box.rs"]
    pub mod ch05_box;
    #[path = "../../chapters/ch06_triangle.rs"]
    pub mod ch06_triangle;
    #[path = "../../chapters/ch07_mesh.rs"]
    pub mod ch07_mesh;
    #[path = "../../chapters/ch08_grid.rs"]
    pub mod ch08_grid;
    #[path = "../../chapters/ch09_two_level_grid.rs"]
    pub mod ch09_two_level_grid;
    #[path = "../../chapters/ch10_octree.rs"]
    pub mod ch10_octree;
    #[path = "../../chapters/ch11_bvh.rs"]
    pub mod ch11_bvh;
    #[path = "../../chapters/ch12_phong.rs"]
    pub mod ch12_phong;
    #[path = "../../chapters/ch13_reflection.rs"]
    pub mod ch13_reflection;
    #[path = "../../chapters/ch14_refraction.rs"]
    pub mod ch14_refraction;
    #[path = "../../chapters/ch15_shadows.rs"]
    pub mod ch15_shadows;
    #[path = "../../chapters/ch16_soft_shadows.rs"]
    pub mod ch16_soft_shadows;
    #[path = "../../chapters/ch17_rendering_equation.rs"]
    pub mod ch17_rendering_equation;
    #[path = "../../chapters/ch18_environment.rs"]
    pub mod ch18_environment;
    #[path = "../../chapters/ch19_depth_of_field.rs"]
    pub mod ch19_depth_of_field;
    #[path = "../../chapters/ch20_panorama.rs"]
    pub mod ch20_panorama;
    #[path = "../../chapters/ch21_black_hole.rs"]
    pub mod ch21_black_hole;
    #[path = "../../chapters/ch22_antialiasing.rs"]
    pub mod ch22_antialiasing;
    #[path = "../../chapters/ch23_adaptive.rs"]
    pub mod ch23_adaptive;
    #[path = "../../chapters/ch24_wide_bvh.rs"]
    pub mod ch24_wide_bvh;
    #[path = "../../chapters/ch25_capstone.rs"]
    pub mod ch25_capstone;
}

/// Draws a chapter.
type Draw = fn(&Stage) -> Drawn;

/// How to draw each chapter, by name.
const DRAW: &[(&str, Draw)] = &[
    ("ch01_rays", chapters::ch01_rays::draw),
    ("ch02_hdr", chapters::ch02_hdr::draw),
    ("ch03_sphere", chapters::ch03_sphere::draw),
    ("ch04_plane", chapters::ch04_plane::draw),
    ("ch05_box", chapters::ch05_box::draw),
    ("ch06_triangle", chapters::ch06_triangle::draw),
    ("ch07_mesh", chapters::ch07_mesh::draw),
    ("ch08_grid", chapters::ch08_grid::draw),
    ("ch09_two_level_grid", chapters::ch09_two_level_grid::draw),
    ("ch10_octree", chapters::ch10_octree::draw),
    ("ch11_bvh", chapters::ch11_bvh::draw),
    ("ch12_phong", chapters::ch12_phong::draw),
    ("ch13_reflection", chapters::ch13_reflection::draw),
    ("ch14_refraction", chapters::ch14_refraction::draw),
    ("ch15_shadows", chapters::ch15_shadows::draw),
    ("ch16_soft_shadows", chapters::ch16_soft_shadows::draw),
    (
        "ch17_rendering_equation",
        chapters::ch17_rendering_equation::draw,
    ),
    ("ch18_environment", chapters::ch18_environment::draw),
    ("ch19_depth_of_field", chapters::ch19_depth_of_field::draw),
    ("ch20_panorama", chapters::ch20_panorama::draw),
    ("ch21_black_hole", chapters::ch21_black_hole::draw),
    ("ch22_antialiasing", chapters::ch22_antialiasing::draw),
    ("ch23_adaptive", chapters::ch23_adaptive::draw),
    ("ch24_wide_bvh", chapters::ch24_wide_bvh::draw),
    ("ch25_capstone", chapters::ch25_capstone::draw),
];

/// The options of `raybook tour`.
#[derive(Args)]
pub struct Tour {
    #[command(flatten)]
    options: Options,
    /// Only these chapters: 3,sphere,ch06
    #[arg(long, value_delimiter = ',')]
    only: Vec<String>,
}

impl Tour {
    /// Draws the chapters, one after the other, then the gallery.
    pub fn run(&self) -> Done {
        let start = Instant::now();
        let bars = MultiProgress::new();
        let mut drawings = Vec::new();
        for chapter in self.chosen()? {
            let (_, draw) = DRAW
                .iter()
                .find(|(name, _)| *name == chapter.name)
                .ok_or_else(|| format!("{} cannot be drawn", chapter.name))?;
            let chapter_start = Instant::now();
            let stage = Stage::new(
                chapter.name,
                self.options.clone(),
                false,
                bars.add(progress_bar()),
            );
            draw(&stage).map_err(|error| format!("{}: {error}", chapter.name))?;
            let (outputs, time) = (stage.into_outputs(), chapter_start.elapsed());
            if bars.is_hidden() {
                say(format!(
                    "{:<24} {} pictures in {:.1} s{}",
                    chapter.name,
                    outputs.len(),
                    time.as_secs_f32(),
                    gallery::rays(&outputs)
                ));
            }
            drawings.push(Drawing {
                chapter,
                outputs,
                time,
            });
        }
        let page = gallery::write(&self.options.out, &drawings)?;
        say(format!(
            "{} chapters in {:.1} s; look at {}",
            drawings.len(),
            start.elapsed().as_secs_f32(),
            page.display()
        ));
        Ok(true)
    }

    fn chosen(&self) -> Result<Vec<&'static Chapter>, String> {
        let names = || {
            CHAPTERS
                .iter()
                .map(|chapter| chapter.name)
                .collect::<Vec<_>>()
                .join(", ")
        };
        let answered = |word: &String| CHAPTERS.iter().any(|c| c.answers_to(word));
        if let Some(wrong) = self.only.iter().find(|word| !answered(word)) {
            return Err(format!(
                "--only {wrong}: no chapter is called so; there are {}",
                names()
            ));
        }
        let wanted = |chapter: &&Chapter| {
            self.only.is_empty() || self.only.iter().any(|word| chapter.answers_to(word))
        };
        Ok(CHAPTERS.iter().filter(wanted).collect())
    }
}

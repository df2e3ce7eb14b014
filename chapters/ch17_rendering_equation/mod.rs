//! The light that a surface sends to the eye came from all sides, also from other surfaces. An integral over the hemisphere
//! says how much of it there is, and path tracing estimates it by the mean over random paths, chosen with care.
//!
//! New: sample/mod.rs sample/hemisphere.rs material/lambert.rs material/modified_phong.rs
//! New: render/mis.rs render/path.rs render/reflection.rs scene/cornell.rs scene/plates.rs

mod domes;
mod path_error;
mod strategies;

use crate::kit::chapter;
use crate::kit::sheet::sheet;
use crate::kit::stage::{Drawn, Stage};
use clap::{Args, ValueEnum};
use raybook::image::Image;
use raybook::render::film::Film;
use raybook::render::mis::Strategy;
use raybook::render::path::Path;
use std::process::ExitCode;
use strategies::View;

/// Over as many surfaces as there are.
const ALL: Path = Path {
    depth: u32::MAX,
    roulette_after: 3,
    strategy: Strategy::Both,
};

/// Over one surface: straight from the lamp.
const DIRECT: Path = Path { depth: 1, ..ALL };

/// How the light straight from the lamp is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum By {
    /// Where the surface reflects much
    Surface,
    /// By a place on the lamp
    Light,
    /// By both, weighted
    Both,
}

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    /// Maximum number of surfaces along a path; without it, all of them
    #[arg(long, value_name = "1..1000 surfaces")]
    depth: Option<u32>,
    /// How the light straight from the lamp is found
    #[arg(long, value_enum, default_value = "both")]
    strategy: By,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let film = stage.film_of(400, 40, 1.0);
    let cornell_box = View::cornell_box()?;
    let path = Path {
        depth: knobs.depth.unwrap_or(ALL.depth),
        strategy: match knobs.strategy {
            By::Surface => Strategy::Surface,
            By::Light => Strategy::Light,
            By::Both => Strategy::Both,
        },
        ..ALL
    };
    let picture = denoised(&film, &cornell_box, path);
    let caption = "The Cornell box. Red and green light on the white blocks has come from the walls; \
        the ceiling gets no light from the lamp at all, only from the other surfaces. The remaining noise was averaged by a filter.";
    stage.picture("picture", caption, &picture)?;

    let few = Film {
        samples: film.samples.div_ceil(4),
        ..film
    };
    let tiles = [
        (
            "light straight from the lamp",
            denoised(&few, &cornell_box, DIRECT),
        ),
        ("with inter-reflections", picture),
    ];
    let caption = "Local and global illumination: without the light from other surfaces, ceiling and shadows are black.";
    stage.figure("inter_reflections", caption, &sheet(2, &tiles)?)?;

    let caption = "A mirror and glass in the box. The bright spot below the glass ball is a caustic: light of the lamp that the glass has gathered. \
        No ray to the lamp finds this light, only paths that happen to go through the glass. Light that very few paths find is left out.";
    let film = stage.film_of(320, 32, 1.0);
    stage.figure(
        "caustic",
        caption,
        &denoised(&film, &View::with_balls()?, ALL),
    )?;

    let caption = "600 directions of the hemisphere, and their shadows on the surface. Light counts in proportion to its cosine, so directions near the horizon are hardly worth their time.";
    stage.diagram("hemisphere", caption, &domes::draw()?)?;

    let caption = "Four plates, smooth behind and rough in front, mirror four lamps, small at the left and large at the right. \
        Directions by the surface find the large lamps, and directions by the light find the small lamps. Both together, with weights, find all lamps.";
    let tile = stage.tile(3, 1.5);
    let tile = Film {
        samples: tile.samples.div_ceil(2),
        ..tile
    };
    stage.figure("strategies", caption, &strategies::figure(&tile)?)?;

    let caption = "What the strategies cost, measured while this was drawn. Looking for the lamp itself pays in the box, and both together pay on the plates, also for the time that they take.";
    stage.diagram("error", caption, &path_error::plot(&tile)?)
}

/// A picture by paths, ready to be displayed: each ray of the camera begins a path, and what it finds is exposed.
fn photograph(film: &Film, view: &View, path: Path) -> Image {
    film.evenly(|place, numbers| {
        let ray = view.camera.ray_through(place);
        path.radiance(&view.scene, &ray, numbers) * view.exposure
    })
}

/// The same without the noise.
fn denoised(film: &Film, view: &View, path: Path) -> Image {
    film.denoised(|film| photograph(film, view, path))
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch17_rendering_equation")
}

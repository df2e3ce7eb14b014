//! The light that a surface sends to the eye came from all sides, also from other surfaces. An integral over the hemisphere
//! gives this light, and path tracing estimates the integral by the mean over random paths, chosen with care.
//!
//! New: sample/mod.rs sample/hemisphere.rs material/lambert.rs material/modified_phong.rs
//! New: render/mis.rs render/path.rs render/reflection.rs render/disc.rs render/photons.rs render/caustics.rs scene/cornell.rs scene/plates.rs

mod domes;
mod letters;
mod path_error;
mod quantities;
mod strategies;

use crate::kit::sheet::sheet;
use crate::kit::stage::{Drawn, Stage};
use crate::kit::{chapter, numbers::grouped};
use clap::{Args, ValueEnum};
use raybook::image::Image;
use raybook::image::denoise::Guide;
use raybook::render::caustics::Caustics;
use raybook::render::clamped::Clamped;
use raybook::render::film::Film;
use raybook::render::mis::Strategy;
use raybook::render::path::Path;
use raybook::render::photons::Photons;
use raybook::render::sampler::{Integrator, Sampler};
use raybook::scene::cornell;
use std::cell::LazyCell;
use std::process::ExitCode;
use strategies::View;

/// Paths without a maximum depth; Russian roulette ends them.
const ALL: Path = Path {
    depth: u32::MAX,
    roulette_after: 3,
    strategy: Strategy::Both,
};

/// Maximum of the brightest channel of a sample, in W·m⁻²·sr⁻¹: a tenth of the lamp's radiance, which is still displayed as white. So the
/// lamp's edges have no stairs. Of the light that surfaces reflect, this takes next to nothing, but for a caustic, which photons bring.
const BRIGHTEST: f32 = cornell::LAMP.r / 10.0;

/// Number of photons that the lamp emits for the caustics: one in 13 meets a ball and lands. With half as many, the walls have blotches.
const PHOTONS: usize = 500_000;

/// Distance up to which photons light a point, in metres: three pixels of the floor in front. The bright spot is 60 mm wide.
const RADIUS: f32 = 0.004;

/// Strategy that finds the light straight from the lamp.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum By {
    /// Directions into which the surface reflects much
    Surface,
    /// Directions towards random points of the lamp
    Light,
    /// Both, with weights (multiple importance sampling)
    Both,
}

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    /// Maximum number of surfaces along a path; if not given, there is no limit
    #[arg(long, value_name = "1..1000 surfaces")]
    depth: Option<u32>,
    /// Strategy that finds the light straight from the lamp
    #[arg(long, value_enum, default_value = "both")]
    strategy: By,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let film = stage.film_of(480, 16, 1.0);
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
    let limit = knobs.depth.map_or_else(String::new, |depth| {
        format!(" The maximum depth of a path is {depth}.")
    });
    let box_guides = LazyCell::new(|| guides(&film, &cornell_box));
    let picture = LazyCell::new(|| denoised(&film, &box_guides, &cornell_box, path));
    if stage.wants("picture") {
        let arrived = match path.depth {
            1 => "All light has come straight from the lamp, and the ceiling gets none.",
            _ => {
                "The red and green light on the white blocks has come from the walls. The ceiling gets no light straight from the \
                 lamp, only from the other surfaces."
            }
        };
        let by = match knobs.strategy {
            By::Surface => "directions into which the surfaces reflect much",
            By::Light => "directions towards the lamp",
            By::Both => "directions of both strategies, by the surface and by the light",
        };
        let caption = format!(
            "The Cornell box.{limit} {arrived} The lamp is found by {by}. A filter has removed the remaining noise."
        );
        stage.picture("picture", &caption, &picture)?;
    }

    stage.drawing("quantities", quantities::CAPTION, quantities::draw)?;
    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    if stage.wants("inter_reflections") {
        let global = knobs.depth.map_or_else(
            || "with inter-reflections".to_owned(),
            |depth| format!("with a maximum depth of {depth}"),
        );
        let global = global.as_str();
        let small = Film {
            width: (3 * film.width).div_ceil(4),
            height: (3 * film.height).div_ceil(4),
            ..film.halved()
        };
        // Straight from the lamp, directions by the light are as good as both, and take fewer rays.
        let straight = Path {
            depth: 1,
            strategy: Strategy::Light,
            ..path
        };
        let direct = denoised(
            &small,
            &guides(&small, &cornell_box),
            &cornell_box,
            straight,
        );
        let tiles = [
            ("light straight from the lamp", direct),
            (global, picture.resized(small.width, small.height)),
        ];
        let caption = "Local and global illumination: without the light from other surfaces, ceiling and shadows are black.";
        stage.figure("inter_reflections", caption, &sheet(2, &tiles)?)?;
    }

    if stage.wants("caustic") {
        draw_caustic(stage, path, &limit)?;
    }

    if stage.wants("hemisphere") {
        let caption = "600 directions of the hemisphere (blue), and their projections on the surface (orange): uniform on the left, \
            by the cosine on the right. Light counts in proportion to cos θ, so directions near the horizon contribute little.";
        stage.diagram("hemisphere", caption, &domes::draw()?)?;
    }

    let tile = stage.tile(3, 1.5).halved();
    if stage.wants("strategies") {
        let caption = "Four plates, smooth behind and rough in front, mirror four lamps, small at the left and large at the right; \
            the number of samples is the same in all tiles. Directions by the surface find the large lamps, and directions by the \
            light find the small lamps. Both together, with weights, find all lamps.";
        stage.figure("strategies", caption, &strategies::figure(&tile)?)?;
    }

    if !stage.wants("error") {
        return Ok(());
    }
    let caption = "The relative RMS error of each strategy, against the samples and against the time, measured while this figure \
        was drawn. In the box (top), directions by the light are as good as both together. On the plates (bottom), both together \
        have the smallest error, also for equal time.";
    stage.diagram("error", caption, &path_error::plot(&tile)?)
}

/// Draws the box with a mirror ball and a glass one. `limit` is the sentence that tells the depth of the paths.
fn draw_caustic(stage: &Stage, path: Path, limit: &str) -> Drawn {
    let caption = format!(
        "A mirror and glass in the box.{limit} From three surfaces on, there is a bright spot below the glass \
        ball, a caustic: light of the lamp that the glass has gathered. No ray to the lamp finds this light, and very few paths do. \
        {} photons, which start at the lamp, have brought it; a point is lit by those that have landed at most {:.0} mm from it.",
        grouped(PHOTONS as f64),
        1000.0 * RADIUS
    );
    let (film, balls) = (stage.film_of(384, 16, 1.0), View::with_balls()?);
    let caustics = Caustics {
        path,
        photons: Photons::shot(&balls.scene, PHOTONS, RADIUS, film.seed),
        brightest: BRIGHTEST,
    };
    let caustic = film.denoised(&guides(&film, &balls), |film| {
        photograph(film, &balls, &caustics)
    });
    stage.figure("caustic", &caption, &caustic)
}

/// A path-traced picture, ready to be displayed: each ray of the camera begins a path, and the mean radiance is exposed.
fn photograph(film: &Film, view: &View, integrator: &dyn Integrator) -> Image {
    let radiance = film.render(&view.camera, &Sampler::Even, integrator, &view.scene);
    radiance.map(|v| v * view.exposure)
}

/// What the camera sees, which is the same for all paths.
fn guides(film: &Film, view: &View) -> Vec<Guide> {
    film.guides(&view.camera, &view.scene)
}

/// The same picture, denoised by a filter that knows what the camera sees.
fn denoised(film: &Film, guides: &[Guide], view: &View, path: Path) -> Image {
    let path = Clamped {
        integrator: path,
        brightest: BRIGHTEST,
    };
    film.denoised(guides, |film| photograph(film, view, &path))
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch17_rendering_equation")
}

//! A whole ray tracer in one function: the radiance along a ray through a scene that is described in one line of text. Pictures
//! of four scenes of rising difficulty test it.
//!
//! New: image/rms.rs scene/description.rs scene/four_scenes.rs render/trace.rs

mod described;
mod letters;
mod misread;

use crate::kit::chapter;
use crate::kit::sheet::sheet;
use crate::kit::stage::{Drawn, Stage};
use clap::Args;
use clap::builder::PossibleValuesParser;
use glam::{Vec2, Vec3};
use raybook::camera::Camera;
use raybook::camera::pinhole::{LookAtError, Pinhole};
use raybook::image::Image;
use raybook::render::film::Film;
use raybook::render::trace::trace;
use raybook::scene::description::Description;
use raybook::scene::four_scenes::{ASPECT, FOUR, Staged};
use raybook_workbook::exercises::ch25_capstone::Trace;
use std::process::ExitCode;

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    /// Maximum number of surfaces in a row; if not given, each scene has its own
    #[arg(long, value_name = "1..64 surfaces")]
    depth: Option<u32>,
    /// Scene that is described, in `description`
    #[arg(long, default_value = FOUR[0].name, value_parser = PossibleValuesParser::new(FOUR.iter().map(|staged| staged.name)))]
    scene: String,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let tile = stage.tile(2, ASPECT);
    let samples = tile.samples.min(9);
    let film = Film { samples, ..tile };
    let see = |staged: &Staged| {
        let depth = knobs.depth.unwrap_or(staged.depth);
        photograph(&film, staged, &(staged.scene)(), depth)
    };
    if stage.wants("picture") {
        let mut tiles = Vec::new();
        for staged in &FOUR {
            tiles.push((staged.name, see(staged)?));
        }
        stage.picture(
        "picture",
        "Four scenes that test a whole ray tracer: one lamp on balls and a plane; three lamps and their shadows; mirrors in \
        mirrors; glass, with a bubble in the ball on the right.",
        &sheet(2, &tiles)?,
    )?;
    }
    let chosen = FOUR.iter().position(|staged| staged.name == knobs.scene);
    let chosen = chosen.ok_or("the knob has a scene's name")?;
    let chosen = &FOUR[chosen];
    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    if stage.wants("description") {
        let shown = see(chosen)?;
        let question = Trace {
            depth: chosen.depth,
            ray: camera(chosen)?.central_ray(Vec2::splat(0.5)),
            scene: (chosen.scene)(),
        };
        let words = described::words(shown.width(), shown.height(), &question)?;
        stage.figure(
        "description",
        &format!("The scene “{}”, and the line of text that describes the scene and the ray through the middle of the picture.", knobs.scene),
        &sheet(2, &[("the picture", shown), ("the question", words)])?,
    )?;
    }
    if !stage.wants("mistakes") {
        return Ok(());
    }
    let small = stage.tile(3, ASPECT);
    let samples = small.samples.min(4);
    let small = Film { samples, ..small };
    stage.figure(
        "mistakes",
        "What a mistake looks like: the right picture; the wrong picture, with its RMS error on a scale from 0 to 1; and the \
        places where the wrong picture is too bright (orange) or too dark (blue).",
        &misread::sheet(&|staged, scene, depth| photograph(&small, staged, scene, depth))?,
    )
}

fn camera(staged: &Staged) -> Result<Pinhole, LookAtError> {
    let [from, to] = staged.view;
    Pinhole::look_at(from, to, Vec3::Y, staged.focal_length, ASPECT)
}

/// The scene as its camera sees it.
fn photograph(
    film: &Film,
    staged: &Staged,
    scene: &Description,
    depth: u32,
) -> Result<Image, LookAtError> {
    let camera = camera(staged)?;
    Ok(film.refine(|place, _| trace(scene, &camera.central_ray(place), depth)))
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch25_capstone")
}

//! What a mirror shows is what another ray sees. So one ray asks for further rays, and together they form
//! a tree. Where mirrors face each other, a maximum depth must end the tree.
//!
//! New: material/mirror.rs material/polished.rs render/whitted.rs

mod letters;

pub mod kissing_balls;

use crate::kit::chapter;
use crate::kit::sheet::sheet;
use crate::kit::stage::{Drawn, Stage};
use crate::shared::{ray_tree, ray_tree_figure};
use clap::Args;
use glam::{Vec2, Vec3, vec2};
use raybook::camera::Camera;
use raybook::camera::pinhole::Pinhole;
use raybook::image::Image;
use raybook::render::film::Film;
use raybook::render::local::{Local, NO_SHADOWS};
use raybook::render::sampler::Sampler;
use raybook::render::whitted::Whitted;
use raybook::scene::world::Scene;
use raybook_scenes::{Shot, gallery};
use std::process::ExitCode;

/// The pixel whose tree is drawn: its place on the film.
const PIXEL: Vec2 = vec2(0.432, 0.76);

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    /// Maximum depth: number of surfaces that are followed in a row
    #[arg(long, value_name = "1..64 surfaces", default_value = "8")]
    depth: u32,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let film = stage.film(16.0 / 9.0);
    let Shot { scene, camera, .. } = gallery::MARBLES.shot(film.width)?;
    let depth = knobs.depth;
    if stage.wants("picture") {
        let caption = format!(
            "Two mirrors, seven marbles, and a floor that reflects a little less than a quarter of what it receives. \
            Up to {depth} surfaces are followed in a row. There are no shadows yet."
        );
        let picture = photograph(&film, &*camera, &scene, depth);
        stage.picture("picture", &caption, &picture)?;
    }

    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    if stage.wants("tree") {
        let (width, height) = ray_tree_figure::PHOTOGRAPH;
        let film = Film {
            width,
            height,
            samples: 4,
            ..stage.tile(2, 1.0)
        };
        let above = ray_tree_figure::above(film.aspect())?;
        let view = photograph(&film, &above, &scene, depth);
        let tree = ray_tree::grow(&whitted(depth.min(5)), &scene, &camera.central_ray(PIXEL));
        let caption = "The rays for one pixel of the picture, seen from above, and the same rays as a tree. Each circle has the \
            colour that its ray sees; the numbers stand for the surfaces that the rays meet.";
        stage.figure(
            "tree",
            caption,
            &ray_tree_figure::draw(&tree, &view, above)?,
        )?;
    }

    if !stage.wants("depth") {
        return Ok(());
    }
    let film = stage.tile(3, 1.0);
    let [from, to] = kissing_balls::VIEW;
    let camera = Pinhole::look_at(from, to, Vec3::Y, 0.055, film.aspect())?;
    let scene = kissing_balls::scene();
    let tiles = [
        ("no reflection", 1),
        ("1 reflection", 2),
        ("2 reflections", 3),
        ("3 reflections", 4),
        ("5 reflections", 6),
        ("11 reflections", 12),
    ];
    let tiles = tiles.map(|(name, depth)| (name, photograph(&film, &camera, &scene, depth)));
    let caption = "Four mirror balls that touch, before coloured light. Where no further surface is followed, the picture is black. Each additional reflection fills in a part of the black, a smaller part every time.";
    stage.figure("depth", caption, &sheet(3, &tiles)?)
}

/// Whitted's integrator that follows `depth` surfaces in a row; no shadows.
fn whitted(depth: u32) -> Whitted {
    let local = Local {
        samples: 1,
        arrives: NO_SHADOWS,
    };
    Whitted { local, depth }
}

fn photograph(film: &Film, camera: &dyn Camera, scene: &Scene, depth: u32) -> Image {
    film.render(camera, &Sampler::Refined, &whitted(depth), scene)
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch13_reflection")
}

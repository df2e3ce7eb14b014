//! Before a lamp counts, a ray asks whether anything is in its way: from just off the surface to just before the light.
//! Any hit is an answer, so the search ends at the first.
//!
//! New: render/shadow.rs

mod letters;
mod stairs;
mod wrong_shadows;

use crate::kit::chapter;
use crate::kit::sheet::sheet;
use crate::kit::stage::{Drawn, Stage};
use crate::shared::{ray_tree, ray_tree_figure};
use clap::Args;
use glam::{Vec2, Vec3, vec2, vec3};
use raybook::camera::Camera;
use raybook::camera::pinhole::Pinhole;
use raybook::image::Image;
use raybook::render::film::Film;
use raybook::render::local::Local;
use raybook::render::sampler::Sampler;
use raybook::render::shadow;
use raybook::render::whitted::Whitted;
use raybook::scene::world::Scene;
use raybook_scenes::{Shot, gallery};
use std::process::ExitCode;
use wrong_shadows::{ROOF, Way, length, starts_off, without_end};

/// The pixel whose rays are drawn: its place on the film.
const PIXEL: Vec2 = vec2(0.432, 0.76);

/// Where the camera of the second picture stands, and where it looks: at three of the marbles.
const CLOSE_UP: [Vec3; 2] = [vec3(0.3, 3.1, 7.4), vec3(1.3, 0.4, 1.3)];

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    /// Distance from the surface at which the shadow rays of the third tile start, in `wrong`
    #[arg(long, value_name = "0..5 m", default_value = "1")]
    offset: f32,
    /// Cells along the side of each patch of the coarse teapot, in `terminator`
    #[arg(long, value_name = "1..16 cells", default_value = "4")]
    cells: usize,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let film = stage.film(16.0 / 9.0);
    let Shot { scene, camera, .. } = gallery::MARBLES.shot(film.width)?;
    if stage.wants("picture") {
        let caption = "The marbles of chapter 13 with two shadows each: a shadow of the lamp, which is at the left, and a shadow \
            of the sun. Where both shadows fall, only ambient light is left.";
        stage.picture(
            "picture",
            caption,
            &photograph(&film, &*camera, &scene, &shadow::lit),
        )?;
    }

    let tile = stage.tile(2, 16.0 / 9.0);
    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    if stage.wants("wrong") {
        let film = Film {
            samples: 2 * tile.samples, // acne is finer than pixels
            ..tile
        };
        let [from, to] = CLOSE_UP;
        let near = Pinhole::look_at(from, to, Vec3::Y, 0.08, film.aspect())?;
        let mut roofed = gallery::MARBLES.with(ROOF, film.width)?.scene;
        roofed.lights.truncate(1); // the lamp; the roof takes the sun away
        let loose = format!("starts {} off: loose shadows", length(knobs.offset));
        let ways: [(&str, Way<'_>); 4] = [
            ("right", &shadow::lit),
            ("starts on the surface: acne", &starts_off(0.0)),
            (&loose, &starts_off(knobs.offset)),
            ("does not end at the lamp", &without_end),
        ];
        let tiles = ways.map(|(name, arrives)| (name, photograph(&film, &near, &roofed, arrives)));
        let caption = "One lamp below a roof: the right shadow rays, and three wrong ones. Because of rounding, many points of a \
            ball are computed to lie inside the ball, and so are in its shadow. Rays that start too far off miss objects that \
            are close. Rays without an end are stopped by objects behind the lamp.";
        stage.figure("wrong", caption, &sheet(2, &tiles)?)?;
    }

    if stage.wants("terminator") {
        let caption = "A coarse teapot under a low sun. Left: where the light ends, the facets can be seen as stairs, because each \
            facet lies in its own shadow as a whole. Right: shadow rays start where the round surface would be.";
        stage.figure("terminator", caption, &stairs::figure(&tile, knobs.cells)?)?;
    }

    if !stage.wants("tree") {
        return Ok(());
    }
    let (width, height) = ray_tree_figure::PHOTOGRAPH;
    let film = Film {
        width,
        height,
        samples: 4,
        ..film
    };
    let above = ray_tree_figure::above(film.aspect())?;
    let view = photograph(&film, &above, &scene, &shadow::lit);
    let tree = ray_tree::grow(
        &whitted(shadow::lit as _),
        &scene,
        &camera.central_ray(PIXEL),
    );
    let caption = "The tree of chapter 13 again: now each ray to a light looks for obstacles, and an obstacle makes a shadow (purple).";
    stage.figure(
        "tree",
        caption,
        &ray_tree_figure::draw(&tree, &view, above)?,
    )
}

fn whitted<A>(arrives: A) -> Whitted<A> {
    let local = Local {
        samples: 1,
        arrives: Some(arrives),
    };
    Whitted { local, depth: 8 }
}

fn photograph(film: &Film, camera: &dyn Camera, scene: &Scene, arrives: Way<'_>) -> Image {
    film.render(camera, &Sampler::Refined, &whitted(arrives), scene)
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch15_shadows")
}

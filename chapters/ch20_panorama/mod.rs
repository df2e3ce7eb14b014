//! A ray can start anywhere and go anywhere, so a camera need not have an image plane. A camera whose film holds all
//! directions takes an environment map; a fisheye sees nearly as much, in a disc.
//!
//! New: camera/pose.rs camera/panorama.rs camera/fisheye.rs

mod all_around;
mod graticule;
mod letters;
mod panorama_as_environment;
mod panorama_map;
pub mod pavilion;
mod projections;
pub mod summer;

use crate::kit::chapter;
use crate::kit::stage::{Drawn, Stage};
use all_around::{fisheyes, pinholes};
use clap::Args;
use panorama_as_environment::{lit, looks};
use panorama_map::{labelled, with_lines};
use pavilion::{BEAMS, EYE};
use raybook::camera::Camera;
use raybook::camera::fisheye::Fisheye;
use raybook::camera::panorama::Panorama;
use raybook::camera::pose::Pose;
use raybook::image::Image;
use raybook::light::environment::Environment;
use raybook::render::film::Film;
use raybook::render::local::Local;
use raybook::render::sampler::Sampler;
use raybook::render::shadow;
use raybook::render::whitted::Whitted;
use raybook::scene::world::Scene;
use std::cell::LazyCell;
use std::process::ExitCode;

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    /// Take the picture with a fisheye of this projection
    #[arg(long, value_enum)]
    projection: Option<projections::Named>,
    /// Angle of view of the fisheye, from rim to rim
    #[arg(
        long,
        value_name = "1..360 °",
        default_value = "180",
        requires = "projection"
    )]
    view: f32,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let (pose, scene) = (Pose::level(EYE), pavilion::scene());
    if let Some(projections::Named(projection)) = knobs.projection {
        if !stage.wants("picture") {
            return Ok(());
        }
        let film = stage.film_of(720, 9, 1.0);
        let camera = Fisheye::new(pose, projection, knobs.view, film.aspect())?;
        let picture = photograph(&scene, &film, &camera);
        let caption = format!(
            "A picture by a fisheye that sees {}° from rim to rim.",
            knobs.view
        );
        return stage.picture("picture", &caption, &picture);
    }
    let camera = Panorama { pose };
    let take = |film: &Film, camera: &dyn Camera| photograph(&scene, film, camera);
    let film = stage.film_of(960, 9, 2.0);
    let picture = LazyCell::new(|| take(&film, &camera));
    if stage.wants("picture") {
        let caption = "Everything that is seen from one point. The left and the right edge are one line, behind the viewer. The whole top edge is a single direction, straight up, and the whole bottom edge is straight down.";
        stage.picture("picture", caption, &picture)?;
    }
    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    if stage.wants("graticule") {
        let caption = "The same panorama with lines of latitude and longitude, every 30°. Each small white disc has a radius of 6°: \
            towards the poles, the map stretches the discs.";
        stage.figure("graticule", caption, &labelled(&picture)?)?;
    }
    if stage.wants("lines") {
        let caption = "The four beams are straight in space, and are curves on the map. Prolonged without end (dashed), a straight \
            line is half of a great circle, and parallel lines meet at the horizon.";
        let lines = with_lines(&picture, EYE, &BEAMS)?;
        stage.figure("lines", caption, &lines)?;
    }

    let samples = film.samples.min(4);
    let [wide, square] = [(3, 1.5), (4, 1.0)].map(|(columns, aspect)| Film {
        samples,
        ..stage.tile(columns, aspect)
    });
    if stage.wants("pinhole") {
        let caption = "A pin-hole camera keeps lines straight. In return it stretches objects far from the middle, without limit towards 180°. Each small white disc has a radius of 6°.";
        stage.figure("pinhole", caption, &pinholes(&wide, EYE, take)?)?;
    }
    if stage.wants("fisheye") {
        let caption = "Fisheyes: half of all directions in the four projections; below, all directions or nearly all, with the camera looking ahead, down and up. Each small white disc has a radius of 6°.";
        stage.figure("fisheye", caption, &fisheyes(&square, EYE, take)?)?;
    }

    let around = LazyCell::new(|| Environment::new(picture.clone()));
    if stage.wants("looks") {
        let caption = "Top: the scene itself. Middle: the panorama as an environment map, seen from the point where it was taken. \
            Bottom: the difference, which lies along edges and is narrower than a pixel of the map.";
        stage.figure("looks", caption, &looks(&wide, EYE, &around, take)?)?;
    }
    if !stage.wants("light") {
        return Ok(());
    }
    let caption = "Chapter 18's still life in the light of the panorama. On the right, the map is cut off at white, and so is \
        its sun: there is next to no sunlight, and no shadow. What is behind the still life is a photograph of the scene.";
    let tile = stage.tile(2, 1.5).halved();
    stage.figure("light", caption, &lit(&tile, EYE, &around, take)?)
}

/// What a camera sees of a scene.
fn photograph(scene: &Scene, film: &Film, camera: &dyn Camera) -> Image {
    let local = Local {
        samples: 1,
        arrives: Some(shadow::lit),
    };
    let whitted = Whitted { local, depth: 8 };
    film.render(camera, &Sampler::Refined, &whitted, scene)
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch20_panorama")
}

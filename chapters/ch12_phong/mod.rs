//! Light that comes straight from a lamp, and what a surface makes of it: ambient, diffuse and specular reflection after
//! Phong, the half vector after Blinn. Point lights fall off with the squared distance, directional lights do not.
//!
//! New: light/mod.rs light/point.rs light/directional.rs material/mod.rs material/phong.rs material/blinn_phong.rs
//! New: material/checkered.rs scene/world.rs render/local.rs

mod bench;
mod floors;
mod letters;
mod lobes;

use crate::kit::chapter;
use crate::kit::sheet::sheet;
use crate::kit::stage::{Drawn, Stage};
use clap::Args;
use glam::{Mat3, Vec3, vec3};
use raybook::camera::pinhole::Pinhole;
use raybook::image::Image;
use raybook::material::blinn_phong::BlinnPhong;
use raybook::render::film::Film;
use raybook::render::local::{Local, NO_SHADOWS};
use raybook::render::sampler::Sampler;
use raybook::scene::world::Scene;
use std::process::ExitCode;

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    /// Exponent α of Phong's highlight; the middle row has the exponents α/4, α, 4α and 16α
    #[arg(long, value_name = "1..1024", default_value = "16")]
    exponent: f32,
    /// Angle between light and normal, in `lobes`
    #[arg(long, value_name = "0..89 °", default_value = "40")]
    incidence: f32,
    /// Angle by which the lights turn around the balls, to the right
    #[arg(long, value_name = "-180..180 °", default_value = "0")]
    turn: f32,
    /// Height of the point light over the tiles, in `floors`
    #[arg(long, value_name = "0.2..5 m", default_value = "1.3")]
    lamp: f32,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let turn = Mat3::from_rotation_y(knobs.turn.to_radians());
    let film = stage.tile(4, 1.0);
    let camera = Pinhole::look_at(vec3(0.0, 0.0, 7.0), Vec3::ZERO, Vec3::Y, 0.072, 1.0)?;
    if stage.wants("picture") {
        let balls = bench::terms(knobs.exponent, turn)
            .into_iter()
            .chain(bench::exponents(knobs.exponent, turn));
        let balls: Vec<_> = balls
            .map(|(name, scene)| (name, photograph(&film, &camera, &scene)))
            .collect();
        let balls: Vec<_> = balls
            .iter()
            .map(|(name, ball)| (&**name, ball.clone()))
            .collect();
        let caption = "Top: the terms of Phong's formula added one by one, and then a second light. Middle: Phong's highlight with \
            growing exponents α. Bottom: Blinn's highlight with four times the exponent, α′ = 4α, which is about as large.";
        stage.picture("picture", caption, &sheet(4, &balls)?)?;
    }

    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    if stage.wants("lobes") {
        let caption = "The direction l to the light points to the left, and m is its mirror direction. The curves show how much light a point sends into each direction. In the \
            plane of light and normal (left), Blinn's lobe with four times the exponent is nearly the same as Phong's. Out of that \
            plane, under slanting light (right), Blinn's lobe is much narrower.";
        stage.diagram(
            "lobes",
            caption,
            &lobes::draw(knobs.exponent, knobs.incidence)?,
        )?;
    }

    if !stage.wants("floors") {
        return Ok(());
    }
    let film = stage.tile(2, 1.6);
    let (from, to) = (vec3(0.0, 1.6, 5.5), vec3(0.0, 0.4, 0.0));
    let camera = Pinhole::look_at(from, to, Vec3::Y, 0.03, film.aspect())?;
    let tile = |scene| photograph(&film, &camera, &scene);
    let phong = floors::wet(64.0, |phong| phong);
    let blinn = floors::wet(256.0, BlinnPhong);
    let tiles = [
        ("a point light", tile(floors::under_lamp(knobs.lamp))),
        ("a directional light", tile(floors::under_sun())),
        ("Phong, α = 64", tile(phong)),
        ("Blinn, α′ = 256", tile(blinn)),
    ];
    let caption = "Top: a lamp between balls, and the sun over them. Bottom: lamps far behind on a dark, shining floor: Phong's \
        highlights are round, and Blinn's are long and narrow, as on a wet road.";
    stage.figure("floors", caption, &sheet(2, &tiles)?)
}

/// What a camera sees in the light of the lamps alone, without shadows.
fn photograph(film: &Film, camera: &Pinhole, scene: &Scene) -> Image {
    let local = Local {
        samples: 1,
        arrives: NO_SHADOWS,
    };
    film.render(camera, &Sampler::Refined, &local, scene)
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch12_phong")
}

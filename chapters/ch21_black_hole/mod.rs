//! Rays need not be straight. Around a black hole they obey a differential equation, and a picture is made by solving this
//! equation step by step, as carefully as needed and no more.
//!
//! New: render/curved/mod.rs render/curved/geodesic.rs render/curved/follow.rs render/curved/deflection.rs
//! New: render/curved/fan.rs render/curved/observer.rs render/curved/doppler.rs render/curved/black_hole.rs
//! New: light/black_body.rs scene/accretion_disc.rs

mod bent_rays;
pub mod deflection_plot;
mod hole_shadows;
mod letters;
mod simplified;
pub mod starry_sky;
mod straight_hole;

use crate::kit::chapter;
use crate::kit::stage::{Drawn, Stage};
use clap::Args;
use glam::{Mat3, vec2, vec3};
use raybook::camera::Camera;
use raybook::camera::pinhole::Pinhole;
use raybook::image::file;
use raybook::image::rgb::Rgb;
use raybook::light::environment::Environment;
use raybook::math::dir3::Dir3;
use raybook::render::curved::black_hole::BlackHole;
use raybook::render::curved::fan::Fan;
use raybook::render::film::Film;
use raybook::scene::accretion_disc::AccretionDisc;
use starry_sky::starry_sky;
use std::cell::LazyCell;
use std::path::PathBuf;
use std::process::ExitCode;

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    /// Distance of the observer from the hole, in radii of its horizon
    #[arg(long, value_name = "13..200 radii", default_value = "17")]
    distance: f32,
    /// Angle by which the view is spun around its middle
    #[arg(long, value_name = "-180..180 °", default_value = "0")]
    spin: f32,
    /// Temperature of the disc where it is hottest
    #[arg(long, value_name = "1000..40000 K", default_value = "5500")]
    temperature: f32,
    /// Put the hole before this latitude–longitude map (.exr, .hdr or .png) instead of the stars
    #[arg(long, value_name = "FILE", visible_alias = "map")]
    environment: Option<PathBuf>,
}

/// How the picture is exposed.
const EXPOSURE: f32 = 1.1;

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let Some(path) = &knobs.environment else {
        return draw_before(stage, knobs, &starry_sky);
    };
    let map = Environment::new(file::load(path)?);
    draw_before(stage, knobs, &|toward| map.radiance(toward))
}

/// Draws the pictures with this sky behind everything: radiance by direction.
fn draw_before(stage: &Stage, knobs: &Knobs, sky: &(dyn Fn(Dir3) -> Rgb + Sync)) -> Drawn {
    let film = stage.film_of(960, 5, 1.78);
    let spin = Mat3::from_rotation_z(knobs.spin.to_radians());
    let (eye, at, up) = (
        vec3(0.0, 1.9, 17.0) * (knobs.distance / 17.0),
        vec3(0.0, -0.2, 0.0),
        spin * vec3(0.18, 1.0, 0.0),
    );
    let camera = Pinhole::look_at(eye, at, up, 0.0225, film.aspect())?;
    let disc = AccretionDisc::new(11.0, knobs.temperature);
    let hole = BlackHole {
        disc: Some(&disc),
        sky,
    };
    let fan = LazyCell::new(|| fan(&camera, &film));
    if stage.wants("picture") {
        let fan = &*fan;
        let picture = film.refine(|place, _| {
            hole.radiance_by(fan, camera.central_ray(place).direction) * EXPOSURE
        });
        let caption = "A black hole and a disc of hot gas. The arch above the shadow is the far side of the disc, whose light is bent over the hole. The left side of the disc comes towards us, and is bluer and brighter.";
        stage.picture("picture", caption, &picture)?;
    }

    let tile = |columns, aspect| Film {
        samples: film.samples,
        ..stage.tile(columns, aspect)
    };
    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    if stage.wants("straight_and_bent") {
        let caption = format!(
            "The same ball and disc without gravity and with it: the far side appears above the hole and below it, and the shadow is \
            larger than the ball. All rays at the same angle to the hole follow one curve, turned around the axis from the eye to \
            the hole: {} curves were followed step by step for the picture.",
            fan.curves()
        );
        let figure = straight_hole::compare(&tile(2, 1.78), &camera, &hole, &fan, EXPOSURE)?;
        stage.figure("straight_and_bent", &caption, &figure)?;
    }

    if stage.wants("rays") {
        let caption = "Parallel rays from the left. The hole swallows rays with an impact parameter b, the distance from the axis, \
            below 2.598 radii of the hole (vermilion). The next rays turn back or go around the hole before they leave.";
        stage.diagram("rays", caption, &bent_rays::draw()?)?;
    }
    if stage.wants("deflection") {
        let caption = "The angle by which the hole turns a ray with the impact parameter b. For large b the angle is 2/b radians \
            (dashed); towards b = 2.598 it grows without limit. The dots are rays that were followed step by step.";
        stage.diagram("deflection", caption, &deflection_plot::draw()?)?;
    }
    if !stage.wants("shadows") {
        return Ok(());
    }
    let caption = "Half of the sky, towards the hole, for observers nearer and nearer to the hole; r is in radii of the hole. \
        The dashed circle and the angle are the edge of the shadow by the formula.";
    stage.figure("shadows", caption, &hole_shadows::draw(&tile(4, 1.0))?)
}

/// The curves for a camera's picture, a quarter of a pixel from each other at most.
fn fan(camera: &Pinhole, film: &Film) -> Fan {
    let eye = camera.focal_point;
    let pixel = camera.plane.x / camera.focal_length / film.width as f32;
    let corners = [
        vec2(0.0, 0.0),
        vec2(1.0, 0.0),
        vec2(0.0, 1.0),
        vec2(1.0, 1.0),
    ];
    let off = |corner| camera.central_ray(corner).direction.angle_between(-eye);
    let widest = corners.map(off).into_iter().fold(0.0, f32::max);
    Fan::new(eye, f64::from(widest), f64::from(0.25 * pixel))
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch21_black_hole")
}

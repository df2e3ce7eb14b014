//! Rays need not be straight. Around a black hole they obey a differential equation, and a picture is made by solving it for
//! every pixel, step by step, as carefully as needed and no more.
//!
//! New: render/curved/mod.rs render/curved/geodesic.rs render/curved/follow.rs render/curved/deflection.rs
//! New: render/curved/observer.rs render/curved/doppler.rs render/curved/black_hole.rs
//! New: light/black_body.rs scene/accretion_disc.rs scene/starry_sky.rs

mod bent_rays;
pub mod deflection_plot;
mod hole_shadows;
mod straight_hole;

use glam::vec3;
use raybook::camera::pinhole::Pinhole;
use raybook::image::{file, rgb::Rgb};
use crate::kit::{stage::Drawn, stage::Stage};

use crate::kit::chapter;
use raybook::light::environment::Environment;
use raybook::math::dir3::Dir3;
use raybook::render::{curved::black_hole::BlackHole, film::Film};
use raybook::scene::{accretion_disc::AccretionDisc, starry_sky::starry_sky};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

#[derive(clap::Args)]
struct BackgroundOptions {
    /// Put the hole before this latitude–longitude map (.exr, .hdr or .png) instead of the stars
    #[arg(long)]
    environment: Option<PathBuf>,
}

/// How the picture is exposed.
const EXPOSURE: f32 = 1.1;

/// Draws the chapter's pictures.
pub fn draw(stage: &Stage) -> Drawn {
    draw_before(stage, &starry_sky)
}

/// With this radiance by direction behind everything.
fn draw_before(stage: &Stage, sky: &(dyn Fn(Dir3) -> Rgb + Sync)) -> Drawn {
    let film = stage.film_of(960, 4, 1.78);
    let (eye, at, up) = (
        vec3(0.0, 1.9, 17.0),
        vec3(0.0, -0.2, 0.0),
        vec3(0.18, 1.0, 0.0),
    );
    let camera = Pinhole::look_at(eye, at, up, 0.0225, film.aspect())?;
    let disc = AccretionDisc::new(11.0, 5500.0);
    let hole = BlackHole {
        disc: Some(&disc),
        sky,
    };
    let start = Instant::now();
    let picture = film.render(|place, _| {
        let ray = camera.ray_through(place);
        hole.radiance(ray.origin, ray.direction) * EXPOSURE
    });
    let rays = (film.width * film.height * film.samples) as f64;
    let rate = 1e-6 * rays / start.elapsed().as_secs_f64();
    let caption = "A black hole and a disc of hot gas. The arch above the shadow is the disc's far side, its light bent over the hole; \
        the left side comes towards us, and is bluer and brighter.";
    stage.picture("picture", caption, &picture)?;

    let tile = |columns, aspect| Film {
        samples: film.samples,
        ..stage.tile(columns, aspect)
    };
    let caption = format!(
        "The same ball and disc without gravity and with it: the far side appears above the hole and below it, and the shadow \
        is larger than the ball. Rays were followed at {rate:.2} million per second."
    );
    let figure = straight_hole::compare(&tile(2, 1.78), &camera, &hole, EXPOSURE)?;
    stage.figure("straight_and_bent", &caption, &figure)?;

    let caption = "Rays from the left at many distances from the middle: the hole swallows those below 2.598 radii (orange). The next ones turn back or go around before they leave.";
    stage.figure("rays", caption, &bent_rays::draw()?)?;
    let caption = "The angle by which a ray is turned. Far away it is 2/b; towards 2.598 it grows without limit. The dots are rays followed step by step.";
    stage.figure("deflection", caption, &deflection_plot::draw()?)?;
    let caption = "Half of the sky, towards the hole, for observers who stand nearer and nearer. The dashed circles are the shadow's edge by the formula.";
    stage.figure("shadows", caption, &hole_shadows::draw(&tile(4, 1.0))?)
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run_with("ch21_black_hole", |stage, options: BackgroundOptions| {
        let Some(path) = options.environment else {
            return draw(stage);
        };
        let map = Environment::new(file::load(&path)?);
        draw_before(stage, &|toward| map.radiance(toward))
    })
}

//! A light with an extent is seen in part from the edge of a shadow: between the umbra and full light lies the penumbra.
//! Points of the light are chosen at random, by its area or by its solid angle, and a shadow ray goes to each point.
//!
//! New: light/extent.rs light/rect_light.rs light/sphere_light.rs render/soft_shadow.rs

mod cells;
mod letters;

pub mod light_error;
pub mod penumbra;
pub mod posts;

use crate::kit::chapter;
use crate::kit::sheet::sheet;
use crate::kit::stage::{Drawn, Stage};
use clap::Args;
use glam::Vec3;
use raybook::camera::Camera;
use raybook::camera::pinhole::Pinhole;
use raybook::light::Light;
use raybook::math::pcg::Pcg;
use raybook::render::film::Film;
use raybook::render::local::Local;
use raybook::render::sampler::Sampler;
use raybook::render::shadow;
use raybook::render::whitted::Whitted;
use raybook_scenes::{Shot, gallery};
use std::process::ExitCode;

/// Direct light alone, by `samples` shadow rays to each light for each sample of a pixel. One ray is enough: the samples of a
/// pixel that smooth edges also smooth the penumbrae.
const fn with_samples(samples: u32) -> Whitted {
    let local = Local {
        samples,
        arrives: Some(shadow::lit as _),
    };
    Whitted { local, depth: 1 }
}

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    /// Side of the square lamp; the light that it sends straight down does not depend on its size
    #[arg(long, value_name = "0.05..4 m", default_value = "1.4")]
    lamp: f32,
    /// Shadow rays to the lamp for each sample of a pixel
    #[arg(long, value_name = "1..256 rays", default_value = "1")]
    rays: u32,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let film = stage.film_of(960, 8, 16.0 / 9.0);
    let Shot { scene, camera, .. } = gallery::POSTS.under(posts::square(knobs.lamp), film.width)?;
    let whitted = with_samples(knobs.rays);
    if stage.wants("picture") {
        let picture = film.denoised(&[], |film| {
            film.render(&*camera, &Sampler::Refined, &whitted, &scene)
        });
        let caption = format!(
            "Under a square light of {} m, shadows are sharp near the object that casts them, and become softer with the \
            distance from it. A filter has removed the noise.",
            knobs.lamp
        );
        stage.picture("picture", &caption, &picture)?;
    }

    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    if stage.wants("cells") {
        let (diagram, caption) = cells::draw()?;
        stage.diagram("cells", &caption, &diagram?)?;
    }

    let tile = stage.tile(4, 1.0);
    let (from, to, focal_length) = posts::CLOSE;
    let close = Pinhole::look_at(from, to, Vec3::Y, focal_length, tile.aspect())?;
    if stage.wants("samples") {
        let one_ray = Film { samples: 1, ..tile };
        let counts = [("1 sample", 1), ("4", 4), ("16", 16), ("64", 64)];
        let tiles = counts.map(|(name, samples)| {
            let whitted = with_samples(samples);
            let see = |place, rng: &mut Pcg| whitted.follow(&scene, &close.central_ray(place), rng);
            (name, one_ray.sample(see))
        });
        let caption = "One, 4, 16 and 64 samples of the light per pixel: four times as many samples halve the noise. The noise \
            is strongest where a part of the light is seen. There is no noise in the umbra, where no part of the light is seen.";
        stage.figure("samples", caption, &sheet(4, &tiles)?)?;
    }

    if stage.wants("lights") {
        let lights: [(&str, Box<dyn Light>); 4] = [
            ("a point", posts::point()),
            ("a square of 0.4 m", posts::square(0.4)),
            ("a square of 2.4 m", posts::square(2.4)),
            ("a sphere of 2.4 m", posts::sphere(1.2)),
        ];
        let more = with_samples(3 * knobs.rays);
        let mut tiles = Vec::new();
        for (name, light) in lights {
            let scene = gallery::POSTS.under(light, tile.width)?.scene;
            let picture = tile.render(&close, &Sampler::Refined, &more, &scene);
            tiles.push((name, picture));
        }
        let caption = "The same place under a point, a small and a large square, and a sphere: the larger the light, the wider the penumbra.";
        stage.figure("lights", caption, &sheet(4, &tiles)?)?;
    }

    if stage.wants("penumbra") {
        let caption = "The ends of the umbra and of the penumbra follow from similar triangles (orange). The fraction of the light \
            that is seen is estimated by 2000 random samples at each place (blue).";
        stage.diagram("penumbra", caption, &penumbra::diagram()?)?;
    }
    if !stage.wants("error") {
        return Ok(());
    }
    let caption = format!(
        "The relative RMS error of the irradiance against the number of samples, from {} repetitions each: a straight \
        line of slope −½. For a near light, samples by solid angle have a smaller error than samples by area. With an obstacle \
        before the light, they are no better.",
        light_error::REPEATS
    );
    stage.diagram("error", &caption, &light_error::plot()?)
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch16_soft_shadows")
}

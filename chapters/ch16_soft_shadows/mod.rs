//! A light with an extent is seen in part from the edge of a shadow: between the umbra and full light lies the penumbra.
//! Points of the light are chosen at random, by its area or by its solid angle, and each sends a shadow ray.
//!
//! New: light/extent.rs light/rect_light.rs light/sphere_light.rs render/soft_shadow.rs scene/posts.rs

pub mod light_error;
pub mod penumbra;

use glam::Vec3;
use raybook::camera::pinhole::{LookAtError, Pinhole};
use raybook::image::Image;
use crate::kit::{stage::Drawn, stage::Stage};
use crate::kit::{chapter, sheet::sheet};

use raybook::light::Light;
use raybook::render::{film::Film, local::Local, shadow, whitted::Whitted};
use raybook::scene::posts;
use std::process::ExitCode;

/// Draws the chapter's pictures.
pub fn draw(stage: &Stage) -> Drawn {
    let [whole, close] = posts::VIEWS;
    let film = stage.film_of(960, 9, 16.0 / 9.0);
    let picture = photograph(&film, posts::square(1.4), 12, whole)?;
    let caption = "Under a square light of 1.4 m, shadows are sharp near what throws them, and the softer the farther away they fall.";
    stage.picture("picture", caption, &picture)?;

    let mut tile = stage.tile(4, 1.0);
    tile.samples = 1;
    let mut tiles = Vec::new();
    for (name, samples) in [("1 sample", 1), ("4", 4), ("16", 16), ("64", 64)] {
        tiles.push((name, photograph(&tile, posts::square(1.4), samples, close)?));
    }
    let caption = "One, 4, 16 and 64 samples of the light per pixel: with four times as many, half the noise. It is coarsest where part of the light is seen, and there is none where nothing is.";
    stage.figure("samples", caption, &sheet(4, &tiles)?)?;

    tile.samples = film.samples.min(4);
    let lights: [(&str, Box<dyn Light>); 4] = [
        ("a point", posts::point()),
        ("a square of 0.4 m", posts::square(0.4)),
        ("a square of 2.4 m", posts::square(2.4)),
        ("a sphere of 2.4 m", posts::sphere(1.2)),
    ];
    let mut tiles = Vec::new();
    for (name, light) in lights {
        tiles.push((name, photograph(&tile, light, 20, close)?));
    }
    let caption = "The same place under a point, a small and a large square, and a sphere: the larger the light, the wider the penumbra.";
    stage.figure("lights", caption, &sheet(4, &tiles)?)?;

    let caption = "Where the umbra and the penumbra end follows from similar triangles (orange); the fraction of the light that is seen is measured by 2000 samples at each place (blue).";
    stage.figure("penumbra", caption, &penumbra::diagram()?)?;
    let caption = "The error of what arrives, against the number of samples: a straight line of slope −½. Samples by solid angle are better for a near light; about what is in the way they know no more.";
    stage.figure("error", caption, &light_error::plot()?)
}

/// A picture with so many shadow rays per sample of a pixel.
fn photograph(
    film: &Film,
    light: Box<dyn Light>,
    samples: u32,
    (from, to, focal_length): (Vec3, Vec3, f32),
) -> Result<Image, LookAtError> {
    let camera = Pinhole::look_at(from, to, Vec3::Y, focal_length, film.aspect())?;
    let (scene, local) = (
        posts::under(light),
        Local {
            samples,
            arrives: Some(shadow::lit),
        },
    );
    let whitted = Whitted { local, depth: 1 };
    Ok(film.render(|place, rng| whitted.follow(&scene, &camera.ray_through(place), rng)))
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch16_soft_shadows", draw)
}

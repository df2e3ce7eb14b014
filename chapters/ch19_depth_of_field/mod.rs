//! A lens gathers light with all of its opening, and unites it again for one distance only. What is nearer or farther becomes
//! a blurred disc, whose size a formula tells.
//!
//! New: shape/placed.rs sample/disk.rs sample/polygon.rs camera/aperture.rs camera/lens.rs camera/thin_lens.rs
//! New: render/through_lens.rs render/glints.rs

mod blur_plot;
mod bokeh;
mod lens_samples;
pub mod tea_table;

use crate::kit::chapter;
use crate::kit::sheet::sheet;
use crate::kit::stage::{Drawn, Stage};
use crate::lab::sheets::named;
use glam::Vec3;
use raybook::camera::aperture::Aperture;
use raybook::camera::lens::LensError;
use raybook::camera::pinhole::Pinhole;
use raybook::camera::thin_lens::ThinLens;
use raybook::math::interval::Interval;
use raybook::render::film::Film;
use raybook::render::glints::add_glints;
use raybook::render::local::Local;
use raybook::render::shadow;
use raybook::render::through_lens::through_lens;
use raybook::render::whitted::Whitted;
use std::process::ExitCode;
use tea_table::{ALONG, EYE, FAR, FOCAL_LENGTH, NARROW_VIEW, POTS, VIEW, lamps, tea_table};

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage) -> Drawn {
    let (scene, lamps) = (tea_table(), lamps());
    let arrives = Some(shadow::lit as _);
    let local = Local {
        samples: 1,
        arrives,
    };
    let whitted = Whitted { local, depth: 2 };
    let open = |ray: &_, distance| !scene.blocks(ray, Interval::new(0.0, distance));
    let photograph = |film: &Film, camera: &ThinLens| {
        let mut picture = through_lens(film, camera, |ray, numbers| {
            whitted.follow(&scene, ray, numbers)
        });
        add_glints(&mut picture, film, camera, &lamps, open);
        picture
    };

    let film = stage.film_of(960, 32, 16.0 / 9.0);
    let body = Pinhole::look_at(EYE, VIEW, Vec3::Y, FOCAL_LENGTH, film.aspect())?;
    let caption = "A lens of 50 mm at f/1.4, focused on the red teapot. What is nearer or farther is blurred, and every lamp becomes a hexagon: the hole that six blades leave open.";
    let picture = photograph(&film, &focused(&body, POTS[1], 1.4)?);
    stage.picture("picture", caption, &picture)?;

    let caption = "With few random points of the lens there is noise where the picture is blurred, and hardly any where it is sharp. Points that are spread evenly over the lens have less of it.";
    let figure = lens_samples::draw(&stage.tile(3, 1.6), &scene, &whitted)?;
    stage.figure("samples", caption, &figure)?;

    let (tile, mut tiles) = (stage.tile(2, 16.0 / 9.0), vec![]);
    for f_number in [f32::INFINITY, 8.0, 2.8, 1.4] {
        let camera = focused(&body, POTS[1], f_number)?;
        tiles.push((format!("f/{f_number}"), photograph(&tile, &camera)));
    }
    tiles[0].0 = String::from("a pin-hole: f/∞");
    let caption = "The same focus with four apertures: the larger one blurs more. Through a pin-hole all is sharp, and a lamp is no larger than a pixel.";
    stage.figure("apertures", caption, &sheet(2, &named(&tiles))?)?;

    let (tile, mut tiles) = (stage.tile(4, 1.0), vec![]);
    let samples = 3 * tile.samples; // most of it is blurred
    let tile = Film { samples, ..tile };
    let body = Pinhole::look_at(ALONG, NARROW_VIEW, Vec3::Y, FOCAL_LENGTH, tile.aspect())?;
    for at in POTS.into_iter().chain([FAR]) {
        let camera = focused(&body, at, 1.4)?;
        let name = format!("{:.1} m", camera.lens.focus);
        tiles.push((name, photograph(&tile, &camera)));
    }
    let caption = "A focus pull: the film moves towards the lens, and what is sharp moves away from it, from teapot to teapot, and to the lamps far behind.";
    stage.figure("focus_pull", caption, &sheet(6, &named(&tiles))?)?;

    let caption = "Lamps out of focus, seen through a round hole and through 5, 6 and 8 blades.";
    stage.figure("bokeh", caption, &bokeh::draw(&stage.tile(4, 1.0))?)?;
    let caption = "The circle of confusion of a 50 mm lens that is focused at 2 m. As long as it is smaller than a pixel, nobody sees it: the shaded ranges are the depth of field.";
    stage.figure("blur", caption, &blur_plot::plot()?)
}

/// The camera with six blades before its lens, focused on the plane in which a point lies.
fn focused(body: &Pinhole, at: Vec3, f_number: f32) -> Result<ThinLens, LensError> {
    let focus = (at - body.focal_point).dot(*body.forward);
    let (count, turn) = (6, 0.0);
    ThinLens::new(body, f_number, focus, Aperture::Blades { count, turn })
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch19_depth_of_field", draw)
}

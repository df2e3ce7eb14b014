//! A lens gathers light with all of its opening, and unites the light again for one distance only. A point that is nearer or
//! farther becomes a blurred disc; a formula tells its size.
//!
//! New: shape/instance.rs sample/disk.rs sample/polygon.rs camera/aperture.rs camera/lens.rs camera/thin_lens.rs
//! New: render/glints.rs

mod blur_plot;
mod bokeh;
mod lens_samples;
mod letters;
#[path = "../../examples/many_balls.rs"]
#[expect(dead_code, reason = "its `main` is the example's")]
mod many_balls; // the scene stands in the example alone
pub mod tea_table;

use crate::kit::chapter;
use crate::kit::sheet::sheet;
use crate::kit::stage::{Drawn, Stage};
use clap::Args;
use glam::Vec3;
use raybook::camera::aperture::Aperture;
use raybook::camera::lens::LensError;
use raybook::camera::pinhole::Pinhole;
use raybook::camera::thin_lens::ThinLens;
use raybook::image::tone;
use raybook::math::interval::Interval;
use raybook::render::clamped::Clamped;
use raybook::render::film::Film;
use raybook::render::glints::add_glints;
use raybook::render::local::Local;
use raybook::render::path::Path;
use raybook::render::sampler::Sampler;
use raybook::render::shadow;
use raybook::render::whitted::Whitted;
use std::process::ExitCode;
use tea_table::{ALONG, EYE, FAR, FOCAL_LENGTH, NARROW_VIEW, POTS, VIEW, lamps, tea_table};

/// Width of the sensor, in metres.
const SENSOR: f32 = 0.036;

/// From this number of pixels on, a polygon's sides can be seen.
const TELLS: f32 = 5.0;

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    /// F-number: the focal length of 50 mm divided by the diameter of the aperture
    #[arg(long, value_name = "0.7..128", default_value = "1.4")]
    f_number: f32,
    /// Diameter of the aperture, instead of an f-number
    #[arg(long, value_name = "0.4..70 mm", conflicts_with = "f_number")]
    aperture: Option<f32>,
    /// Distance in focus; the default is the distance of the red teapot
    #[arg(long, value_name = "0.2..100 m", default_value = "1.01")]
    focus: f32,
    /// Number of aperture blades: the hole that they leave is a polygon with this number of sides
    #[arg(long, value_name = "3..32 blades", default_value = "6")]
    blades: u32,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let (scene, lamps) = (tea_table(), lamps());
    let arrives = Some(shadow::lit as _);
    let local = Local {
        samples: 1,
        arrives,
    };
    let whitted = Whitted { local, depth: 2 };
    let open = |ray: &_, distance| !scene.blocks(ray, Interval::new(0.0, distance));
    let photograph = |film: &Film, camera: &ThinLens| {
        let mut picture = film.denoised(&[], |film| {
            film.render(camera, &Sampler::Even, &whitted, &scene)
        });
        add_glints(&mut picture, film, camera, &lamps, open);
        picture
    };

    let film = stage.film_of(960, 8, 16.0 / 9.0);
    let body = Pinhole::look_at(EYE, VIEW, Vec3::Y, FOCAL_LENGTH, film.aspect())?;
    let (f_number, blades) = (knobs.f_number(), knobs.blades);
    let focus = knobs.focus;
    if stage.wants("picture") {
        let camera = through(&body, focus, f_number, blades)?;
        let far = distance(&body, FAR);
        let pixels = camera.lens.circle_of_confusion(far) / SENSOR * film.width as f32;
        let caption = format!(
            "A lens of 50 mm at f/{f_number}, focused at {focus} m. An object is the more blurred, the farther it is from this \
            distance. A lamp at {far:.0} m becomes a polygon with {blades} sides, the shape of the aperture: {pixels:.1} pixels wide \
            in this picture{}.",
            if pixels < TELLS {
                ", which is too small to show the sides"
            } else {
                ""
            }
        );
        let picture = photograph(&film, &camera);
        stage.picture("picture", &caption, &picture)?;
    }

    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    if stage.wants("samples") {
        let caption = "With few random points on the lens, there is noise where the picture is blurred, and hardly any noise \
            where it is sharp. Points that are spread evenly over the lens give less noise.";
        let figure = lens_samples::draw(&stage.tile(3, 1.6), &scene, &whitted)?;
        stage.figure("samples", caption, &figure)?;
    }

    if stage.wants("apertures") {
        let tile = stage.tile(2, 16.0 / 9.0).halved();
        let mut tiles = vec![];
        for f_number in [f32::INFINITY, 8.0, 2.8, 1.4] {
            let camera = through(&body, focus, f_number, blades)?;
            tiles.push((format!("f/{f_number}"), photograph(&tile, &camera)));
        }
        tiles[0].0 = String::from("a pin-hole: f/∞");
        let caption = format!(
            "The same focus, {focus} m, with four apertures: a larger aperture blurs more. Through a pin-hole everything is sharp, \
            and a lamp is no larger than a pixel."
        );
        stage.figure("apertures", &caption, &sheet(2, &tiles)?)?;
    }

    if stage.wants("focus_pull") {
        let tile = stage.tile(4, 1.0).halved();
        let mut tiles = vec![];
        let body = Pinhole::look_at(ALONG, NARROW_VIEW, Vec3::Y, FOCAL_LENGTH, tile.aspect())?;
        for at in POTS.into_iter().chain([FAR]) {
            let camera = through(&body, distance(&body, at), f_number, blades)?;
            let name = format!("{:.1} m", camera.lens.focus);
            tiles.push((name, photograph(&tile, &camera)));
        }
        let caption = format!(
            "A focus pull at f/{f_number}: as the film moves towards the lens, the plane in focus moves away from the lens, from teapot to teapot, and to the lamps far behind."
        );
        stage.figure("focus_pull", &caption, &sheet(6, &tiles)?)?;
    }

    if stage.wants("bokeh") {
        let caption =
            "Lamps out of focus, seen through a round hole and through 5, 6 and 8 blades.";
        stage.figure(
            "bokeh",
            caption,
            &bokeh::draw(&stage.tile(4, 1.0).halved())?,
        )?;
    }

    if stage.wants("balls") {
        draw_balls(stage)?;
    }
    if !stage.wants("blur") {
        return Ok(());
    }
    let caption = format!(
        "The circle of confusion of a 50 mm lens that is focused at {focus} m: the disc on the sensor that a point becomes. A disc \
        smaller than a pixel looks sharp: the shaded ranges are the depth of field."
    );
    stage.diagram("blur", &caption, &blur_plot::plot(focus)?)
}

/// Draws the example's hundreds of balls.
fn draw_balls(stage: &Stage) -> Drawn {
    let film = stage.film_of(440, 10, 16.0 / 9.0);
    let (scene, camera) = many_balls::balls(film.aspect())?;
    let path = Clamped {
        integrator: Path {
            depth: 6,
            ..Path::WHOLE
        },
        brightest: 3.0, // brighter samples are rare: they would be white dots
    };
    let radiance = film.denoised(&[], |film| {
        film.render(&camera, &Sampler::Even, &path, &scene)
    });
    let lens = camera.lens;
    let caption = format!(
        "Hundreds of balls of plastic, paint, glass and metal under the sun and the sky, through a lens of {:.0} cm diameter that is \
        focused on the three large balls, at {:.1} m.",
        100.0 * lens.focal_length / lens.f_number,
        lens.focus
    );
    stage.developed("balls", &caption, &radiance, &radiance.map(tone::aces))
}

impl Knobs {
    /// The focal length divided by the diameter of the aperture, to two digits after the point.
    fn f_number(&self) -> f32 {
        let of_width = |millimetres: f32| (1e5 * FOCAL_LENGTH / millimetres).round() / 100.0;
        self.aperture.map_or(self.f_number, of_width)
    }
}

/// Distance from the camera to the plane in which a point lies, along the camera's axis, in metres.
fn distance(body: &Pinhole, at: Vec3) -> f32 {
    (at - body.focal_point).dot(*body.forward)
}

/// The camera with `count` blades before its lens.
fn through(body: &Pinhole, focus: f32, f_number: f32, count: u32) -> Result<ThinLens, LensError> {
    let turn = 0.0;
    ThinLens::new(body, f_number, focus, Aperture::Blades { count, turn })
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch19_depth_of_field")
}

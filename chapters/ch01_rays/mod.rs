//! A pin-hole camera turns each pixel into a ray, r(t) = o + t·d: from the focal point through the pixel's centre.
//!
//! New: threads.rs math/mod.rs math/dir3.rs math/ray.rs math/pcg.rs image/mod.rs image/rgb.rs
//! New: camera/mod.rs camera/pinhole.rs sample/pattern/sobol.rs render/mod.rs render/film.rs render/followed.rs

mod camera_diagram;
mod hole;
mod letters;
mod projection;

use crate::kit::chapter;
use crate::kit::sheet::sheet;
use crate::kit::stage::{Drawn, Stage};
use clap::Args;
use glam::{Vec3, vec3};
use raybook::camera::{
    Camera,
    pinhole::{LookAtError, Pinhole},
};
use raybook::image::{Image, rgb::Rgb};
use raybook::math::dir3::Dir3;
use raybook::render::film::Film;
use std::process::ExitCode;

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    /// Focal length: from the focal point to the image plane, which is 24 mm high
    #[arg(long, value_name = "5..500 mm", default_value = "18")]
    focal_length: f32,
    /// Field of view from bottom to top, instead of a focal length
    #[arg(long, value_name = "2..150 °", conflicts_with = "focal_length")]
    field_of_view: Option<f32>,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let film = stage.film(16.0 / 9.0);
    if stage.wants("picture") {
        stage.picture(
            "picture",
            "The direction of every pixel's ray as a colour, under lines of equal azimuth and elevation every 10°; \
             the horizon is the thickest. The angle between the lines is the same at the edges as in the middle, but the flat image plane stretches the picture at its edges.",
            &directions(&film, vec3(0.0, 0.3, 1.0), knobs.focal_length())?,
        )?;
    }
    stage.drawing("projection", projection::CAPTION, projection::draw)?;
    if stage.wants("hole") {
        let caption = "A pin-hole camera. The lines cross in the hole, so the picture on the back wall is upside down. On a wall in front of the \
            hole, at the same distance, the same lines draw it upright.";
        stage.diagram("hole", caption, &hole::draw()?)?;
    }
    if stage.wants("camera") {
        stage.diagram(
            "camera",
            "The camera of this chapter: every ray starts at the focal point and leaves through the centre of a pixel. The first object that the ray meets gives the pixel its colour.",
            &camera_diagram::draw()?,
        )?;
    }
    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    if !stage.wants("focal_lengths") {
        return Ok(());
    }
    let tile = Film {
        width: 400,
        height: 225,
        ..film
    };
    let views = [14.0_f32, 24.0, 50.0, 100.0].map(|millimetres| -> Result<_, LookAtError> {
        let degrees = 2.0 * (12.0 / millimetres).atan().to_degrees();
        let view = directions(&tile, vec3(0.0, 0.06, 1.0), millimetres / 1000.0)?;
        Ok((format!("f = {millimetres} mm: {degrees:.0}° high"), view))
    });
    let views = views.into_iter().collect::<Result<Vec<_>, _>>()?;
    let tiles: Vec<_> = views
        .iter()
        .map(|(text, view)| (text.as_str(), view.clone()))
        .collect();
    stage.figure(
        "focal_lengths",
        "The same view at four focal lengths f: the farther the image plane is from the focal point, the smaller the part of the \
         world that the camera sees.",
        &sheet(2, &tiles)?,
    )
}

impl Knobs {
    /// In metres. The image plane is 24 mm high, and half of it is seen under half of the angle.
    fn focal_length(&self) -> f32 {
        let seeing = |degrees: f32| 12.0 / (0.5 * degrees).to_radians().tan();
        self.field_of_view.map_or(self.focal_length, seeing) / 1000.0
    }
}

/// What the rays of a camera at the origin see: there is no scene, so each ray shows its direction.
fn directions(film: &Film, toward: Vec3, focal_length: f32) -> Result<Image, LookAtError> {
    let camera = Pinhole::look_at(Vec3::ZERO, toward, Vec3::Y, focal_length, film.aspect())?;
    Ok(film.sample(|place, _| {
        let d = camera.central_ray(place).direction;
        let below_horizon = if d.y < 0.0 { 0.55 } else { 1.0 };
        // From [−1, 1] to [0, 1]; squared, because the eye finds half the light much brighter than half.
        let colour = Rgb::new(d.x, d.y, d.z).map(|v| (0.5 + 0.5 * v).powi(2));
        (colour * below_horizon).lerp(Rgb::WHITE, lines(d))
    }))
}

/// How white a direction is under lines every 10° of azimuth and elevation; those every 30° are stronger.
fn lines(d: Dir3) -> f32 {
    let (elevation, azimuth) = (d.y.asin(), d.x.atan2(d.z));
    let line = |every: f32, half_width: f32| {
        let every = every.to_radians();
        let off = |angle: f32| (angle - every * (angle / every).round()).abs();
        let across = off(elevation).min(off(azimuth) * elevation.cos()) / half_width.to_radians();
        1.0 - across.min(1.0).powi(2)
    };
    let horizon = 1.0 - (elevation.to_degrees() / 0.5).abs().min(1.0).powi(4);
    (0.45 * line(10.0, 0.18))
        .max(0.9 * line(30.0, 0.25))
        .max(horizon)
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch01_rays")
}

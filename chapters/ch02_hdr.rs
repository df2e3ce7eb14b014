//! # High dynamic range
//!
//! Radiance has no upper limit, but a display has: how to choose an exposure, map what is too bright, and keep it all in a file.
//!
//! New: image/tone.rs image/file.rs image/codec.rs image/compare.rs
//! New: scene/mod.rs scene/noise.rs scene/evening.rs scene/window.rs

use glam::{Vec2, Vec3};
use raybook::camera::{Camera, pinhole::Pinhole};
use raybook::image::{Image, file, rgb::Rgb, tone};
use raybook::lab::stage::{Drawn, Stage};
use raybook::lab::{chapter, sheet::sheet, stops};
use raybook::render::film::Film;
use raybook::scene::window;
use std::process::ExitCode;

/// The exposure at which the room and the view can both be guessed, in stops.
const EXPOSURE: f32 = -2.0;

/// Draws the chapter's pictures.
pub(crate) fn draw(stage: &Stage) -> Drawn {
    let film = stage.film_of(960, 32, 16.0 / 9.0);
    let camera = Pinhole::look_at(window::EYE, window::MIDDLE, Vec3::Y, 0.024, film.aspect())?;
    let take =
        |film: &Film| film.render(|place, _| window::radiance(&camera.ray(place, Vec2::ZERO)));
    let picture = take(&film).map(|p| tone::expose(p, EXPOSURE));
    stage.picture(
        "picture",
        "An evening room, two stops under: the display clamps the sky at white and hides the far wall in black. \
         The EXR beside it still knows both.",
        &picture,
    )?;
    let kept = file::load(&stage.folder().join("picture.exr"))?;
    if kept != picture {
        return Err("the EXR does not hold the radiance that was written".into());
    }

    let small = take(&Film {
        width: 400,
        height: 225,
        samples: 2 * film.samples,
        progress: &|_| (),
        ..film
    });
    let exposed = |stops: f32| small.map(|p| tone::expose(p, stops));
    stage.figure(
        "exposures",
        "One picture of linear radiance at six exposures. Every stop halves or doubles the light, \
         and each tile has detail where the others are black or white.",
        &sheet(
            3,
            &[
                ("+3 stops", exposed(3.0)),
                ("0 stops", exposed(0.0)),
                ("−3 stops", exposed(-3.0)),
                ("−6 stops", exposed(-6.0)),
                ("−10 stops", exposed(-10.0)),
                ("−17 stops", exposed(-17.0)),
            ],
        )?,
    )?;
    let toned = |curve: fn(Rgb) -> Rgb| -> Image { exposed(EXPOSURE).map(curve) };
    stage.figure(
        "tone",
        "The same exposure three times: clamped, the sky is lost; Reinhard's curve keeps it and flattens the rest; \
         the film-like curve keeps contrast in the middle and lets the brightest fade to white.",
        &sheet(3, &[
            ("clamped", toned(tone::clamp)),
            ("Reinhard", toned(tone::reinhard)),
            ("ACES-like", toned(tone::aces)),
        ])?,
    )?;
    stage.figure(
        "curves",
        "What each of the three makes of a grey: the byte over the radiance in stops.",
        &stops::curves()?,
    )?;
    stage.figure(
        "histogram",
        "How many pixels are how bright. The scene spans more than twenty stops; the band is what a PNG holds of them.",
        &stops::histogram(
            &picture,
            &[
                (-7.5, "far wall"),
                (-4.5, "room"),
                (-1.8, "floor"),
                (1.2, "sky"),
                (6.0, "glitter"),
                (13.5, "sun"),
            ],
        )?,
    )
}

fn main() -> ExitCode {
    chapter::run("ch02_hdr", draw)
}

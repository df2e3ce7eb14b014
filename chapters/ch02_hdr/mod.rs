//! Radiance has no upper limit, but a display has: how to expose, how to map what is too bright, and how to keep it all.
//!
//! New: image/tone.rs image/file.rs image/codec.rs image/compare.rs
//! New: scene/mod.rs scene/noise.rs sample/even.rs render/refine.rs

pub mod evening;
mod letters;
mod stops;
pub mod window;

use crate::kit::chapter;
use crate::kit::sheet::sheet;
use crate::kit::stage::{Drawn, Stage};
use clap::{Args, ValueEnum};
use glam::{Vec2, Vec3};
use raybook::camera::{Camera, pinhole::Pinhole};
use raybook::image::{Image, file, rgb::Rgb, tone};
use raybook::render::film::{Film, SILENT, place_in_pixel};
use std::cell::LazyCell;
use std::process::ExitCode;

/// A tone curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Curve {
    /// Cut off at white in the PNG; the EXR keeps all radiance
    Clamp,
    /// Reinhard's curve, L/(1 + L) for the luminance L
    Reinhard,
    /// A film-like curve, an approximation of ACES
    Aces,
}

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    /// Exposure of the main picture: one stop more doubles the brightness
    #[arg(long, value_name = "-20..10 stops", default_value = "-2")]
    exposure: f32,
    /// Tone curve: how radiance above white is displayed
    #[arg(long, value_enum, default_value = "clamp")]
    curve: Curve,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let film = stage.film_of(960, 24, 16.0 / 9.0);
    let camera = Pinhole::look_at(window::EYE, window::MIDDLE, Vec3::Y, 0.024, film.aspect())?;
    let radiance =
        LazyCell::new(|| film.refine(|place, _| window::radiance(&camera.central_ray(place))));
    let exposure = knobs.exposure;
    let room = format!("An evening room at {exposure} stops.").replace('-', "−");
    let (ends, curve) = knobs.curve.toned();
    let picture = LazyCell::new(|| radiance.map(|p| curve(tone::expose(p, exposure))));
    if stage.wants("picture") {
        let see = |place| {
            let radiance = window::radiance(&camera.central_ray(place));
            curve(tone::expose(radiance, exposure))
        };
        let shown = without_stairs(&film, &picture, see);
        stage.developed("picture", &format!("{room} {ends}"), &picture, &shown)?;
        if !file::load(&stage.folder().join("picture.exr"))?.same_bits(&picture) {
            return Err("picture.exr does not hold the radiance that was written".into());
        }
    }

    let small = LazyCell::new(|| third(&radiance));
    let exposed = |stops: f32| small.map(|p| tone::expose(p, stops));
    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    if stage.wants("exposures") {
        let tiles = [
            ("+3 stops", exposed(3.0)),
            ("0 stops", exposed(0.0)),
            ("−3 stops", exposed(-3.0)),
            ("−6 stops", exposed(-6.0)),
            ("−10 stops", exposed(-10.0)),
            ("−17 stops", exposed(-17.0)),
        ];
        stage.figure(
        "exposures",
        "The same radiance at six exposures. Each exposure shows details that the others clamp to white or lose in black.",
        &sheet(3, &tiles)?,
    )?;
    }

    if stage.wants("edges") {
        let near = Film {
            width: 90,
            height: 60,
            ..film
        };
        let close = Pinhole::look_at(window::EYE, window::MIDDLE, Vec3::Y, 0.07, near.aspect())?;
        let seen = |place| window::radiance(&close.central_ray(place));
        let shown = |radiance| tone::clamp(tone::expose(radiance, exposure));
        let tiles = [
            (
                "clamped after the mean",
                near.evenly(|place, _| seen(place)).map(shown),
            ),
            (
                "clamped before the mean",
                near.evenly(|place, _| shown(seen(place))),
            ),
        ];
        let tiles = tiles.map(|(name, tile)| (name, tile.enlarged(5)));
        stage.figure(
        "edges",
        "The window's bars before the bright sky, pixel by pixel. Left: the average of the light is right, and shows stairs. \
        Right: the average of the displayed values is wrong, and looks smooth.",
        &sheet(2, &tiles)?,
    )?;
    }

    if stage.wants("tone") {
        let toned = |name, curve: fn(Rgb) -> Rgb| (name, exposed(exposure).map(curve));
        let tiles = [
            toned("clamped", tone::clamp),
            toned("Reinhard", tone::reinhard),
            toned("ACES-like", tone::aces),
        ];
        stage.figure(
        "tone",
        "One exposure, three ways to end at white: clamping loses the sky; Reinhard's curve keeps the sky, but looks pale; the film-like curve keeps the contrast and fades to white.",
        &sheet(3, &tiles)?,
    )?;
    }

    if stage.wants("curves") {
        stage.diagram(
            "curves",
            "Three tone curves for a grey: the byte in the PNG file against the radiance in stops.",
            &stops::curves()?,
        )?;
    }
    if !stage.wants("histogram") {
        return Ok(());
    }
    let marks = [
        (-5.5, "far wall"),
        (-2.5, "room"),
        (3.2, "sky"),
        (15.5, "sun"),
    ];
    let marks = marks.map(|(stops, name)| (stops + exposure, name));
    stage.diagram(
        "histogram",
        "The number of pixels at each brightness, over more than twenty stops. A PNG at 0 stops holds only the shaded band.",
        &stops::histogram(&picture, &marks)?,
    )
}

/// The picture as a display shows it. At an edge of what is brighter than white, a pixel is the mean of what the display shows of
/// its samples: what the display shows of their mean would be a stair.
fn without_stairs(film: &Film, picture: &Image, see: impl Fn(Vec2) -> Rgb + Sync) -> Image {
    let few = Film {
        samples: 8,
        progress: SILENT,
        ..*film
    };
    let last = [film.width - 1, film.height - 1];
    few.render_pixels(|x, y, rng| {
        let around = [(0, 1), (1, 0), (1, 1), (1, 2), (2, 1)];
        let around = around.map(|(i, j)| {
            let (x, y) = ((x + i).saturating_sub(1), (y + j).saturating_sub(1));
            picture.at(x.min(last[0]), y.min(last[1])).luminance()
        });
        let (is_bright, is_dark) = (|&v: &f32| v > 1.0, |&v: &f32| v < 0.5);
        if !(around.iter().any(is_bright) && around.iter().any(is_dark)) {
            return picture.at(x, y);
        }
        let points = (0..few.samples).map(place_in_pixel(few.samples, rng));
        let sum: Rgb = points
            .map(|point| tone::clamp(see(few.place([x, y], point))))
            .sum();
        sum / few.samples as f32
    })
}

/// A picture a third as wide and high, so that three side by side are as wide as the main picture: each pixel is the mean of nine.
fn third(picture: &Image) -> Image {
    Image::from_fn(picture.width() / 3, picture.height() / 3, |x, y| {
        let nine = (0..9).map(|i| picture.at(3 * x + i % 3, 3 * y + i / 3));
        nine.sum::<Rgb>() / 9.0
    })
}

impl Curve {
    /// What the curve does to the brightest radiance, in words, and the curve.
    fn toned(self) -> (&'static str, fn(Rgb) -> Rgb) {
        match self {
            Self::Clamp => (
                "The display clamps the sky at white, each sample for itself, which leaves no stairs at the window. The EXR file keeps the radiance of the sky.",
                |p| p,
            ),
            Self::Reinhard => (
                "Reinhard's curve maps every luminance to less than white. The EXR file holds the mapped values.",
                tone::reinhard,
            ),
            Self::Aces => (
                "The ACES-like curve changes every radiance, and reaches white at a radiance of 7.2. The EXR file holds the mapped \
            values.",
                tone::aces,
            ),
        }
    }
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch02_hdr")
}

//! What is kept of the picture of a hand-in's answers: theirs, the right one and the difference, in one small PNG.

use crate::check::Report;
use crate::picture::progressive::MISSING;
use crate::picture::triple::Triple;
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use raybook::image::rgb::Rgb;
use raybook::image::{Image, file};

/// The largest PNG, in bytes. Three pictures of an exercise take 1 to 9 kB; three of noise would take 30, and are drawn coarser.
const LARGEST: usize = 12 << 10;

/// Every pixel is drawn, or every second one in both directions, or fewer, until the PNG is small enough.
const STEPS: [usize; 4] = [1, 2, 4, 8];

/// White space between the pictures, in pixels.
const GAP: usize = 4;

/// The first wrong picture of a report, if there is one with an answer in it: its text, and the PNG in base 64.
pub fn first_wrong(report: &Report) -> Option<[String; 2]> {
    let wrong = |picture: &&Triple| {
        let pixels = picture.yours.pixels();
        picture.score.wrong() > 0 && pixels.iter().any(|&pixel| pixel != MISSING)
    };
    let picture = report.pictures.iter().find(wrong)?;
    let pngs = STEPS
        .iter()
        .map(|&step| file::to_png(&strip(picture, step)));
    let png = pngs.flatten().find(|png| png.len() <= LARGEST)?;
    let alt = format!(
        "{}: yours, the right one, and the difference; {} of {} pixels are wrong",
        picture.alt,
        picture.score.wrong(),
        picture.score.of
    );
    Some([alt, BASE64_STANDARD.encode(png)])
}

/// The three pictures in a row, every `step`th pixel of them.
fn strip(picture: &Triple, step: usize) -> Image {
    let three = [&picture.yours, &picture.golden, &picture.difference];
    let [width, height] =
        [picture.golden.width(), picture.golden.height()].map(|side| side.div_ceil(step));
    let across = width + GAP;
    Image::from_fn(3 * across - GAP, height, |x, y| {
        let (which, x) = (x / across, x % across);
        if x < width {
            three[which].at(x * step, y * step)
        } else {
            Rgb::WHITE
        }
    })
}

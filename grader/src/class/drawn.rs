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

#[cfg(test)]
mod tests {
    use super::{LARGEST, MISSING, first_wrong};
    use crate::check::Report;
    use crate::picture::score::Score;
    use crate::picture::triple::Triple;
    use base64::Engine;
    use base64::prelude::BASE64_STANDARD;
    use rand::RngExt;
    use raybook::image::{Image, rgb::Rgb};
    use raybook::math::pcg;

    fn report(right: usize, yours: Image) -> Report {
        let golden = Image::from_fn(96, 54, |_, _| Rgb::WHITE);
        let score = Score {
            right,
            of: 96 * 54,
            undecided: 0,
            error: 0.1,
        };
        Report {
            exercise: "sphere_hit",
            cases: Vec::new(),
            smallest: None,
            diagnosis: None,
            pictures: vec![Triple {
                name: "picture",
                difference: yours.clone(),
                yours,
                golden,
                first_bad: None,
                score,
                alt: "A sphere",
            }],
            stopped: None,
        }
    }

    #[test]
    fn a_picture_of_noise_is_drawn_coarser_until_it_is_small() {
        let flat = Image::from_fn(96, 54, |x, _| if x < 48 { Rgb::WHITE } else { Rgb::BLACK });
        let mut rng = pcg::stream(1, 0);
        let noise = Image::from_fn(96, 54, |_, _| {
            Rgb::new(rng.random(), rng.random(), rng.random())
        });
        for (yours, width) in [(flat, 3 * 96 + 8), (noise, 3 * 48 + 8)] {
            let [alt, png] = first_wrong(&report(96 * 54 - 1, yours)).expect("a pixel is wrong");
            assert!(
                alt.starts_with("A sphere: ") && alt.contains("1 of 5184"),
                "{alt}"
            );
            let png = BASE64_STANDARD.decode(png).expect("base 64");
            assert!(png.len() <= LARGEST, "{} bytes", png.len());
            // A PNG begins with its name, and then its width.
            let wide: [u8; 4] = png[16..20].try_into().expect("four bytes");
            assert_eq!(
                u32::from_be_bytes(wide),
                width,
                "three pictures and two gaps"
            );
        }
    }

    #[test]
    fn a_picture_that_is_right_or_has_no_answer_is_not_kept() {
        let white = Image::from_fn(96, 54, |_, _| Rgb::WHITE);
        assert_eq!(first_wrong(&report(96 * 54, white)), None);
        let empty = Image::from_fn(96, 54, |_, _| MISSING);
        assert_eq!(first_wrong(&report(0, empty)), None);
    }
}

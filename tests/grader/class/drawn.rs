//! The picture that is kept of a hand-in's answers.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use rand::RngExt;
use raybook::image::{Image, rgb::Rgb};
use raybook::math::pcg;
use raybook_grader::check::Report;
use raybook_grader::class::drawn::first_wrong;
use raybook_grader::inside::picture::MISSING;
use raybook_grader::picture::score::Score;
use raybook_grader::picture::triple::Triple;

/// The largest PNG that is kept, in bytes.
const LARGEST: usize = 12 << 10;

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

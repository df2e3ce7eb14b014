//! Chapter 2: `expose`, `tone_map`, `encode_srgb`.

use crate::{Verdict, judge, sample};
use raybook::image::rgb::Rgb;
use raybook::math::pcg::Pcg;

raybook_workbook::ch02_hdr!(graded);

/// A colour whose channels are up to `most`.
fn colour(rng: &mut Pcg, most: f32) -> Rgb {
    Rgb::new(
        sample::number(rng, 0.05, most),
        sample::number(rng, 0.05, most),
        sample::number(rng, 0.05, most),
    )
}

fn channels(golden: Rgb, got: Rgb) -> Verdict {
    for (name, golden, got) in [
        ("red", golden.r, got.r),
        ("green", golden.g, got.g),
        ("blue", golden.b, got.b),
    ] {
        judge::number_within(
            name,
            "",
            golden,
            got,
            judge::RELATIVE * golden.abs().max(0.01),
        )?;
    }
    Ok(())
}

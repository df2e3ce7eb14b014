//! Chapter 12: `phong`, `blinn_phong`, `point_light`.

mod highlight;

use crate::{Verdict, judge};
use raybook::image::rgb::Rgb;

raybook_workbook::ch12_phong!(graded);

/// Each channel, relative to its size or to `least`.
fn channels(golden: Rgb, got: Rgb, least: f32) -> Verdict {
    let names = ["red", "green", "blue"];
    for ((name, golden), got) in names.iter().zip(golden.channels()).zip(got.channels()) {
        let tolerance = judge::RELATIVE * golden.abs().max(least);
        judge::number_within(name, "", golden, got, tolerance)?;
    }
    Ok(())
}

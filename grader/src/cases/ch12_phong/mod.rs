//! Chapter 12: `phong`, `blinn_phong`, `point_light`.

mod blinn_phong;
mod highlight;
mod phong;
mod point_light;

use crate::examine::Examiner;
use crate::{Verdict, judge};
use raybook::image::rgb::Rgb;
use raybook_workbook::exercises::ch12_phong::{
    BlinnPhongExercise, PhongExercise, PointLightExercise,
};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&PhongExercise, &BlinnPhongExercise, &PointLightExercise];

/// Each channel, relative to its size or to `least`.
fn channels(golden: Rgb, got: Rgb, least: f32) -> Verdict {
    let names = ["red", "green", "blue"];
    for ((name, golden), got) in names.iter().zip(golden.channels()).zip(got.channels()) {
        let tolerance = judge::RELATIVE * golden.abs().max(least);
        judge::number_within(name, "", golden, got, tolerance)?;
    }
    Ok(())
}

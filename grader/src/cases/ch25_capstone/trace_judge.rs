//! What is said of a radiance that is wrong.

use crate::{Verdict, judge};
use raybook::image::rgb::Rgb;
use raybook::scene::description::{Form, Matter};
use raybook_workbook::exercises::ch25_capstone::Trace;
use std::ptr;

/// A channel may differ by this fraction of its value …
///
/// Measured over 2070 cases by six right methods: leaving out what counts for less than 1/512 is worst, and 3.6 times
/// nearer than this; starts 1 mm off the surface are 5 times nearer, double precision by other formulas 300 times.
const RELATIVE: f32 = 0.01;

/// … and this much.
const ABSOLUTE: f32 = 0.005;

/// Whether a radiance is right.
///
/// # Errors
/// If a channel is too far off; then also what the ray meets first.
pub fn judge(q: &Trace, golden: &Rgb, got: &Rgb) -> Verdict {
    let tolerance = |golden: f32| ABSOLUTE + RELATIVE * golden.abs();
    let channels = || golden.channels().into_iter().zip(got.channels());
    if channels().all(|(golden, got)| (golden - got).abs() <= tolerance(golden)) {
        return Ok(());
    }
    let ratio = got.luminance() / golden.luminance();
    let same_colour = channels().all(|(golden, got)| (ratio * golden - got).abs() <= 0.02 * got);
    let why = if *got == Rgb::BLACK {
        "your answer is black, and there is light".to_owned()
    } else if *golden == Rgb::BLACK {
        "everything should be black here".to_owned()
    } else if lit_by_nothing(q, got) {
        "your answer is the ambient light alone: no lamp adds anything. Does the normal point away from the viewer, or does the shadow ray meet the surface that it starts from".to_owned()
    } else if same_colour && ratio > 0.0 {
        format!("the colour is right, but {ratio:.3} times as bright as it should be")
    } else {
        let wrong = ["red", "green", "blue"].into_iter().zip(channels());
        let whys = wrong.filter_map(|(name, (golden, got))| {
            judge::number_within(name, "", golden, got, tolerance(golden)).err()
        });
        whys.collect::<Vec<_>>().join(", ")
    };
    Err(format!("{why}; {}", first(q)))
}

/// Whether an answer is what Phong's surface shows without a lamp.
fn lit_by_nothing(q: &Trace, got: &Rgb) -> bool {
    let nearest = q.scene.nearest(&q.ray);
    nearest.is_some_and(|(object, _)| match &object.matter {
        Matter::Phong(phong) => {
            let ambient = (phong.ambient * q.scene.ambient).channels();
            let pairs = ambient.into_iter().zip(got.channels());
            pairs.into_iter().all(|(a, b)| (a - b).abs() <= 1e-3 * a)
        }
        _ => false,
    })
}

/// What the ray meets first.
fn first(q: &Trace) -> String {
    if q.depth == 0 {
        return "no surface may be met at depth 0".to_owned();
    }
    let Some((object, hit)) = q.scene.nearest(&q.ray) else {
        return "the ray meets nothing and sees the backdrop".to_owned();
    };
    let before = q.scene.objects.iter().take_while(|o| !ptr::eq(*o, object));
    let i = before.count();
    let form = match object.form {
        Form::Sphere(_) => "sphere",
        Form::Plane(_) => "plane",
        Form::Triangle(_) => "triangle",
    };
    let matter = match object.matter {
        Matter::Phong(_) => "of Phong's material",
        Matter::Mirror(_) => "that is a mirror",
        Matter::Glass(_) => "of glass",
    };
    format!(
        "the ray first meets objects[{i}], a {form} {matter}, at t = {:.3}",
        hit.t
    )
}

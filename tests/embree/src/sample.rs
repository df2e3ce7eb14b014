//! The recorded sample: a few questions of every kind, with Embree's answers.

use crate::embree::{Embree, Mode};
use crate::questions::{named, shapes};
use crate::rays::{KINDS, Kind, rays};
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook_common::oracle::judge::{Answer, Verdict, judge};
use raybook_common::oracle::recording::{line, shape};
use raybook_common::oracle::target::Target;

/// The files of `golden/embree`, without their ending.
pub const FILES: [&str; 5] = ["triangle", "sphere", "plane", "cuboid", "mesh"];

/// Rays of each kind at each shape.
const EACH: usize = 5;

/// One ray of this number in a row is recorded: neighbours are too much alike.
const STEP: usize = 11;

/// The file as it must be: comments, named questions, drawn questions, each with the answer.
///
/// # Errors
/// If Embree fails, or raybook answers otherwise.
pub fn recording(file: &str) -> Result<String, String> {
    // The instructions that every x86-64 processor has; `rcpps`, with which Embree begins a division, still differs in its
    // last digits from one maker to another.
    let embree = Embree::of_sse2()?;
    let mut text = format!(
        "# What Embree {} answers ({file}), limited to SSE2: its divisions end a digit short of exact.\n\
         # Renew: RAYBOOK_BLESS=1 cargo test --release -p raybook-embree\n\
         # name  origin  direction  from to  {}  = t triangle b1 b2 normal, or = none\n",
        embree.version(),
        match file {
            "triangle" => "triangle corner corner corner",
            "sphere" => "sphere centre radius",
            "plane" => "plane point normal",
            "cuboid" => "cuboid least-corner greatest-corner",
            _ => "mesh kind number-of-triangles",
        }
    );
    for (number, words) in (0..).zip(shapes(file)) {
        let target = shape(words)?;
        let scene = embree.scene(&target.solid, Mode::Robust)?;
        let mut questions = named(file, number);
        let mut rng = pcg::stream(11, number);
        for kind in KINDS {
            let drawn = rays(kind, &target, EACH * STEP, &mut rng);
            for (i, (ray, within)) in (1..).zip(drawn.into_iter().step_by(STEP)) {
                let name = format!("{}_{i}", kind.name());
                questions.push((name, readable(kind, ray), within));
            }
        }
        for (name, ray, within) in questions {
            let answer = scene.closest(&ray, within);
            if is_certain(&target, &ray, within, answer)? {
                text.push_str(&line(&name, &ray, within, &target, answer));
                text.push('\n');
            }
        }
    }
    Ok(text)
}

/// Whether the answer is beyond doubt, and the ray can be written down.
fn is_certain(
    target: &Target,
    ray: &Ray,
    within: Interval,
    answer: Option<Answer>,
) -> Result<bool, String> {
    // Read back, a direction is normalised again: it must not change by that.
    let readable = Dir3::new(*ray.direction) == Some(ray.direction);
    match judge(target, ray, within, [target.ask(ray, within), answer]) {
        Verdict::BothMiss => Ok(readable),
        Verdict::Same { sharp, .. } => Ok(readable && sharp),
        Verdict::Excused(_) => Ok(false),
        Verdict::Wrong(why) => Err(why),
    }
}

/// The ray from an origin with two digits after the point, where its kind does not depend on the exact place.
fn readable(kind: Kind, ray: Ray) -> Ray {
    let origin = match kind {
        Kind::Coherent | Kind::Random | Kind::AxisParallel => (ray.origin * 100.0).round() / 100.0,
        Kind::Grazing | Kind::FromSurface => ray.origin,
    };
    Ray { origin, ..ray }
}

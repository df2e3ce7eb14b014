//! The recorded sample: a few questions of every kind, with Embree's answers.

use crate::embree::{Embree, Mode, Oracle};
use crate::oracle::judge::{Verdict, judge};
use crate::oracle::recording::Recorded;
use crate::oracle::target::Target;
use crate::rays::{KINDS, Kind, rays};
use embree3::{Error, Isa};
use glam::{Vec3, vec3};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::shape::sphere::Sphere;

/// The files of `golden/embree`, without their ending.
pub const FILES: [&str; 5] = ["triangle", "sphere", "plane", "cuboid", "mesh"];

/// Rays of each kind at each shape.
const EACH: usize = 5;

/// Of so many rays in a row one is recorded: neighbours are too much alike.
const STEP: usize = 11;

/// The file as it must be: comments, named questions, drawn questions, each with the answer.
///
/// # Errors
/// If Embree fails.
pub fn recording(file: &str) -> Result<String, Error> {
    // The instructions that every x86-64 processor has; `rcpps`, with which Embree begins a division, still differs in its
    // last digits from one maker to another.
    let embree = Embree::with(Some(Isa::Sse2))?;
    let mut text = format!(
        "# What Embree {} answers ({file}), limited to SSE2: its divisions end a digit short of exact.\n\
         # Renew: RAYBOOK_BLESS=1 cargo test --release -p raybook-embree\n\
         # name  origin  direction  from to  {}  = t triangle b1 b2 normal, or = none\n",
        embree.version()?,
        match file {
            "triangle" => "triangle corner corner corner",
            "sphere" => "sphere centre radius",
            "plane" => "plane point normal",
            "cuboid" => "cuboid least-corner greatest-corner",
            _ => "mesh kind number-of-triangles",
        }
    );
    for (number, target) in (0..).zip(targets(file)) {
        let scene = embree.scene(&target().solid, Mode::Robust)?;
        let mut add = |name: String, ray: Ray, within: Interval| {
            if let Some(recorded) = record(&scene, name, ray, within, target()) {
                text.push_str(&recorded.line());
                text.push('\n');
            }
        };
        for (name, ray, within) in named(file, number) {
            add(name.to_owned(), ray, within);
        }
        let mut rng = pcg::stream(11, number);
        for kind in KINDS {
            let spread = rays(kind, &target(), EACH * STEP, &mut rng);
            let spread = spread.into_iter().step_by(STEP);
            for (i, (ray, within)) in (1..).zip(spread) {
                add(format!("{}_{i}", kind.name()), readable(kind, ray), within);
            }
        }
    }
    Ok(text)
}

/// The question with its answer, if the answer is beyond doubt and the ray can be written down.
fn record(
    scene: &Oracle,
    name: String,
    ray: Ray,
    within: Interval,
    target: Target,
) -> Option<Recorded> {
    // Read back, a direction is normalised again: it must not change by that.
    if Dir3::new(*ray.direction)? != ray.direction {
        return None;
    }
    let answer = scene.closest(&ray, within);
    let certain = match judge(&target, &ray, within, [target.ask(&ray, within), answer]) {
        Verdict::BothMiss => true,
        Verdict::Same { sharp, .. } => sharp,
        Verdict::Excused(_) => false,
        // It must fail the tests: the recording cannot be made.
        Verdict::Wrong(why) => panic!("{name}: {why}"),
    };
    certain.then_some(Recorded {
        name,
        ray,
        within,
        target,
        answer,
    })
}

/// The ray from an origin with two digits after the point, where its kind does not depend on the exact place.
fn readable(kind: Kind, ray: Ray) -> Ray {
    let origin = match kind {
        Kind::Coherent | Kind::Random | Kind::AxisParallel => (ray.origin * 100.0).round() / 100.0,
        Kind::Grazing | Kind::FromSurface => ray.origin,
    };
    Ray { origin, ..ray }
}

/// The shapes of a file.
fn targets(file: &str) -> Vec<Box<dyn Fn() -> Target>> {
    fn boxed(target: impl Fn() -> Target + 'static) -> Box<dyn Fn() -> Target> {
        Box::new(target)
    }
    const FINITE: &str = "these numbers are finite";
    let sphere = |x, y, z, r| boxed(move || Target::sphere(Sphere::new(vec3(x, y, z), r)));
    let triangle = |p: [Vec3; 3]| boxed(move || Target::triangle(p).expect(FINITE));
    let plane =
        |p: Vec3, n: Vec3| boxed(move || Target::plane(p, Dir3::new_or(n, Dir3::Y)).expect(FINITE));
    let cuboid = |a: Vec3, b: Vec3| boxed(move || Target::cuboid(Aabb::of([a, b])).expect(FINITE));
    let mesh = |kind: &'static str, n| {
        boxed(move || Target::mesh(kind, n).expect("one of the kinds of meshes"))
    };
    match file {
        "triangle" => vec![
            triangle([Vec3::ZERO, vec3(2.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0)]),
            triangle([
                vec3(1.0, 2.0, -3.0),
                vec3(-2.0, 0.5, 1.0),
                vec3(0.25, 1.5, 4.0),
            ]),
            triangle([
                vec3(99.0, 0.0, 100.0),
                vec3(100.0, 1.0, 101.0),
                vec3(101.0, 3.0, 99.0),
            ]),
            triangle([Vec3::ZERO, vec3(5.0, 5.0, 0.0), vec3(5.0, 5.1, 0.1)]),
        ],
        "sphere" => vec![
            sphere(0.0, 0.0, 0.0, 1.0),
            sphere(1.0, -2.0, 3.0, 0.5),
            sphere(0.0, -100.0, 0.0, 99.0),
            sphere(0.25, 0.5, 0.0, 0.01),
        ],
        "plane" => vec![
            plane(Vec3::ZERO, Vec3::Y),
            plane(vec3(0.0, -0.5, 0.0), Vec3::Y),
            plane(vec3(0.5, 0.0, 0.25), vec3(3.0, 0.0, 4.0)),
            plane(Vec3::ZERO, vec3(1.0, -1.0, 1.0)),
        ],
        "cuboid" => vec![
            cuboid(Vec3::NEG_ONE, Vec3::ONE),
            cuboid(vec3(0.0, 1.0, 2.0), vec3(0.5, 4.0, 2.25)),
            cuboid(vec3(-10.0, -0.01, -10.0), vec3(10.0, 0.0, 10.0)),
        ],
        _ => vec![
            mesh("soup", 50),
            mesh("ball", 192),
            mesh("terrain", 128),
            mesh("crate", 48),
            mesh("slivers", 40),
        ],
    }
}

/// Questions about a file's first shape that deserve a name; all could be solved by hand.
fn named(file: &str, number: u64) -> Vec<(&'static str, Ray, Interval)> {
    // −Dir3::Z would be written −0 −0 −1.
    let forward = Dir3::new_or(Vec3::NEG_Z, -Dir3::Z);
    let at = |x, y, z| Ray::new(vec3(x, y, z), forward);
    let up = |x, y, z| Ray::new(vec3(x, y, z), Dir3::Y);
    let (all, between) = (Interval::AHEAD, Interval::new);
    match (file, number) {
        ("triangle", 0) => vec![
            ("front", at(0.5, 0.5, 1.0), all),
            ("back", Ray::new(vec3(0.5, 0.5, -1.0), Dir3::Z), all),
            ("behind", at(0.5, 0.5, -1.0), all),
            ("beside", at(1.5, 0.75, 1.0), all),
            ("in_its_plane", up(0.5, -1.0, 0.5), all),
            ("ends_before", at(0.5, 0.5, 1.0), between(0.0, 0.75)),
            (
                "begins_after",
                at(0.5, 0.5, 1.0),
                between(1.25, f32::INFINITY),
            ),
        ],
        ("sphere", 0) => vec![
            ("front", at(0.0, 0.0, 3.0), all),
            ("off_center", at(0.6, 0.0, 3.0), all),
            ("from_inside", at(0.0, 0.0, 0.5), all),
            ("behind", at(0.0, 0.0, -3.0), all),
            ("beside", at(1.5, 0.0, 3.0), all),
            ("ends_before", at(0.0, 0.0, 3.0), between(0.0, 1.5)),
            (
                "begins_inside",
                at(0.0, 0.0, 3.0),
                between(2.5, f32::INFINITY),
            ),
            (
                "begins_after",
                at(0.0, 0.0, 3.0),
                between(4.5, f32::INFINITY),
            ),
        ],
        ("plane", 0) => vec![
            ("from_below", up(0.25, -1.0, 0.5), all),
            ("away", up(0.25, 1.0, 0.5), all),
            ("along", at(0.25, 1.0, 0.5), all),
            ("ends_before", up(0.25, -1.0, 0.5), between(0.0, 0.5)),
        ],
        ("cuboid", 0) => vec![
            ("front", at(0.25, 0.5, 3.0), all),
            ("from_inside", at(0.25, 0.5, 0.5), all),
            ("behind", at(0.25, 0.5, -3.0), all),
            ("beside", at(1.25, 0.5, 3.0), all),
            (
                "begins_inside",
                at(0.25, 0.5, 3.0),
                between(2.5, f32::INFINITY),
            ),
        ],
        _ => vec![],
    }
}

//! The shapes of the recorded sample, and the questions about them that deserve a name.

use glam::{Vec3, vec3};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};

/// The shapes of a file, in words.
pub fn shapes(file: &str) -> &'static [&'static str] {
    match file {
        "triangle" => &[
            "triangle 0 0 0 2 0 0 0 1 0",
            "triangle 1 2 -3 -2 0.5 1 0.25 1.5 4",
            "triangle 99 0 100 100 1 101 101 3 99",
            "triangle 0 0 0 5 5 0 5 5.1 0.1",
        ],
        "sphere" => &[
            "sphere 0 0 0 1",
            "sphere 1 -2 3 0.5",
            "sphere 0 -100 0 99",
            "sphere 0.25 0.5 0 0.01",
        ],
        "plane" => &[
            "plane 0 0 0 0 1 0",
            "plane 0 -0.5 0 0 1 0",
            "plane 0.5 0 0.25 0.6 0 0.8",
            "plane 0 0 0 0.57735026 -0.57735026 0.57735026",
        ],
        "cuboid" => &[
            "cuboid -1 -1 -1 1 1 1",
            "cuboid 0 1 2 0.5 4 2.25",
            "cuboid -10 -0.01 -10 10 0 10",
        ],
        _ => &[
            "mesh soup 50",
            "mesh ball 192",
            "mesh terrain 128",
            "mesh crate 48",
            "mesh slivers 40",
        ],
    }
}

/// Questions about a file's first shape that deserve a name; all could be solved by hand.
pub fn named(file: &str, number: u64) -> Vec<(String, Ray, Interval)> {
    // −Dir3::Z would be written −0 −0 −1.
    let forward = Dir3::new_or(Vec3::NEG_Z, -Dir3::Z);
    let at = |x, y, z| Ray::new(vec3(x, y, z), forward);
    let up = |x, y, z| Ray::new(vec3(x, y, z), Dir3::Y);
    let (all, between) = (Interval::AHEAD, Interval::new);
    let named = match (file, number) {
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
    };
    let owned = |(name, ray, within): (&str, Ray, Interval)| (name.to_owned(), ray, within);
    named.into_iter().map(owned).collect()
}

//! A small sphere at growing distance, as rounding leaves it: an experiment for the telescope.

use crate::kit::palette;
use crate::kit::sheet::{Sheet, sheet};
use glam::{Vec2, Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::render::film::Film;
use raybook::shape::{Shape, sphere::Sphere};

/// How far away the rays start, in metres, and what the caption calls it.
const DISTANCES: [(f32, &str); 5] = [
    (1e2, "100 m"),
    (3e2, "300 m"),
    (1e3, "1 km"),
    (1e5, "100 km"),
    (1e7, "10 000 km"),
];

/// Three rows of tiles of the film's size, one column per distance: the schoolbook formula and [`Sphere::hit`] with rays along z, and
/// [`Sphere::hit`] with rays in a slanting direction. The rays are parallel, so that the sphere keeps its size.
///
/// # Errors
/// If a caption cannot be drawn.
pub(super) fn figure(film: Film, radius: f32) -> Sheet {
    let slanting = Dir3::new_or(vec3(-0.61, -0.34, -0.71), Dir3::Z);
    let rows: [(&str, Dir3, Normal); 3] = [
        ("schoolbook", -Dir3::Z, schoolbook),
        ("ours", -Dir3::Z, ours),
        ("ours, slanting", slanting, ours),
    ];
    let mut captions = Vec::new();
    let mut tiles = Vec::new();
    for (name, direction, normal) in rows {
        for (distance, far) in DISTANCES {
            captions.push(format!("{name}, {far}"));
            tiles.push(film.refine(|place, _| {
                let ray = ray(2.4 * radius * (place - 0.5), direction, distance);
                normal(&ray, radius).map_or(Rgb::gray(0.8), palette::direction)
            }));
        }
    }
    let captions = captions.iter().map(String::as_str);
    sheet(DISTANCES.len(), &captions.zip(tiles).collect::<Vec<_>>())
}

/// A method that finds the normal where a ray meets the sphere of a radius around the origin.
type Normal = fn(&Ray, f32) -> Option<Vec3>;

/// −b/2 − √(b² − 4c)/2 with b = 2 o·d and c = o·o − r², all in `f32`, and the normal at o + t·d.
fn schoolbook(ray: &Ray, radius: f32) -> Option<Vec3> {
    let b = 2.0 * ray.origin.dot(*ray.direction);
    let c = ray.origin.length_squared() - radius * radius;
    let t = 0.5 * (-b - (b * b - 4.0 * c).sqrt());
    // The root of a negative number is NaN, and NaN is not ahead.
    let ahead = Interval::AHEAD.contains(t);
    ahead.then(|| ray.at(t).normalize_or_zero())
}

/// The normal by the method of the course, [`Sphere::hit`].
fn ours(ray: &Ray, radius: f32) -> Option<Vec3> {
    let sphere = Sphere::new(Vec3::ZERO, radius);
    let hit = sphere.hit(ray, Interval::AHEAD)?;
    Some(*sphere.surface(ray, &hit).normal)
}

/// A ray through a place on the film, in metres from its middle; the film is a little larger than the sphere.
fn ray(film: Vec2, direction: Dir3, distance: f32) -> Ray {
    let right = Dir3::new_or(direction.cross(Vec3::Y), Dir3::X);
    let up = right.cross(*direction);
    let origin = film.x * *right - film.y * up - distance * *direction;
    Ray::new(origin, direction)
}
